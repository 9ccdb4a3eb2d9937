// A cap over the skin for hair too short for strips.
#pragma once

#include "model/cards/sampled_hair.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// Hair shorter than this is drawn on a cap instead of strips, m.
inline constexpr float kShortestOnStripsM = 0.006F;

/// A piece of a head's skin, a little above it, spread out flat.
struct ScalpCap
{
    struct Vertex
    {
        glm::vec3 positionWo{0.0F};
        glm::vec3 normalWo{0.0F, 1.0F, 0.0F};
        glm::vec2 flatM{0.0F}; ///< See flat().
    };
    std::vector<Vertex> vertices;
    std::vector<glm::uvec3> triangles; ///< Counter-clockwise from outside.
    std::vector<std::uint32_t> hairs;  ///< Indices into SampledHair.
    glm::vec2 leastM{0.0F};            ///< Bounds of the flattened vertices.
    glm::vec2 greatestM{0.0F};
    glm::vec3 middleWo{0.0F}; ///< Centre of the projection, see flat().
    glm::vec3 axisWo{0.0F, 1.0F, 0.0F};
    float radiusM = 0.1F;

    /// Where a position lies on the flattened skin: as far from the middle as the angle from the axis tells, and at its
    /// own direction around it (azimuthal equidistant projection). Right is to the right, seen from outside, down is
    /// down.
    [[nodiscard]] glm::vec2 flat(const glm::vec3& positionWo) const;
    [[nodiscard]] glm::vec3 upWo() const; ///< What is up on the flattened skin, at the axis.
    /// 0..1 over its patch, v down; a coarser cap may reach over the borders of the finest, whose patch it shows.
    [[nodiscard]] glm::vec2 uv(const glm::vec2& flatM) const { return (flatM - leastM) / (greatestM - leastM); }
};

/// A cap over the skin where the roots of `hairs`, of one group, are, with at most `triangles`; none where there are no
/// hairs or the triangles are too few to cover any skin.
[[nodiscard]] std::optional<ScalpCap> capOver(const CurveSet& set, const SampledHair& hair,
                                              std::vector<std::uint32_t> hairs, int triangles);

} // namespace hairpaint::model
