// The frame of directions at a point of the skin.
#pragma once

#include "sim/skin/skin.h"

namespace hairpaint::sim {

/// Unit vectors at right angles, Hd. +y goes up the map (along +dP/dv), also where the map is mirrored on the skin.
struct SkinFrame
{
    glm::vec3 x{1.0F, 0.0F, 0.0F}; ///< See SurfacePoint::tangentHd.
    glm::vec3 y{0.0F, 0.0F, -1.0F};
    glm::vec3 normal{0.0F, 1.0F, 0.0F};

    [[nodiscard]] static SkinFrame at(const SurfacePoint& point)
    {
        const glm::vec3 side = glm::cross(point.normalHd, point.tangentHd);
        const bool mirrored = glm::dot(glm::cross(point.dPduHd, point.dPdvHd), point.normalHd) < 0.0F;
        return {.x = point.tangentHd, .y = mirrored ? -side : side, .normal = point.normalHd};
    }

    /// A vector in the tangent plane, from the frame to Hd and back; what stands on the skin is left out.
    [[nodiscard]] glm::vec3 toHd(glm::vec2 inFrame) const { return x * inFrame.x + y * inFrame.y; }
    [[nodiscard]] glm::vec2 fromHd(glm::vec3 hd) const { return {glm::dot(hd, x), glm::dot(hd, y)}; }
};

} // namespace hairpaint::sim
