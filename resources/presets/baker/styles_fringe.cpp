// Styles with hair over the forehead.
#include "model/project/hair_types.h"
#include "sim/base/rounded.h"
#include "strokes.h"
#include "styles.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace hairpaint::presets {

namespace {

/// Hair from the fringe's corner to the ear, up to the parting, cut to a line at the cheek.
void cutSidelocks(Recording& user, float lineHeightM)
{
    constexpr float kFromDegrees = 27.0F;
    constexpr float kToDegrees = 80.0F;
    constexpr float kCurveBeginsM = 0.06F;
    constexpr float kCurve = 11.0F; // 1/m
    const auto lengthAt = [&](float heightM) {
        const float aboveM = std::max(heightM - kCurveBeginsM, 0.0F);
        return user.length(heightM - lineHeightM + kCurve * aboveM * aboveM);
    };
    const Ring ring{.sizeM = 0.009F, .hardness = 0.8F};
    for (const float heightM : evenly(-0.02F, 0.088F, 0.004F))
        user.brush(MapKind::Length, lengthAt(heightM), ring, user.level(heightM, kFromDegrees, kToDegrees));
    // Over the top, around the axis.
    for (const float radiusM : evenly(0.052F, 0.004F, 0.004F)) {
        Recording::Points arc;
        const std::vector<float> turns = evenly(kFromDegrees, kToDegrees, 7.0F);
        arc.reserve(turns.size());
        float heightM = 0.0F;
        for (const float degrees : turns) {
            const float angle = glm::radians(degrees);
            arc.push_back(
                user.above(radiusM * sim::sinRounded(angle), kAxisForwardM + radiusM * sim::cosRounded(angle)));
            heightM = std::max(heightM, arc.back().positionHd.y);
        }
        user.brush(MapKind::Length, lengthAt(heightM), ring, arc);
    }
}

/// Straight down before the ears, a little toward the cheek.
void combSidelocks(Recording& user)
{
    for (const float degrees : evenly(70.0F, 36.0F, 8.0F)) {
        Recording::Points lane;
        lane.reserve(5);
        for (const float heightM : {0.085F, 0.068F, 0.050F, 0.032F, 0.012F})
            lane.push_back(user.around(degrees - 50.0F * (0.085F - heightM), heightM));
        user.comb(0.95F, {.sizeM = 0.020F, .hardness = 0.7F}, lane);
    }
}

} // namespace

Style pixie()
{
    Style style{.id = "pixie",
                .name = "Pixie",
                .tags = {QStringLiteral("short"), QStringLiteral("straight")},
                .settings = settingsOf(0.15F, 0.05F, 0.007F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.92F);
                    user.fill(MapKind::Colour, colour(0xFF9A8058));
                    graduate(user, 0.035F, 0.075F);
                    user.bands(MapKind::Length,
                               {{-0.08F, user.length(0.014F)},
                                {-0.055F, user.length(0.017F)},
                                {-0.03F, user.length(0.021F)},
                                {-0.005F, user.length(0.026F)},
                                {0.02F, user.length(0.031F)}},
                               45.0F);
                    front(user, MapKind::Length, user.length(0.068F), 0.05F);
                    user.fill(MapKind::Clump, scalar(0.45F));
                    user.setMirror(false);
                    user.part({.reachM = 0.09F, .flatness = 0.96F}, user.overHead(0.033F, 0.058F, -0.03F));
                    // The fringe, swept over the forehead.
                    for (const float furtherM : {0.0F, 0.009F})
                        user.comb(0.9F, {.sizeM = 0.022F, .hardness = 0.5F},
                                  {user.above(0.026F, 0.058F + furtherM), user.above(0.008F, 0.066F + furtherM),
                                   user.above(-0.012F, 0.067F + furtherM), user.above(-0.03F, 0.060F + furtherM)});
                }};
    style.settings.locks.sizeM = 0.012F;
    style.settings.nodesPerHair = 10;
    style.settings.material.tipAlpha = 0.6F;
    return style;
}

