// A mesh's inside as a grid of cells.
#pragma once

#include "sim/skin/going_on.h"
#include "sim/skin/head_mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace hairpaint::sim {

/// Cells whose middle lies inside the mesh. A head is often open at its base, so a cell counts where rays along x and
/// along z both cross the surface an odd number of times on one side.
struct SolidGrid
{
    glm::vec3 originHd{0.0F}; ///< Middle of the first cell.
    float cellM = 0.0F;
    glm::ivec3 size{0};
    std::vector<std::uint8_t> inside; ///< [z][y][x]

    [[nodiscard]] std::size_t indexOf(glm::ivec3 cell) const
    {
        return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(size.y) +
                static_cast<std::size_t>(cell.y)) *
                   static_cast<std::size_t>(size.x) +
               static_cast<std::size_t>(cell.x);
    }
    [[nodiscard]] glm::vec3 middleHd(glm::ivec3 cell) const { return originHd + glm::vec3(cell) * cellM; }
};

/// `cells` along the longest side of the mesh's box, with an empty border around it. Where `goingOn` is refused the
/// grid is empty.
[[nodiscard]] SolidGrid solidGridOf(const HeadMesh& mesh, int cells, GoingOn& goingOn);

/// For every cell that is marked, its distance in cells to the nearest that is not, roughly; 0 for the others.
[[nodiscard]] std::vector<int> depthsOf(const SolidGrid& grid, const std::vector<std::uint8_t>& marked);

} // namespace hairpaint::sim
