// The head's ellipsoids and its skin as the kernels read them, and how close to them a strand may come.
#pragma once

#include "sim/skin/distance_grid.h"
#include "sim/skin/ellipsoid.h"

#include <array>
#include <cstdint>
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

/// A DistanceGrid, of which the kernels read two pairs at once.
struct SkinField
{
    const DistanceGrid::Pair* pairs = nullptr; ///< [z][y][x], null where there is no grid.
    std::array<float, 3> origin{};
    std::array<float, 3> last{}; ///< Coordinates in cells lie in 0..last, the end excluded.
    float inverseCell = 1.0F;    ///< 1/m
    std::int32_t row = 0;        ///< Pairs from one y to the next.
    std::int32_t slice = 0;      ///< Pairs from one z to the next.
    float unitsACell = 1.0F;     ///< A cell's side, in units of the values.
    /// A cell's diagonal in those units: no value in a cell differs by more from one at its corners.
    float unitsADiagonal = 1.0F;
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
