// What the tests measure on the built-in heads.
//
// Skin areas in square metres, uv areas in uv units.
#pragma once

#include <utility>
#include <vector>

#include "glb_reader.h"

namespace hairpaint::tests {

struct FaceMeasure
{
    double skinArea;
    double uvArea;  // negative where the triangle is flipped
    double stretch; // ratio of the singular values of the map from skin to uv
    double aspect;  // longest edge over the height on it
};

FaceMeasure measured(const GlbMesh& mesh, const std::array<std::uint32_t, 3>& triangle);

glm::vec3 faceCentre(const GlbMesh& mesh, const std::array<std::uint32_t, 3>& triangle);
glm::vec3 faceNormal(const GlbMesh& mesh, const std::array<std::uint32_t, 3>& triangle);

// The value that the given part of the total weight lies below; entries are value and weight.
double quantile(std::vector<std::pair<double, double>> entries, double part);

// Points of a lattice over the uv square that lie inside more than one triangle. resolution: points per side.
int doublyCoveredPoints(const GlbMesh& mesh, int resolution);

} // namespace hairpaint::tests
