// Strokes of styles: see the header.
#include "strokes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::presets {

namespace {

/// Over the face, past the temples' corners and along the ridge of the head.
constexpr std::array<Recording::Seen, 13> kRidge{{{0.0F, 0.058F},
                                                  {15.0F, 0.058F},
                                                  {28.0F, 0.060F},
                                                  {38.0F, 0.063F},
                                                  {50.0F, 0.062F},
                                                  {65.0F, 0.059F},
                                                  {80.0F, 0.057F},
                                                  {95.0F, 0.056F},
                                                  {110.0F, 0.055F},
                                                  {125.0F, 0.053F},
                                                  {140.0F, 0.050F},
                                                  {160.0F, 0.047F},
                                                  {180.0F, 0.045F}}};

/// The left half of the hairline, a few mm out, from the forehead's middle to the nape's and up the back.
constexpr std::array<Recording::Seen, 29> kAroundHairline{
    {{0.4F, 0.067F},    {4.0F, 0.067F},    {12.0F, 0.067F},   {24.0F, 0.069F},   {34.0F, 0.068F},   {41.0F, 0.060F},
     {45.0F, 0.048F},   {47.0F, 0.036F},   {52.0F, 0.024F},   {59.0F, 0.012F},   {64.0F, 0.000F},   {65.0F, -0.014F},
     {70.0F, -0.022F},  {76.0F, -0.015F},  {77.0F, 0.000F},   {80.0F, 0.012F},   {88.0F, 0.019F},   {97.0F, 0.016F},
     {103.0F, 0.003F},  {106.0F, -0.018F}, {114.0F, -0.043F}, {136.0F, -0.070F}, {160.0F, -0.080F}, {179.4F, -0.080F},
     {179.4F, -0.045F}, {179.4F, -0.02F},  {179.4F, 0.01F},   {179.4F, 0.04F},   {179.4F, 0.06F}}};

constexpr std::size_t kToNape = 23; ///< Points of it up to beside the nape.

constexpr std::array<Recording::Seen, 8> kDownTheBack{{{180.0F, 0.05F},
                                                       {180.0F, 0.03F},
                                                       {180.0F, 0.01F},
                                                       {180.0F, -0.01F},
                                                       {180.0F, -0.03F},
                                                       {180.0F, -0.05F},
                                                       {180.0F, -0.07F},
                                                       {180.0F, -0.09F}}};

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

std::vector<float> evenly(float from, float to, float step)
{
    const int steps = static_cast<int>(std::abs(to - from) / step);
    std::vector<float> all;
    all.reserve(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i <= steps; ++i)
        all.push_back(from + (to < from ? -step : step) * static_cast<float>(i));
    return all;
}

Recording::Points aroundTop(const Recording& user)
{
    std::vector<Recording::Seen> line(kRidge.begin(), kRidge.end());
    for (std::size_t i = kRidge.size() - 1; i-- > 0;)
        line.push_back({-kRidge[i].degrees, kRidge[i].heightM});
    return user.along(line);
}

void taperBack(Recording& user, float ridgeM, float crownM)
{
    std::vector<Band> bands;
    constexpr int kSteps = 16;
    for (int step = 0; step <= kSteps; ++step) {
        const float fraction = static_cast<float>(step) / kSteps;
        const float longer = fraction * (0.7F + 0.3F * fraction); // As far as it is from there to the ridge.
        bands.push_back({0.036F + 0.069F * fraction, user.length(ridgeM + (crownM - ridgeM) * longer)});
    }
    user.bands(MapKind::Length, bands, 100.0F);
}

void graduate(Recording& user, float ridgeM, float crownM)
{
    user.fill(MapKind::Length, user.length(crownM));
    std::vector<Band> bands;
    constexpr int kSteps = 16;
    for (int step = 0; step <= kSteps; ++step) {
        const float fraction = static_cast<float>(step) / kSteps;
        bands.push_back({0.04F + 0.06F * fraction, user.length(ridgeM + (crownM - ridgeM) * fraction * fraction)});
    }
    user.bands(MapKind::Length, bands);
}

void front(Recording& user, MapKind map, const PaintValue& value, float sizeM)
{
    user.brush(map, value, {.sizeM = sizeM, .hardness = 0.1F}, user.level(0.080F, 0.0F, 26.0F));
}

void fade(Recording& user, float lowestM, float ridgeM)
{
    std::vector<Band> bands;
    constexpr int kSteps = 16;
    for (int step = 0; step <= kSteps; ++step) {
        const float fraction = static_cast<float>(step) / kSteps;
        bands.push_back({-0.09F + 0.13F * fraction, user.length(lowestM + (ridgeM - lowestM) * fraction * fraction)});
    }
    user.bands(MapKind::Length, bands, 45.0F);
}

void partInTheMiddle(Recording& user, const Parting& parting)
{
    user.part(parting, user.overHead(0.0F, 0.065F, -0.085F));
}

Recording::Points aroundLeft(const Recording& user, float fromMiddleM)
{
    Recording::Points side = user.overHead(fromMiddleM, -0.085F, 0.06F);
    for (const sim::SurfacePoint& point : user.along(kAroundHairline))
        side.push_back(point);
    return side;
}

Recording::Points overMiddle(const Recording& user)
{
    Recording::Points middle = user.overHead(0.0F, 0.085F, -0.085F);
    for (const sim::SurfacePoint& point : user.along(kDownTheBack))
        middle.push_back(point);
    return middle;
}

void shaveMiddle(Recording& user, float widthM)
{
    user.erase(MapKind::Density, {.sizeM = widthM, .hardness = 1.0F}, overMiddle(user));
    shaveDownTheBack(user);
}

void shaveDownTheBack(Recording& user)
{
    user.erase(MapKind::Density, {.sizeM = 0.0040F, .hardness = 1.0F}, user.along(kDownTheBack));
}

void outToHairline(Recording& user, MapKind map, const PaintValue& value)
{
    user.brush(map, value, {.sizeM = 0.012F, .hardness = 1.0F}, user.along(std::span(kAroundHairline).first(kToNape)));
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

void combOffFace(Recording& user)
{
    for (const float furtherM : {-0.02F, 0.002F})
        user.comb(0.97F, {.sizeM = 0.03F, .hardness = 0.6F},
                  {user.above(0.014F, 0.071F + furtherM), user.above(0.034F, 0.057F + furtherM),
                   user.above(0.047F, 0.044F + furtherM), user.above(0.057F, 0.028F + furtherM),
                   user.above(0.064F, 0.012F + furtherM)});
}

void combBeforeEars(Recording& user)
{
    for (const float degrees : {0.0F, 9.0F})
        user.comb(0.97F, {.sizeM = 0.022F, .hardness = 0.7F},
                  user.along(std::array<Recording::Seen, 5>{{{37.0F + degrees, 0.084F},
                                                             {43.0F + degrees, 0.068F},
                                                             {49.0F + degrees, 0.048F},
                                                             {54.0F + degrees, 0.026F},
                                                             {59.0F + degrees, 0.002F}}}));
}

void cutFringe(Recording& user, const Fringe& fringe)
{
    constexpr float kStepM = 0.008F;
    constexpr float kHairlineM = 0.077F; // Its middle, forward.
    constexpr float kBack = 0.25F;       // The hairline goes back to the sides.
    constexpr float kEaseM = 0.006F;
    constexpr float kDeeperM = 0.014F;
    const auto forwardM = [](float leftM, float backM) {
        return kHairlineM - kBack * leftM - 4.0F * leftM * leftM - backM;
    };
    for (const float backM : evenly(fringe.depthM + kDeeperM, -kEaseM, kStepM))
        for (const float leftM : evenly(0.0F, fringe.halfM, kStepM)) {
            // At its sides hair falls more steeply, and sooner.
            const float side = leftM / fringe.halfM;
            const float lengthM =
                fringe.lengthM + std::max(backM, 0.0F) * (1.0F - 0.65F * side * side) + fringe.longerM * side;
            const Recording::Points spot{user.above(leftM, forwardM(leftM, backM)),
                                         user.above(std::min(leftM + kStepM, fringe.halfM),
                                                    forwardM(std::min(leftM + kStepM, fringe.halfM), backM))};
            user.brush(MapKind::Length, user.length(lengthM), {.sizeM = 0.014F, .hardness = 0.5F}, spot);
        }
    // Down the forehead, where the hairline may have a peak, and where hair goes on as the skin under it is combed: to
    // the sides by nature.
    const auto downForehead = [&](float leftM) {
        const float hairlineM = user.above(leftM, forwardM(leftM, -kEaseM)).positionHd.y;
        Recording::Points lane;
        for (const float belowM : evenly(0.0F, 5.0F * kStepM, kStepM))
            lane.push_back(user.outward({leftM, hairlineM - belowM, 0.0F}, {0.0F, 0.0F, 1.0F}));
        return lane;
    };
    const std::vector<float> lanes = evenly(0.0F, fringe.halfM - kEaseM, kStepM);
    for (const float leftM : lanes)
        user.brush(MapKind::Length, user.length(fringe.lengthM + fringe.longerM * leftM / fringe.halfM),
                   {.sizeM = 0.016F, .hardness = 0.8F}, downForehead(leftM));
    // Between the two, where soft rims of the strokes leave long hair.
    Recording::Points hairline;
    for (const float leftM : evenly(0.0F, 0.5F * fringe.halfM, kStepM))
        hairline.push_back(user.outward({leftM, 0.078F, 0.0F}, {0.0F, 0.0F, 1.0F}));
    user.brush(MapKind::Length, user.length(fringe.lengthM), {.sizeM = 0.012F, .hardness = 0.9F}, hairline);
    // Less far to all sides than it is cut, or long hair beside it would hang into the face.
    for (const float leftM : lanes) {
        Recording::Points lane{user.above(0.92F * leftM, forwardM(0.92F * leftM, fringe.depthM))};
        for (const float backM : evenly(fringe.depthM - kStepM, -kEaseM, kStepM))
            lane.push_back(user.above(leftM, forwardM(leftM, backM)));
        const Recording::Points below = downForehead(leftM);
        lane.insert(lane.end(), below.begin() + 1, below.end());
        user.comb(fringe.flatness, {.sizeM = 0.016F, .hardness = 0.8F}, lane);
    }
}

} // namespace hairpaint::presets