Style curtainLayers()
{
    Style style{.id = "curtain-layers",
                .name = "Curtain layers",
                .tags = {QStringLiteral("long"), QStringLiteral("wavy")},
                .settings = settingsOf(0.45F, 0.05F, 0.010F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF6A4026));
                    cutToLine(user, -0.24F, 0.12F);
                    // Ever shorter toward the face.
                    for (const auto& [sizeM, lengthM] :
                         {std::pair(0.10F, 0.25F), std::pair(0.08F, 0.21F), std::pair(0.06F, 0.17F),
                          std::pair(0.04F, 0.135F), std::pair(0.024F, 0.115F)})
                        user.brush(MapKind::Length, user.length(lengthM), {.sizeM = sizeM, .hardness = 0.2F},
                                   user.level(0.078F, 0.0F, 26.0F));
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Clump, scalar(0.35F));
                    partInTheMiddle(user, {.flatness = 0.75F});
                    // To the temples before it falls beside the face.
                    for (const float furtherM : {0.0F, -0.012F})
                        user.comb(0.93F, {.sizeM = 0.022F, .hardness = 0.6F},
                                  {user.above(0.004F, 0.066F + furtherM), user.above(0.020F, 0.066F + furtherM),
                                   user.above(0.036F, 0.057F + furtherM), user.above(0.049F, 0.044F + furtherM),
                                   user.above(0.058F, 0.030F + furtherM)});
                }};
    model::setHairType(style.settings, model::hairType("2A"));
    style.settings.curl.diameterM = 0.03F;
    style.settings.curl.pitchM = 0.2F;
    style.settings.curl.straightM = 0.04F;
    style.settings.nodesPerHair = 14;
    style.settings.material.shine = 0.6F;
    return style;
}

Style hime()
{
    Style style{.id = "hime",
                .name = "Hime cut",
                .tags = {QStringLiteral("long"), QStringLiteral("straight")},
                .settings = settingsOf(0.60F, 0.045F, 0.007F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.9F);
                    user.fill(MapKind::Colour, colour(0xFF15110F));
                    cutToLine(user, -0.32F, 0.12F);
                    user.fill(MapKind::Clump, scalar(0.2F));
                    cutSidelocks(user, -0.072F);
                    front(user, MapKind::Length, user.length(0.056F), 0.03F);
                    user.part({.reachM = 0.11F}, user.overHead(0.0F, 0.045F, -0.085F));
                    combSidelocks(user);
                    cutFringe(user, {.lengthM = 0.054F, .halfM = 0.059F, .longerM = 0.006F, .flatness = 0.88F});
                }};
    style.settings.nodesPerHair = 14;
    style.settings.material.shine = 0.75F;
    style.settings.material.roughness = 0.28F;
    style.settings.material.tipAlpha = 0.8F;
    return style;
}

Style jawBob()
{
    Style style{.id = "jaw-bob-with-fringe",
                .name = "Jaw bob with fringe",
                .tags = {QStringLiteral("medium"), QStringLiteral("straight")},
                .settings = settingsOf(0.25F, 0.045F, 0.007F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.9F);
                    user.fill(MapKind::Colour, colour(0xFF6E2A1C));
                    cutToLine(user, -0.070F, 0.10F);
                    user.fill(MapKind::Clump, scalar(0.25F));
                    for (const float heightM : {0.0F, -0.025F, -0.05F, -0.075F})
                        user.erase(MapKind::Density, {.sizeM = 0.03F, .hardness = 0.9F}, user.level(heightM, 75.0F));
                    user.part({.reachM = 0.11F}, user.overHead(0.0F, 0.020F, -0.085F));
                    combBeforeEars(user);
                    cutFringe(user, {.depthM = 0.045F, .halfM = 0.062F, .longerM = 0.012F});
                    front(user, MapKind::Gel, scalar(0.5F), 0.04F);
                }};
    style.settings.nodesPerHair = 10;
    style.settings.material.shine = 0.75F;
    style.settings.material.tipAlpha = 0.9F;
    return style;
}

} // namespace hairpaint::presets
