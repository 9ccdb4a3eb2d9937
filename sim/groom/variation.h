// How a hair differs from what the maps say, by its rank: no two hairs of a head are alike.
#pragma once

#include "sim/groom/group_settings.h"
#include "sim/skin/skin_frame.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace hairpaint::sim {

/// What chance does to one hair; always the same for a seed and a rank. Each amount of the settings changes its own
/// member alone, and leaves it neutral where it is 0.
struct HairVariation
{
    float length = 1.0F;    ///< Factor; see lengthLeft().
    float turns = 1.0F;     ///< Factor.
    float radius = 1.0F;    ///< Factor, of the curl.
    float width = 1.0F;     ///< Factor.
    float acrossRad = 0.0F; ///< The whole hair is turned by that around the skin's normal at its root;
    float leanRad = 0.0F;   ///< as far as it stands, to the normal or away from it;
    float liftRad = 0.0F;   ///< and off the skin.
    float babyM = 0.0F;     ///< Length, at most, of a baby hair, which curls a little by itself; else 0.
    bool isFlyaway = false; ///< Keeps to no lock.
    bool isGrey = false;

    [[nodiscard]] bool isTurned() const { return acrossRad != 0.0F || leanRad != 0.0F || liftRad != 0.0F; }
};
[[nodiscard]] HairVariation variationOf(const VariationSettings& settings, std::uint64_t seed, std::uint32_t rank);
/// Of that the curl alone: its turns and its radius.
[[nodiscard]] HairVariation curlVariationOf(const VariationSettings& settings, std::uint64_t seed, std::uint32_t rank);

/// -1..1 over the skin, smooth over some 2 cm.
[[nodiscard]] float wavering(glm::vec3 positionHd, float phase);

/// Fraction of `settings.parting` by which the line of a parting wavers at most: along the frame's x by wavering() of
/// phase 0, along its y of this one.
inline constexpr float kPartWavers = 0.4F;
inline constexpr float kPartAlongPhase = 2.1F;

/// From a root to where on the skin beside it the hair takes its direction from, at most `settings.parting` away: near
/// a parting some lie to the other side, and the line between the sides wavers. Hd, m.
[[nodiscard]] glm::vec3 strayOf(const VariationSettings& settings, std::uint64_t seed, std::uint32_t rank,
                                glm::vec3 rootHd, const SkinFrame& frame);

/// What is left of a hair of `lengthM` at a root: `own.length`, at most `settings.mostShorterM` shorter where that is
/// not 0, and less in patches.
[[nodiscard]] float lengthLeft(const VariationSettings& settings, float ownLength, float lengthM, glm::vec3 rootHd);
/// The `lengthM` of which lengthLeft() leaves `leftM`, m; infinite where it leaves nothing of any length.
[[nodiscard]] float lengthBefore(const VariationSettings& settings, float ownLength, float leftM, glm::vec3 rootHd);
/// What patches leave of the density at a root: exactly 1 without.
[[nodiscard]] float densityLeft(const VariationSettings& settings, glm::vec3 rootHd);

/// sRGB as encoded: the hair without its pigment, `chance` in -1..1 lighter.
[[nodiscard]] glm::vec3 greyed(glm::vec3 colour, float chance);

} // namespace hairpaint::sim
