// In which direction hair grows at a point of the head, by how long it is.
#pragma once

#include "sim/groom/direction_texel.h"
#include "sim/skin/skin_frame.h"

namespace hairpaint::sim {

/// Vectors along the skin, Hd; the length is the cosine of the angle to the skin, 0 where hair stands upright, at most
/// 1.
struct GrowthDirections
{
    glm::vec3 grownHd{0.0F};  ///< How short hair lies: as painted, or natural.
    glm::vec3 fallenHd{0.0F}; ///< How long hair lies: where nobody combed, to its own side of the middle.

    /// `falls`: fallFraction() of the hair's length. Hair between the two turns from one to the other; their mean alone
    /// would stand where they are opposed.
    [[nodiscard]] glm::vec3 of(float falls) const;
    friend bool operator==(const GrowthDirections&, const GrowthDirections&) = default;
};

/// How far hair of a length lies as it falls rather than as it grows, 0..1.
[[nodiscard]] float fallFraction(float lengthM);

/// Whether somebody has combed there, 1 where nobody has to 0: whether the map shows something else than the stream.
[[nodiscard]] float uncombed(DirectionVector painted, DirectionVector natural);

/// The directions at a point of the skin, from the map's vector and the head's natural stream (null where there is
/// none).
[[nodiscard]] GrowthDirections growthDirections(DirectionVector painted, const DirectionVector* natural,
                                                glm::vec3 positionHd, const SkinFrame& frame);

} // namespace hairpaint::sim
