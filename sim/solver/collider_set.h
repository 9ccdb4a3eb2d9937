// The head's ellipsoids and its skin as the kernels read them, and how close to them a strand may come.
#pragma once

#include "sim/skin/ellipsoid.h"
#include "sim/skin/skin_field.h"

#include <array>
#include <memory>
#include <span>

namespace hairpaint::sim {

inline constexpr int kMaxColliders = 80;

/// p lies on the ellipsoid where the quadratic form of p - centre is 1. Hd, m.
struct Collider
{
    std::array<float, 3> centre{};
    std::array<float, 3> squares{}; ///< The form's factors of x2, y2, z2, 1/m2,
    std::array<float, 3> mixed{};   ///< and of xy, xz, yz, 1/m2.
    float meanAxisM = 1.0F;
    friend bool operator==(const Collider&, const Collider&) = default;

    /// Whether its axes are x, y and z.
    [[nodiscard]] bool aligned() const { return mixed == std::array<float, 3>{}; }
    /// The form's value: of the ellipsoid scaled by s it is s2.
    [[nodiscard]] float radius2(glm::vec3 pHd) const;
    /// The nearest point outside the ellipsoid scaled by `scale`, to first order; pHd itself where it is outside.
    [[nodiscard]] glm::vec3 pushedOut(glm::vec3 pHd, float scale) const;
};

inline constexpr float kSkinClearanceM = 0.0003F; ///< Straight hair stays that far from the skin.

struct ColliderSet
{
    int count = 0;
    std::array<Collider, kMaxColliders> items{};
    SkinField skin;
    std::shared_ptr<const DistanceGrid> grid; ///< What `skin` reads; null: the ellipsoids alone keep hair out.
};

/// The first kMaxColliders of those that are finite; semi-axes are at least a millimetre.
[[nodiscard]] ColliderSet prepareColliders(std::span<const Ellipsoid> ellipsoids,
                                           std::shared_ptr<const DistanceGrid> grid = nullptr);

/// How much the ellipsoid is scaled for one strand. It passes through the strand's own root where the root lies near
/// it, since the ellipsoid only follows the skin roughly; no node of `restHd` (root first) is inside; and then it is
/// grown by `growthM`, the strand's height in the coat, as far as the second node lies outside.
[[nodiscard]] float strandScale(const Collider& collider, std::span<const glm::vec3> restHd, float growthM);

/// Fractions of a segment, from its parent node, at which strands are kept out of the skin; the first segment only at
/// its end.
inline constexpr std::array kSegmentParts{1.0F, 0.75F, 0.5F};

/// How far from the skin a strand stays that would be kept `wishedM` away: not so far that its shape at rest (root
/// first) would be moved, unless that shape leads through the skin or along it anyway. 0 without a grid.
[[nodiscard]] float skinClearance(const ColliderSet& colliders, std::span<const glm::vec3> restHd, float wishedM);

} // namespace hairpaint::sim
