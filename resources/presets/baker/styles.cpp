// The list of styles, and what several of them do.
#include "styles.h"

#include "model/project/group_schema.h"

#include <algorithm>

namespace hairpaint::presets {

namespace {

constexpr float kOnTopM = 0.150F; ///< From the crown over the side of the head to its middle's height.

/// How much further hair that grows at a height goes than straight down: over the curve of the head.
float overHeadM(float heightM)
{
    constexpr float kCurveBeginsM = 0.06F;
    constexpr float kCurve = 11.0F; ///< 1/m
    const float aboveM = std::max(heightM - kCurveBeginsM, 0.0F);
    return kCurve * aboveM * aboveM;
}

} // namespace

sim::GroupSettings settingsOf(float greatestLengthM, float stiffnessM, float volumeM)
{
    sim::GroupSettings settings;
    settings.basisHairs = 16384; // Some 3,700 on the scalp, 4 mm apart.
    settings.greatestLengthM = greatestLengthM;
    settings.variation = model::naturalVariation();
    model::setNaturalEnds(settings);
    settings.physics.stiffnessM = stiffnessM;
    settings.physics.volumeM = volumeM;
    return settings;
}

void cutToLine(Recording& user, float lineHeightM, float shortestM)
{
    constexpr int kLowestMm = -85;
    constexpr int kHighestMm = 101;
    constexpr int kStepMm = 6;
    constexpr float kTopM = 0.103F;
    constexpr float kFaceEndsM = 0.06F;
    constexpr float kBesideFaceDegrees = 45.0F;
    user.fill(MapKind::Length, user.length(kTopM + overHeadM(kTopM) - lineHeightM));
    std::vector<Band> low;
    std::vector<Band> high;
    for (int heightMm = kLowestMm; heightMm <= kHighestMm; heightMm += kStepMm) {
        const float heightM = 0.001F * static_cast<float>(heightMm);
        const float lengthM = std::max(heightM - lineHeightM + overHeadM(heightM), shortestM);
        (heightM < kFaceEndsM ? low : high).push_back({heightM, user.length(lengthM)});
    }
    user.bands(MapKind::Length, low, kBesideFaceDegrees);
    user.bands(MapKind::Length, high);
    // From the middle it goes the furthest.
    user.brush(MapKind::Length, user.length(kOnTopM - lineHeightM), {.sizeM = 0.045F, .hardness = 0.0F},
               user.overHead(0.0F, 0.03F, -0.045F));
}

std::vector<Style> builtInStyles()
{
    return {longStraight(), bob(),     ringlets(),        afro(),  twoPlaits(), mohawk(),
            splitDye(),     buzzCut(), slickedUndercut(), quiff(), sidePart(),  frenchCrop()};
}

model::Preset played(const Style& style, const model::HairGroup& grown)
{
    Recording user(grown, style.settings);
    style.record(user);
    model::Preset preset = user.preset(QString::fromLatin1(style.name));
    preset.tags = style.tags;
    return preset;
}

} // namespace hairpaint::presets
