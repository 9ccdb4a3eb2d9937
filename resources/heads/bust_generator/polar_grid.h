// Half of the bust as a grid: rings around a pole at the crown, columns from the face's middle (0) over the left side
// to the back's middle (`columns`). Ring 0 is the pole, the last ring lies in the base's plane.
//
// Metres. The other half is the mirror image, so columns below 0 and beyond the last one are read as mirrored points.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "bust_shape.h"

namespace hairpaint::heads {

class PolarGrid
{
public:
    PolarGrid(int columns, int rings)
        : m_columns(columns), m_rings(rings),
          m_points(static_cast<std::size_t>(columns + 1) * static_cast<std::size_t>(rings + 1))
    {}

    int columns() const { return m_columns; }
    int rings() const { return m_rings; }
    glm::vec3& at(int ring, int column) { return m_points[index(ring, column)]; }
    const glm::vec3& at(int ring, int column) const { return m_points[index(ring, column)]; }
    glm::vec3 mirrored(int ring, int column) const;
    std::size_t index(int ring, int column) const
    {
        return static_cast<std::size_t>(ring) * static_cast<std::size_t>(m_columns + 1) +
               static_cast<std::size_t>(column);
    }

private:
    int m_columns;
    int m_rings;
    std::vector<glm::vec3> m_points;
};

// Shot at the earless shape from a bent axis: evenly spread rays that meet the surface once.
PolarGrid startGrid(int columns, int rings);

// Twice the columns and rings, put back on the surface.
PolarGrid refined(const PolarGrid& grid, const ShapeOptions& options);

// Every second ring and column.
PolarGrid coarsened(const PolarGrid& grid);

// Moves a point to the surface in two Newton steps of at most 3 mm each, inside the planes it belongs to.
glm::vec3 onSurface(glm::vec3 p, const ShapeOptions& options, bool isBase, bool isMiddle);

} // namespace hairpaint::heads
