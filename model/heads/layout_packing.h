// Layouts of several parts side by side on one map, and what of a layout is laid over other skin. Any thread.
#pragma once

#include "model/heads/rigged_mesh.h"

#include <span>
#include <vector>

namespace hairpaint::model {

/// A part's vertices and triangles in its mesh.
struct PartRange
{
    std::size_t firstVertex = 0, vertices = 0, firstTriangle = 0, triangles = 0;
};
[[nodiscard]] std::vector<PartRange> rangesOf(const RiggedMesh& mesh);

/// `grown`: the mesh's first parts, which are not among its parts yet. Returns them as one. Where they have more than
/// one layout, each becomes a cell of a square of as many rows as columns, those of lower tiles first, from the lower
/// left, and so do the textures; uvs are changed, and the mesh's tiles are those of the cells.
[[nodiscard]] MeshPart withPackedLayouts(RiggedMesh& mesh, std::span<const MeshPart> grown);

/// How much of what a layout covers lies over other skin.
struct LayoutOverlap
{
    double fraction = 0.0;   ///< 0..1
    bool isMirrored = false; ///< Mostly left and right.
};
[[nodiscard]] LayoutOverlap overlapOf(const sim::HeadMesh& mesh);
/// What is told of: less is where seams meet.
inline constexpr double kNotableOverlap = 0.02;

} // namespace hairpaint::model
