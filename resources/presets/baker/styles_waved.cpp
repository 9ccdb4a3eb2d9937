// Waved styles in layers.
#include "model/project/hair_types.h"
#include "strokes.h"
#include "styles.h"

#include <utility>

namespace hairpaint::presets {

namespace {

/// A fringe so loose that no skin shows between its locks, up to so far from the face's middle.
void loosenFringe(Recording& user, float curl, float degrees)
{
    const Ring ring{.sizeM = 0.07F, .hardness = 0.5F};
    user.brush(MapKind::Clump, scalar(0.15F), ring, user.level(0.078F, 0.0F, degrees));
    user.brush(MapKind::Curl, scalar(curl), ring, user.level(0.078F, 0.0F, degrees));
}

} // namespace

Style beachWaves()
{
    Style style{.id = "beach-waves-balayage",
                .name = "Beach waves balayage",
                .tags = {QStringLiteral("long"), QStringLiteral("wavy"), QStringLiteral("coloured")},
                .settings = settingsOf(0.45F, 0.05F, 0.010F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF3E2A1E));
                    user.fill(MapKind::TipColour, colour(0xFFB98C58));
                    user.fill(MapKind::TipStart, scalar(0.5F));
                    // Strands painted by hand, all around: lighter from nearer the root than what lies between.
                    for (const float degrees : evenly(22.0F, 178.0F, 13.0F)) {
                        Recording::Points strand;
                        for (const float heightM : {0.092F, 0.075F, 0.055F, 0.035F})
                            strand.push_back(user.around(degrees, heightM));
                        user.brush(MapKind::TipStart, scalar(0.12F), {.sizeM = 0.009F, .hardness = 0.3F}, strand);
                    }
                    // Lighter from nearer the root about the face.
                    user.brush(MapKind::TipStart, scalar(0.15F), {.sizeM = 0.04F, .hardness = 0.2F},
                               user.level(0.075F, 20.0F, 50.0F));
                    cutToLine(user, -0.25F, 0.12F);
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.part({.flatness = 0.93F}, user.overHead(0.012F, 0.065F, -0.06F));
                    combOffFace(user);
                }};
    model::setHairType(style.settings, model::hairType("2C"));
    style.settings.curl.diameterM = 0.03F;
    style.settings.curl.pitchM = 0.10F;
    style.settings.curl.straightM = 0.05F;
    style.settings.curl.gather = 0.75F;
    style.settings.locks = {.sizeM = 0.022F, .ragged = 0.3F, .parting = 0.3F};
    style.settings.variation.crossing = 0.04F;
    style.settings.variation.flyaways = 0.003F;
    style.settings.nodesPerHair = 14;
    return style;
}

Style wolfCut()
{
    Style style{.id = "wolf-cut",
                .name = "Wolf cut",
                .tags = {QStringLiteral("medium"), QStringLiteral("wavy")},
                .settings = settingsOf(0.35F, 0.05F, 0.014F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF4A3426));
                    // Short on top and long in the nape.
                    user.fill(MapKind::Length, user.length(0.12F));
                    user.bands(MapKind::Length,
                               {{-0.08F, user.length(0.15F)},
                                {-0.06F, user.length(0.155F)},
                                {-0.04F, user.length(0.16F)},
                                {-0.02F, user.length(0.16F)},
                                {0.0F, user.length(0.155F)},
                                {0.02F, user.length(0.15F)},
                                {0.04F, user.length(0.14F)},
                                {0.06F, user.length(0.13F)}},
                               75.0F);
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Frizz, scalar(0.15F));
                    partInTheMiddle(user, {.flatness = 0.6F});
                    cutFringe(
                        user,
                        {.lengthM = 0.066F, .depthM = 0.035F, .halfM = 0.046F, .longerM = 0.03F, .flatness = 0.75F});
                    loosenFringe(user, 0.5F, 40.0F);
                }};
    model::setHairType(style.settings, model::hairType("2B"));
    style.settings.nodesPerHair = 12;
    return style;
}

Style shag()
{
    Style style{.id = "shag",
                .name = "Shag",
                .tags = {QStringLiteral("medium"), QStringLiteral("wavy")},
                .settings = settingsOf(0.30F, 0.05F, 0.016F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.92F);
                    user.fill(MapKind::Colour, colour(0xFF6A4630));
                    cutToLine(user, -0.15F, 0.07F);
                    // Layers: shortest at the crown.
                    for (const float leftM : {0.0F, 0.02F, 0.04F})
                        user.brush(MapKind::Length, user.length(0.095F), {.sizeM = 0.06F, .hardness = 0.0F},
                                   user.overHead(leftM, 0.05F, -0.07F));
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Frizz, scalar(0.15F));
                    combBeforeEars(user);
                    cutFringe(
                        user,
                        {.lengthM = 0.058F, .depthM = 0.045F, .halfM = 0.041F, .longerM = 0.02F, .flatness = 0.75F});
                    loosenFringe(user, 0.45F, 38.0F);
                }};
    model::setHairType(style.settings, model::hairType("2C"));
    style.settings.curl.gather = 0.8F;
    style.settings.locks = {.sizeM = 0.015F, .ragged = 0.5F, .parting = 0.45F};
    style.settings.variation.length = 0.15F;
    style.settings.variation.mostShorterM = 0.03F;
    style.settings.nodesPerHair = 12;
    return style;
}

Style curlyBob()
{
    Style style{.id = "curly-bob",
                .name = "Curly bob",
                .tags = {QStringLiteral("medium"), QStringLiteral("curly")},
                .settings = settingsOf(0.25F, 0.05F, 0.020F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.8F);
                    user.fill(MapKind::Colour, colour(0xFF2E1C16));
                    cutToLine(user, -0.075F, 0.05F);
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Frizz, scalar(0.08F));
                    user.setMirror(false);
                    user.part({.reachM = 0.12F, .flatness = 0.75F}, user.overHead(0.028F, 0.06F, -0.05F));
                }};
    model::setHairType(style.settings, model::hairType("3B"));
    style.settings.variation.partGapM = 0.0F;
    style.settings.variation.crossing = 0.02F;
    style.settings.nodesPerHair = 12;
    return style;
}

} // namespace hairpaint::presets
