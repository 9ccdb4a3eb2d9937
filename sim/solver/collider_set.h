// The head's ellipsoids as the kernels read them, and how close to them a strand may come.
#pragma once

#include "sim/skin/ellipsoid.h"

#include <array>
#include <span>

namespace hairpaint::sim {

inline constexpr int kMaxColliders = 8;

/// `rows * (p - centre)` has length 1 where p lies on the ellipsoid. Hd, m.
struct Collider
{
    std::array<float, 3> centre{};
    std::array<std::array<float, 3>, 3> rows{};
    float meanAxisM = 1.0F;

    /// Squared length of `rows * (p - centre)`.
    [[nodiscard]] float radius2(glm::vec3 pHd) const;
    /// The nearest point outside the ellipsoid scaled by `scale`, to first order; pHd itself where it is outside.
    [[nodiscard]] glm::vec3 pushedOut(glm::vec3 pHd, float scale) const;
};

struct ColliderSet
{
    int count = 0;
    std::array<Collider, kMaxColliders> items{};
};

/// The first kMaxColliders of those that are finite; semi-axes are at least a millimetre.
[[nodiscard]] ColliderSet prepareColliders(std::span<const Ellipsoid> ellipsoids);

/// How much the ellipsoid is scaled for one strand. It passes through the strand's own root where the root lies near
/// it, since the ellipsoid only follows the skin roughly; no node of `restHd` (root first) is inside; and then it is
/// grown by `growthM`, the strand's height in the coat.
[[nodiscard]] float strandScale(const Collider& collider, std::span<const glm::vec3> restHd, float growthM);

} // namespace hairpaint::sim
