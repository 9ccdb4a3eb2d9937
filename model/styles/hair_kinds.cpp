// The table of kinds of hair. Lengths, widths and densities are usual ones of adults.
#include "model/styles/hair_kinds.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace hairpaint::model {

namespace {

using sim::GroupSettings;

struct Measures
{
    float lengthM, densityPerM2, widthM, volumeM, stiffnessM;
};

void put(GroupSettings& settings, const Measures& measures)
{
    settings.greatestLengthM = measures.lengthM;
    settings.greatestDensityPerM2 = measures.densityPerM2;
    settings.material.widthM = measures.widthM;
    settings.physics.volumeM = measures.volumeM;
    settings.physics.stiffnessM = measures.stiffnessM;
}

/// Too short for the wind.
void putShort(GroupSettings& settings, const Measures& measures)
{
    put(settings, measures);
    settings.physics.windScale = 0.25F;
}

constexpr std::array kKinds{
    HairKind{"Scalp", QT_TRANSLATE_NOOP("HairKinds", "Hair of the head"), [](GroupSettings&) {}},
    HairKind{"Brows", QT_TRANSLATE_NOOP("HairKinds", "Brows"),
             [](GroupSettings& settings) {
                 settings.physics.body = 0.0F; // It stands alone.
                 putShort(settings, {0.012F, 1.8e6F, 70e-6F, 0.001F, 0.045F});
                 settings.material.taperM = 0.0F; // Never cut.
                 settings.hairline = {};          // All of it is edge.
             },
             true},
    HairKind{"Lashes", QT_TRANSLATE_NOOP("HairKinds", "Lashes"),
             [](GroupSettings& settings) {
                 settings.physics.body = 0.0F;
                 putShort(settings, {0.010F, 1.0e6F, 100e-6F, 0.0005F, 0.06F});
                 settings.material.taperM = 0.0F;
                 settings.hairline = {};
                 settings.material.tipAlpha = 0.8F;
             },
             true},
    HairKind{"Beard", QT_TRANSLATE_NOOP("HairKinds", "Beard"),
             [](GroupSettings& settings) {
                 putShort(settings, {0.08F, 0.8e6F, 110e-6F, 0.004F, 0.06F});
                 settings.hairline.baby = 0.0F;
                 settings.hairline.softenM = 0.0025F; // A moustache is a strip of 15 mm, and dense up to the lip.
             }},
    HairKind{"", QT_TRANSLATE_NOOP("HairKinds", "Something else"),
             [](GroupSettings& settings) {
                 putShort(settings, {0.05F, 1.0e6F, 60e-6F, 0.004F, 0.04F});
             }},
};

} // namespace

std::span<const HairKind> hairKinds()
{
    return kKinds;
}

QString titleOf(const HairKind& kind)
{
    return QCoreApplication::translate("HairKinds", kind.title);
}

bool isFaceHair(const HairGroup& group)
{
    return std::ranges::any_of(
        kKinds, [&](const HairKind& kind) { return kind.ofEveryFace && group.name == QLatin1StringView(kind.name); });
}

} // namespace hairpaint::model
