// Styles of curled and coiled hair.
#include "model/project/hair_types.h"
#include "strokes.h"
#include "styles.h"

#include <array>
#include <utility>

namespace hairpaint::presets {

namespace {

constexpr std::array<Recording::Seen, 11> kFrontHairline{{{0.0F, 0.075F},
                                                          {12.0F, 0.075F},
                                                          {23.0F, 0.0765F},
                                                          {35.0F, 0.0755F},
                                                          {43.0F, 0.066F},
                                                          {47.0F, 0.053F},
                                                          {49.0F, 0.040F},
                                                          {55.0F, 0.027F},
                                                          {62.0F, 0.014F},
                                                          {68.0F, 0.0F},
                                                          {72.0F, -0.018F}}};

} // namespace

Style ringlets()
{
    Style style{.id = "ringlets",
                .name = "Ringlets",
                .tags = {QStringLiteral("medium"), QStringLiteral("curly")},
                .settings = settingsOf(0.30F, 0.05F, 0.020F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.75F);
                    user.fill(MapKind::Colour, colour(0xFF703018));
                    cutToLine(user, -0.13F, 0.06F);
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Frizz, scalar(0.06F));
                }};
    model::setHairType(style.settings, model::hairType("3B"));
    style.settings.curl.diameterM = 0.020F;
    style.settings.curl.pitchM = 0.050F;
    style.settings.curl.inStepFromM = 0.010F;
    style.settings.curl.skips = 0.025F;
    style.settings.curl.gather = 0.96F;
    style.settings.locks = {.sizeM = 0.020F, .parting = 0.15F};
    // Locks hold together: what differs within one blurs it.
    style.settings.variation.crossing = 0.02F;
    style.settings.variation.curl = 0.05F;
    style.settings.variation.flyaways = 0.006F;
    style.settings.variation.partGapM = 0.0F; // Curls close over it.
    style.settings.nodesPerHair = 12;
    return style;
}

Style afro()
{
    Style style{.id = "round-afro",
                .name = "Round afro",
                .tags = {QStringLiteral("short"), QStringLiteral("coily")},
                .settings = settingsOf(0.12F, 0.10F, 0.0F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.8F);
                    user.fill(MapKind::Colour, colour(0xFF241712));
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Frizz, scalar(0.4F));
                    user.fill(MapKind::Gel, scalar(0.92F));
                    user.fill(MapKind::Direction, upright());
                    // Cut to a ball that leaves the face free.
                    user.fill(MapKind::Length, user.length(0.098F));
                    user.bands(MapKind::Length,
                               {{-0.075F, user.length(0.016F)},
                                {-0.06F, user.length(0.024F)},
                                {-0.045F, user.length(0.040F)},
                                {-0.03F, user.length(0.055F)},
                                {-0.015F, user.length(0.068F)},
                                {0.0F, user.length(0.079F)},
                                {0.015F, user.length(0.086F)},
                                {0.03F, user.length(0.092F)}},
                               92.0F);
                    for (const auto& [sizeM, lengthM] :
                         {std::pair(0.14F, 0.088F), std::pair(0.11F, 0.070F), std::pair(0.08F, 0.048F),
                          std::pair(0.055F, 0.030F), std::pair(0.03F, 0.016F)})
                        user.brush(MapKind::Length, user.length(lengthM), {.sizeM = sizeM, .hardness = 0.0F},
                                   user.along(kFrontHairline));
                }};
    // A sponge of coils that are out of step for most of their length, and in which nothing is combed.
    model::setHairType(style.settings, model::hairType("4A"));
    style.settings.curl.diameterM = 0.008F;
    style.settings.curl.pitchM = 0.010F;
    style.settings.curl.inStepFromM = 0.06F;
    style.settings.curl.switchbacksPerM = 40.0F;
    style.settings.curl.skips = 0.15F;
    style.settings.curl.gather = 0.6F;
    style.settings.locks = {.sizeM = 0.012F, .small = 0.5F, .ragged = 0.8F, .parting = 0.8F};
    style.settings.variation.curl = 0.4F;
    style.settings.variation.crossing = 0.3F;
    style.settings.material.shine = 0.25F;
    return style;
}

} // namespace hairpaint::presets
