// Styles over a fade.
#include "model/project/hair_types.h"
#include "strokes.h"
#include "styles.h"

#include <algorithm>

namespace hairpaint::presets {

namespace {

/// Hair that stands, cut to a box with a level top.
void shapeBox(Recording& user)
{
    constexpr glm::vec3 kMostHd(0.080F, 0.152F, 0.094F); // m
    constexpr float kBackM = 0.101F;
    constexpr float kLowestM = 0.060F;
    constexpr float kClippedM = 0.007F; // Clippers were there already.
    constexpr float kStepM = 0.009F;
    for (const float leftM : evenly(0.0F, 0.076F, kStepM))
        for (const float forwardM : evenly(-0.095F, 0.085F, kStepM)) {
            const sim::SurfacePoint point = user.above(leftM, forwardM);
            if (point.positionHd.y < kLowestM)
                continue;
            const glm::vec3 from = point.positionHd;
            const glm::vec3 out = glm::max(glm::abs(point.normalHd), 1e-3F);
            const float depthM = point.normalHd.z > 0.0F ? kMostHd.z - from.z : kBackM + from.z;
            const float lengthM =
                std::min({(kMostHd.x - from.x) / out.x, (kMostHd.y - from.y) / out.y, depthM / out.z});
            if (lengthM > kClippedM)
                user.brush(MapKind::Length, user.length(lengthM), {.sizeM = 0.018F, .hardness = 0.3F}, {point});
        }
}

} // namespace

Style curlyTop()
{
    Style style{.id = "curly-top-with-fade",
                .name = "Curly top with fade",
                .tags = {QStringLiteral("short"), QStringLiteral("curly")},
                .settings = settingsOf(0.12F, 0.06F, 0.010F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.9F);
                    user.fill(MapKind::Colour, colour(0xFF2A1B14));
                    graduate(user, 0.012F, 0.06F);
                    fade(user, 0.002F, 0.012F);
                    front(user, MapKind::Length, user.length(0.065F), 0.05F);
                    user.setMirror(false);
                    user.polygon(MapKind::Curl, scalar(1.0F), aroundTop(user));
                    user.polygon(MapKind::Frizz, scalar(0.15F), aroundTop(user));
                }};
    model::setHairType(style.settings, model::hairType("3C"));
    style.settings.curl.diameterM = 0.012F;
    style.settings.curl.pitchM = 0.022F;
    style.settings.locks.sizeM = 0.012F;
    style.settings.nodesPerHair = 12;
    return style;
}

Style highTop()
{
    Style style{.id = "high-top-fade",
                .name = "High-top fade",
                .tags = {QStringLiteral("short"), QStringLiteral("coily")},
                .settings = settingsOf(0.12F, 0.10F, 0.0F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.9F);
                    user.fill(MapKind::Colour, colour(0xFF17110F));
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Frizz, scalar(0.3F));
                    user.fill(MapKind::Gel, scalar(0.95F));
                    user.fill(MapKind::Direction, upright());
                    user.fill(MapKind::Length, user.length(0.007F));
                    fade(user, 0.0015F, 0.007F);
                    shapeBox(user);
                }};
    model::setHairType(style.settings, model::hairType("4B"));
    style.settings.curl.switchbacksPerM = 40.0F;
    style.settings.curl.gather = 0.15F;
    style.settings.variation.crossing = 0.3F;
    style.settings.material.shine = 0.25F;
    return style;
}

Style libertySpikes()
{
    Style style{.id = "liberty-spikes",
                .name = "Liberty spikes",
                .tags = {QStringLiteral("short"), QStringLiteral("gelled"), QStringLiteral("coloured")},
                .settings = settingsOf(0.20F, 0.12F, 0.0F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.9F);
                    user.fill(MapKind::Colour, colour(0xFF2E6A1A));
                    user.fill(MapKind::TipColour, colour(0xFF7A9A1C));
                    user.fill(MapKind::Length, user.length(0.13F));
                    user.bands(MapKind::Length,
                               {{-0.08F, user.length(0.04F)},
                                {-0.05F, user.length(0.07F)},
                                {-0.02F, user.length(0.10F)},
                                {0.01F, user.length(0.12F)}},
                               85.0F);
                    user.fill(MapKind::Clump, scalar(1.0F));
                    user.fill(MapKind::Gel, scalar(1.0F));
                    user.fill(MapKind::Direction, upright());
                }};
    style.settings.locks = {.sizeM = 0.018F, .small = 0.9F};
    style.settings.variation.flyaways = 0.0F;
    style.settings.variation.crossing = 0.0F;
    style.settings.variation.partGapM = 0.0F;
    style.settings.material.tipAlpha = 0.9F;
    return style;
}

Style lineUp()
{
    Style style{.id = "line-up-fade",
                .name = "Fade with line-up",
                .tags = {QStringLiteral("short"), QStringLiteral("coily")},
                .settings = settingsOf(0.03F, 0.06F, 0.0F),
                .record = [](Recording& user) {
                    user.fill(MapKind::Colour, colour(0xFF15100E));
                    graduate(user, 0.004F, 0.010F);
                    fade(user, 0.001F, 0.004F);
                    user.fill(MapKind::Curl, scalar(1.0F));
                }};
    model::setHairType(style.settings, model::hairType("4C"));
    style.settings.hairline = {};
    style.settings.nodesPerHair = 6;
    style.settings.material.widthM = 100e-6F;
    style.settings.material.shine = 0.25F;
    return style;
}

} // namespace hairpaint::presets
