// Triangles over a polar grid: the left half with its columns thinned by powers of two near the pole, then mirrored.
//
// Half: vertices in ring order, the pole first. Whole: the left half, then the mirrored vertices that do not lie in the
// middle.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "polar_grid.h"
#include "sim/skin/head_mesh.h"

namespace hairpaint::heads {

using Triangle = std::array<std::uint32_t, 3>;

struct HalfMesh
{
    struct GridIndex
    {
        int ring;
        int column;
    };

    std::vector<GridIndex> indices;
    std::vector<glm::vec3> positions; // m
    std::vector<glm::vec3> normals;   // unit, the distance's gradient
    std::vector<glm::dvec2> uvs;      // relative to the pole, u > 0
    std::vector<Triangle> triangles;  // counter-clockwise from outside

    bool isMiddle(std::size_t vertex) const { return positions[vertex].x == 0.0F; }
};

// Vertices first, then triangles: quads are split so that no uv triangle flips, where uvs are there already.
HalfMesh halfVertices(const PolarGrid& grid);
void addTriangles(HalfMesh& half, const PolarGrid& grid);

// uv = 0.5 + half uv, on a lattice so that 1 - u is exact.
sim::HeadMesh mirroredMesh(const HalfMesh& half);

struct MeshReport
{
    float worstAspect;    // longest edge over the height on it
    float worstAgreement; // least cosine between a face and the surface's normal at its corners
    int foldedFaces;
};

MeshReport inspected(const HalfMesh& half);

} // namespace hairpaint::heads
