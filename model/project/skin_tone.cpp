// The table of skin tones. Light and dark skin scatter and shine alike; dark skin returns less of what entered it.
#include "model/project/skin_tone.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace hairpaint::model {

namespace {

constexpr std::array<SkinLook, kSkinToneCount> kLooks{{
    {SkinTone::Clay, "clay", QT_TRANSLATE_NOOP("SkinTone", "Neutral clay"), 0xFFBDB3AB, 0xFFB7AAA2, 0xFFB7ACA4, 0.25F,
     0.25F, 0.6F},
    {SkinTone::Porcelain, "porcelain", QT_TRANSLATE_NOOP("SkinTone", "Porcelain"), 0xFFE6CEC0, 0xFFD4A29B, 0xFFDDB9AC,
     1.0F, 0.7F, 0.8F},
    {SkinTone::Fair, "fair", QT_TRANSLATE_NOOP("SkinTone", "Fair"), 0xFFDDB9A3, 0xFFCA9385, 0xFFD0A591, 1.0F, 0.75F,
     0.8F},
    {SkinTone::Beige, "beige", QT_TRANSLATE_NOOP("SkinTone", "Beige"), 0xFFCA9F82, 0xFFB6806F, 0xFFBB8B6F, 0.9F, 0.8F,
     0.85F},
    {SkinTone::Olive, "olive", QT_TRANSLATE_NOOP("SkinTone", "Olive"), 0xFFAB815F, 0xFF9B6856, 0xFF9B7051, 0.8F, 0.85F,
     0.9F},
    {SkinTone::Brown, "brown", QT_TRANSLATE_NOOP("SkinTone", "Brown"), 0xFF815A43, 0xFF774D40, 0xFF714D38, 0.7F, 0.9F,
     1.0F},
    {SkinTone::Deep, "deep", QT_TRANSLATE_NOOP("SkinTone", "Deep"), 0xFF51382E, 0xFF4D3230, 0xFF452F27, 0.6F, 1.0F,
     1.0F},
    {SkinTone::Own, "own", QT_TRANSLATE_NOOP("SkinTone", "The head's own picture"), 0xFFBDB3AB, 0xFFB7AAA2, 0xFFB7ACA4,
     0.5F, 0.25F, 0.6F},
}};

static_assert(
    [] {
        for (std::size_t i = 0; i < kLooks.size(); ++i)
            if (static_cast<std::size_t>(kLooks[i].tone) != i)
                return false;
        return true;
    }(),
    "rows stand in the order of SkinTone");

} // namespace

QString SkinLook::titleText() const
{
    return QCoreApplication::translate("SkinTone", title);
}

std::span<const SkinLook> skinLooks()
{
    return kLooks;
}

const SkinLook& skinLook(SkinTone tone)
{
    return kLooks[static_cast<std::size_t>(tone)];
}

const SkinLook* findSkinLook(QStringView id)
{
    const auto found =
        std::ranges::find_if(kLooks, [id](const SkinLook& look) { return QLatin1StringView(look.id) == id; });
    return found != kLooks.end() ? &*found : nullptr;
}

} // namespace hairpaint::model
