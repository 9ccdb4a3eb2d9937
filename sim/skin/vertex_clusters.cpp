// Cells of a grid that becomes coarser until they are few enough.
#include "sim/skin/vertex_clusters.h"

#include "sim/skin/mesh_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace hairpaint::sim {

namespace {

constexpr int kAxisBits = 20;
constexpr float kMostCells = static_cast<float>(1 << kAxisBits) - 1.0F;

/// The cell, and into which octant the skin faces there, so that the two sides of an ear stay apart.
std::uint64_t clusterKeyOf(glm::vec3 inCells, glm::vec3 normal)
{
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto cell = static_cast<std::uint64_t>(std::clamp(inCells[axis], 0.0F, kMostCells));
        key = (key << (kAxisBits + 1)) | (cell << 1U) | (normal[axis] < 0.0F ? 1U : 0U);
    }
    return key;
}

} // namespace

CoarseMesh coarsened(const HeadMesh& mesh, std::size_t mostVertices)
{
    CoarseMesh coarse;
    const std::size_t count = mesh.positionsHd.size();
    coarse.clusterOf.resize(count);
    const MeshBounds bounds = boundsOf(mesh);
    const glm::vec3 size = bounds.size();
    // As many cells as that lie on the skin of a box.
    const float areaM2 = 2.0F * (size.x * size.y + size.y * size.z + size.z * size.x);
    float cellM = std::max(std::sqrt(areaM2 / static_cast<float>(mostVertices)), 1e-9F);
    std::unordered_map<std::uint64_t, unsigned> clusters;
    std::vector<float> members;
    constexpr float kCoarser = 1.25F;
    for (bool fits = false; !fits; cellM *= kCoarser) {
        clusters.clear();
        members.clear();
        coarse.mesh.positionsHd.clear();
        fits = true;
        for (std::size_t i = 0; i < count && fits; ++i) {
            const glm::vec3 inCells = (mesh.positionsHd[i] - bounds.least) / cellM;
            const auto next = static_cast<unsigned>(clusters.size());
            const unsigned cluster = clusters.try_emplace(clusterKeyOf(inCells, mesh.normalsHd[i]), next).first->second;
            if (cluster == next) {
                coarse.mesh.positionsHd.emplace_back(0.0F);
                members.push_back(0.0F);
                // Eight octants leave eight in one cell at the end.
                fits = clusters.size() <= std::max<std::size_t>(mostVertices, 8);
            }
            coarse.clusterOf[i] = cluster;
            coarse.mesh.positionsHd[cluster] += mesh.positionsHd[i];
            members[cluster] += 1.0F;
        }
    }
    for (std::size_t cluster = 0; cluster < members.size(); ++cluster)
        coarse.mesh.positionsHd[cluster] /= members[cluster];
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::uvec3 t(coarse.clusterOf[triangle.x], coarse.clusterOf[triangle.y], coarse.clusterOf[triangle.z]);
        if (t.x != t.y && t.y != t.z && t.z != t.x)
            coarse.mesh.triangles.push_back(t);
    }
    return coarse;
}

} // namespace hairpaint::sim
