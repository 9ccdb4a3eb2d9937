// A grid over uv that says which faces may cover a point of the map.
#pragma once

#include "sim/skin/going_on.h"
#include "sim/skin/head_mesh.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace hairpaint::sim {

/// Keeps no reference to the mesh. Immutable. Its memory stays within 16 entries a face, whatever the uvs are.
class UvGrid
{
public:
    /// Where `goingOn` is refused the grid is of no use.
    UvGrid(const HeadMesh& mesh, GoingOn& goingOn);

    /// The lowest face that covers `uv`, with its barycentrics (all 0 or more); none off every island.
    [[nodiscard]] std::optional<std::pair<std::uint32_t, glm::vec3>> find(const HeadMesh& mesh, glm::vec2 uv) const;

private:
    struct CellRange
    {
        glm::ivec2 first, last;
    };
    [[nodiscard]] CellRange cellsOf(const HeadMesh& mesh, std::uint32_t face) const;
    [[nodiscard]] int cellOf(float offset, float scale) const;
    /// False for uvs beyond kFarthestUv.
    [[nodiscard]] static bool usable(const HeadMesh& mesh, std::uint32_t face);
    void chooseResolution(const HeadMesh& mesh, GoingOn& goingOn);

    int m_cellsAcross = 1;
    glm::vec2 m_lowestUv{0.0F};
    glm::vec2 m_highestUv{0.0F};
    glm::vec2 m_cellsPerUv{0.0F};
    std::vector<std::uint32_t> m_cellStart; ///< [cells + 1], into m_faces.
    std::vector<std::uint32_t> m_faces;     ///< Ascending within a cell.
};

} // namespace hairpaint::sim
