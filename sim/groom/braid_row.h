// The course of a cornrow: along the middle of a painted strip, over the skin.
#pragma once

#include "sim/groom/roots.h"

#include <span>
#include <vector>

namespace hairpaint::sim {

/// Begins at the end that is higher, or of two as high the one further in front, and ends where its braid leaves the
/// skin. Hd, m.
struct BraidRow
{
    std::vector<glm::vec3> pointsHd;  ///< On the skin, evenly from its begin to its end,
    std::vector<glm::vec3> normalsHd; ///< and unit normals there. Two or more.
    float lengthM = 0.0F;
    float widthM = 0.0F;                ///< Of the strip, in the mean.
    glm::vec3 sideHd{1.0F, 0.0F, 0.0F}; ///< Unit: across it along the skin, in the mean.
    friend bool operator==(const BraidRow&, const BraidRow&) = default;
};

/// Through those roots, which lie evenly on a strip: by their distances over the skin from one of its ends.
[[nodiscard]] BraidRow rowAlong(const RootSet& roots, std::span<const std::uint32_t> slots);
/// The same through points of the skin, one or more, of which the first kMostRowPoints are looked at. `tangentHd`:
/// unit, along the skin; the direction of a row that is a single point.
[[nodiscard]] BraidRow rowAlong(const Skin& skin, std::span<const glm::vec3> strip, glm::vec3 tangentHd);
inline constexpr std::size_t kMostRowPoints = 512;

/// The nearest point of a row to another point, m.
struct RowPoint
{
    float alongM = 0.0F; ///< How far along the row it is,
    float asideM = 0.0F; ///< and how far away.
};
[[nodiscard]] RowPoint nearestOnRow(const BraidRow& row, glm::vec3 positionHd);

/// A point over the skin so far along it; beyond its end straight on.
[[nodiscard]] glm::vec3 onRow(const BraidRow& row, float alongM, float aboveM);

} // namespace hairpaint::sim
