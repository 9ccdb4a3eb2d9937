// Newton steps along a line.
#include "edge_displacement.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>

#include "bust_shape.h"
#include "parallel_for.h"
#include "sim/skin/mesh_subdivision.h"

namespace hairpaint::heads {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

float displacement(const sim::EdgeMiddle& middle, float most)
{
    constexpr int steps = 6;
    constexpr float gradientStep = 0.0002F;
    float along = 0.0F;
    for (int i = 0; i < steps; ++i) {
        const glm::vec3 p = middle.positionHd + along * middle.normalHd;
        const float slope = glm::dot(bustGradient(p, {}, gradientStep), middle.normalHd);
        along = std::clamp(along - bustDistance(p, {}) / std::max(slope, 0.3F), -most, most);
    }
    return along;
}

} // namespace

std::vector<std::int16_t> edgeDisplacements(const sim::HeadMesh& mesh)
{
    const std::vector<std::pair<unsigned, unsigned>> edges = sim::edgesOf(mesh);
    std::vector<std::int16_t> displacements(edges.size());
    parallelFor(static_cast<int>(edges.size()), [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        sim::EdgeMiddle middle = sim::middleOf(mesh, edges[k]);
        if (middle.positionHd.x < 0.0F) {
            middle.positionHd.x = -middle.positionHd.x;
            middle.normalHd.x = -middle.normalHd.x;
        }
        const float length = glm::distance(mesh.positionsHd[edges[k].first], mesh.positionsHd[edges[k].second]);
        const bool isBase = middle.positionHd.y <= baseHeight + 1.0e-6F;
        const float most = isBase ? 0.0F : length / 3.0F;
        displacements[k] = static_cast<std::int16_t>(std::lround(1.0e6F * displacement(middle, most)));
    });
    return displacements;
}

bool writeDisplacements(const std::vector<std::int16_t>& displacements, const std::filesystem::path& path)
{
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(displacements.data()),
               static_cast<std::streamsize>(displacements.size() * sizeof(std::int16_t)));
    return static_cast<bool>(file.flush());
}

} // namespace hairpaint::heads
