// A braid around the head.
#include "strokes.h"
#include "styles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hairpaint::presets {

namespace {

using Seen = Recording::Seen;

/// The wreath over the head's left, from the forehead to the nape.
constexpr std::array<Seen, 11> kLeftOfWreath{{{0.0F, 0.090F},
                                              {20.0F, 0.087F},
                                              {38.0F, 0.078F},
                                              {54.0F, 0.066F},
                                              {70.0F, 0.055F},
                                              {88.0F, 0.045F},
                                              {105.0F, 0.033F},
                                              {122.0F, 0.019F},
                                              {140.0F, 0.005F},
                                              {160.0F, -0.008F},
                                              {180.0F, -0.014F}}};
/// The hairline of that half, a few mm out.
constexpr std::array<Seen, 11> kHairline{{{0.0F, 0.066F},
                                          {20.0F, 0.066F},
                                          {36.0F, 0.062F},
                                          {46.0F, 0.042F},
                                          {58.0F, 0.014F},
                                          {72.0F, -0.014F},
                                          {100.0F, 0.010F},
                                          {110.0F, -0.030F},
                                          {135.0F, -0.070F},
                                          {158.0F, -0.080F},
                                          {180.0F, -0.080F}}};
constexpr Seen kBegins{152.0F, -0.005F}; ///< Behind the left ear.
constexpr Seen kEnds{-168.0F, -0.002F};
/// From the wreath's end on to its begin.
constexpr std::array<Seen, 5> kAcross{
    {{-140.0F, 0.005F}, {-156.0F, -0.005F}, {-172.0F, -0.013F}, {-190.0F, -0.013F}, {-206.0F, -0.005F}}};

/// The wreath from its begin over the forehead to its end.
Recording::Points wreath(const Recording& user)
{
    std::vector<Seen> line{kBegins};
    for (std::size_t i = kLeftOfWreath.size() - 2; i-- > 1;)
        line.push_back(kLeftOfWreath[i]);
    for (std::size_t i = 0; i + 1 < kLeftOfWreath.size(); ++i)
        line.push_back({-kLeftOfWreath[i].degrees, kLeftOfWreath[i].heightM});
    line.push_back(kEnds);
    return user.along(line);
}

/// From a point of the wreath so far toward the crown, over the skin.
sim::SurfacePoint towardCrown(const Recording& user, const sim::SurfacePoint& from, float fraction)
{
    const glm::vec3 centreHd(0.0F, 0.02F, -0.015F);
    const glm::vec3 crown = glm::normalize(user.above(0.0F, -0.045F).positionHd - centreHd);
    const glm::vec3 direction = glm::normalize(from.positionHd - centreHd);
    return user.outward(centreHd, glm::normalize(direction + fraction * (crown - direction)));
}

/// Hair within the wreath and around it, combed to it and cut where it is hidden.
void combToWreath(Recording& user)
{
    constexpr float kHiddenM = 0.008F;
    const Recording::Points left = user.along(kLeftOfWreath);
    for (const float fraction : evenly(1.0F, 0.2F, 0.1F)) {
        for (std::size_t i = 0; i + 1 < left.size(); ++i) {
            const sim::SurfacePoint from = towardCrown(user, left[i], fraction);
            const sim::SurfacePoint to = towardCrown(user, left[i + 1], fraction);
            user.brush(MapKind::Length, user.length(glm::distance(from.positionHd, left[i].positionHd) * 1.1F),
                       {.sizeM = 0.022F, .hardness = 0.3F}, {from, to});
        }
    }
    for (const sim::SurfacePoint& end : left) {
        Recording::Points lane;
        for (const float fraction : evenly(0.93F, 0.0F, 0.133F))
            lane.push_back(towardCrown(user, end, fraction));
        lane.push_back(end);
        user.comb(0.96F, {.sizeM = 0.035F, .hardness = 0.5F}, lane);
    }
    // What grows below it, up to it; so densely that no hair falls between the lanes.
    const sim::Skin& skin = *user.document().project().head->skin;
    for (const float at : evenly(0.0F, static_cast<float>(left.size() - 1), 1.0F / 3.0F)) {
        const auto i = std::min(static_cast<std::size_t>(at), left.size() - 2);
        const auto between = [&](const std::array<Seen, 11>& line) {
            const float fraction = at - static_cast<float>(i);
            return user.around(std::lerp(line[i].degrees, line[i + 1].degrees, fraction),
                               std::lerp(line[i].heightM, line[i + 1].heightM, fraction));
        };
        const sim::SurfacePoint from = between(kHairline);
        const sim::SurfacePoint to = between(kLeftOfWreath);
        const glm::vec3 onwardHd = to.positionHd - from.positionHd;
        for (const float fraction : {0.0F, 0.25F, 0.5F}) {
            const float lengthM = glm::length(onwardHd) * (1.05F - fraction) + kHiddenM;
            user.brush(MapKind::Length, user.length(lengthM), {.sizeM = 0.022F, .hardness = 0.3F},
                       {skin.nearest(from.positionHd + fraction * onwardHd)});
        }
        user.comb(0.96F, {.sizeM = 0.022F, .hardness = 0.7F}, {from, to});
    }
}

} // namespace

Style crownBraid()
{
    Style style{
        .id = "crown-braid",
        .name = "Crown braid",
        .tags = {QStringLiteral("long"), QStringLiteral("braided"), QStringLiteral("tied")},
        .settings = settingsOf(0.25F, 0.05F, 0.004F),
        .record = [](Recording& user) {
            user.setLayerOpacity(MapKind::Density, 0.9F);
            user.fill(MapKind::Colour, colour(0xFF8A6A44));
            user.fill(MapKind::Length, user.length(0.04F));
            user.fill(MapKind::Gel, scalar(0.9F));
            user.fill(MapKind::Frizz, scalar(0.1F));
            combToWreath(user);
            user.setMirror(false);
            user.brush(MapKind::Braid, entry(kCornrow), {.sizeM = 0.046F, .hardness = 1.0F}, wreath(user));
            // Its end is combed under its begin.
            const Recording::Points across = user.along(kAcross);
            user.comb(0.97F, {.sizeM = 0.048F, .hardness = 0.8F}, across);
            user.brush(MapKind::Length, user.length(0.04F), {.sizeM = 0.04F, .hardness = 0.8F}, {across[2], across[3]});
            user.brush(MapKind::Length, user.length(0.028F), {.sizeM = 0.044F, .hardness = 0.9F},
                       {across[1], across[2]});
            user.wear(model::WornKind::Bow, user.around(173.0F, -0.009F));
            user.setWorn(model::WornKind::Bow, [](model::Worn& bow) {
                bow.colour = 0xFF2C3E5E;
                bow.shape.semiAxesM *= 0.75F;
                bow.shape.centreHd += bow.shape.rotation * glm::vec3(0.0F, 0.0F, 0.010F); // On the braid.
            });
        }};
    style.settings.braidRadiusM = 0.0085F;
    style.settings.braidTaper = 0.2F;
    style.settings.braidTie = 0.0F;
    style.settings.variation.partGapM = 0.0F;
    style.settings.variation.flyaways = 0.006F;
    style.settings.nodesPerHair = 32;
    style.settings.material.shine = 0.6F;
    return style;
}

} // namespace hairpaint::presets
