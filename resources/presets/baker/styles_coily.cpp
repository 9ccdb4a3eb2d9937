// Coily hair that was shaped: twisted and let out, brushed into waves.
#include "model/project/hair_types.h"
#include "sim/base/rounded.h"
#include "strokes.h"
#include "styles.h"

#include <numbers>

namespace hairpaint::presets {

namespace {

/// A ring around the crown, so far from it over the skin, that wavers.
Recording::Points aroundWhorl(const Recording& user, float fromCrownM, int number)
{
    constexpr float kRadiusM = 0.095F; // Radius of the head.
    constexpr float kWaverM = 0.0012F;
    constexpr int kSteps = 48;
    const glm::vec3 centreHd(0.0F, 0.02F, -0.015F);
    const glm::vec3 crown = glm::normalize(glm::vec3(0.0F, 0.090F, -0.026F));
    const glm::vec3 left(1.0F, 0.0F, 0.0F);
    const glm::vec3 forward = glm::cross(left, crown);
    Recording::Points ring;
    ring.reserve(kSteps + 1);
    for (int i = 0; i <= kSteps; ++i) {
        const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kSteps;
        const float waver = kWaverM * (sim::sinRounded(5.0F * turn + 1.7F * static_cast<float>(number)) +
                                       sim::sinRounded(8.0F * turn + 2.9F * static_cast<float>(number)));
        const float polar = (fromCrownM + waver) / kRadiusM;
        ring.push_back(user.outward(centreHd, crown * sim::cosRounded(polar) +
                                                  (forward * sim::cosRounded(turn) + left * sim::sinRounded(turn)) *
                                                      sim::sinRounded(polar)));
    }
    return ring;
}

} // namespace

Style twistOut()
{
    Style style{.id = "twist-out",
                .name = "Twist-out",
                .tags = {QStringLiteral("medium"), QStringLiteral("coily")},
                .settings = settingsOf(0.20F, 0.06F, 0.020F),
                .record = [](Recording& user) {
                    user.setLayerOpacity(MapKind::Density, 0.85F);
                    user.fill(MapKind::Colour, colour(0xFF1C120E));
                    user.fill(MapKind::Length, user.length(0.15F));
                    user.bands(MapKind::Length,
                               {{-0.08F, user.length(0.06F)},
                                {-0.06F, user.length(0.07F)},
                                {-0.04F, user.length(0.085F)},
                                {-0.02F, user.length(0.10F)},
                                {0.0F, user.length(0.115F)},
                                {0.02F, user.length(0.125F)},
                                {0.04F, user.length(0.135F)}},
                               60.0F);
                    front(user, MapKind::Length, user.length(0.10F), 0.06F);
                    user.fill(MapKind::Curl, scalar(1.0F));
                    user.fill(MapKind::Frizz, scalar(0.08F));
                    user.setMirror(false);
                    user.part({.reachM = 0.09F, .flatness = 0.5F}, user.overHead(0.03F, 0.06F, -0.04F));
                }};
    model::setHairType(style.settings, model::hairType("4A"));
    style.settings.curl.diameterM = 0.013F;
    style.settings.curl.pitchM = 0.024F;
    style.settings.curl.inStepFromM = 0.008F;
    style.settings.curl.switchbacksPerM = 6.0F;
    style.settings.curl.skips = 0.03F;
    style.settings.curl.gather = 0.97F;
    style.settings.locks = {.sizeM = 0.017F, .small = 0.1F, .twistsPerM = 45.0F, .ragged = 0.1F, .parting = 0.25F};
    style.settings.variation.crossing = 0.03F;
    style.settings.variation.curl = 0.12F;
    style.settings.variation.partGapM = 0.0F;
    style.settings.nodesPerHair = 12;
    style.settings.material.shine = 0.45F;
    return style;
}

Style waves360()
{
    Style style{.id = "360-waves",
                .name = "360 waves",
                .tags = {QStringLiteral("short"), QStringLiteral("coily")},
                .settings = settingsOf(0.02F, 0.06F, 0.0F),
                .record = [](Recording& user) {
                    constexpr float kApartM = 0.011F;
                    constexpr int kRings = 18;
                    user.fill(MapKind::Colour, colour(0xFF090706));
                    user.fill(MapKind::Length, user.length(0.0028F));
                    user.setMirror(false);
                    for (int i = 1; i <= kRings; ++i) {
                        const Recording::Points crest = aroundWhorl(user, kApartM * static_cast<float>(i), i);
                        user.brush(MapKind::Length, user.length(0.0095F), {.sizeM = 0.008F, .hardness = 0.2F}, crest);
                        // Light lies on the crests.
                        user.brush(MapKind::Colour, colour(0xFF281F19), {.sizeM = 0.007F, .hardness = 0.0F}, crest);
                    }
                    user.setMirror(true);
                }};
    style.settings.hairline = {};
    style.settings.nodesPerHair = 6;
    style.settings.material.widthM = 100e-6F;
    style.settings.material.shine = 0.55F;
    return style;
}

} // namespace hairpaint::presets
