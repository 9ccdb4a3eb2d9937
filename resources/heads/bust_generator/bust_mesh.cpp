// Thinning, triangles, mirroring.
#include "bust_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "parallel_for.h"

namespace hairpaint::heads {

namespace {

// Columns are kept in steps of a power of two that keeps a ring's quads about square near the pole.
int columnStep(int ring, int columns)
{
    const float room = 1.15F * static_cast<float>(columns) / (std::numbers::pi_v<float> * static_cast<float>(ring));
    int step = 1;
    while (step < 16 && static_cast<float>(step * 2) <= room)
        step *= 2;
    return step;
}

glm::vec3 faceNormal(const HalfMesh& half, const Triangle& t)
{
    const glm::vec3& a = half.positions[t[0]];
    return glm::cross(half.positions[t[1]] - a, half.positions[t[2]] - a);
}

// Least cosine between the face and its corners' normals.
float agreement(const HalfMesh& half, const Triangle& t)
{
    const glm::vec3 normal = faceNormal(half, t);
    float least = 1.0F;
    for (const std::uint32_t v : t)
        least = std::min(least, glm::dot(normal, half.normals[v]));
    return least / (glm::length(normal) + 1.0e-20F);
}

float aspect(const HalfMesh& half, const Triangle& t)
{
    float longest = 0.0F;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, glm::distance(half.positions[t[i]], half.positions[t[(i + 1) % 3]]));
    return longest * longest / (glm::length(faceNormal(half, t)) + 1.0e-20F);
}

bool isUvFlipped(const HalfMesh& half, const Triangle& t)
{
    if (half.uvs.empty())
        return false;
    const glm::dvec2 first = half.uvs[t[1]] - half.uvs[t[0]];
    const glm::dvec2 second = half.uvs[t[2]] - half.uvs[t[0]];
    return first.x * second.y <= first.y * second.x;
}

// By grid index; the pole has all of ring 0.
std::vector<std::uint32_t> verticesByPosition(const HalfMesh& half, const PolarGrid& grid)
{
    std::vector<std::uint32_t> ids(grid.index(grid.rings(), grid.columns()) + 1, 0);
    for (std::size_t v = 0; v < half.indices.size(); ++v)
        ids[grid.index(half.indices[v].ring, half.indices[v].column)] = static_cast<std::uint32_t>(v);
    return ids;
}

// Splits a quad along the diagonal that follows the surface better.
void addQuad(HalfMesh& half, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    const std::array<Triangle, 2> first = {{{a, b, c}, {a, c, d}}};
    const std::array<Triangle, 2> second = {{{a, b, d}, {b, c, d}}};
    const auto score = [&](const std::array<Triangle, 2>& pair) {
        const float shape = std::max(aspect(half, pair[0]), aspect(half, pair[1]));
        const float flip = isUvFlipped(half, pair[0]) || isUvFlipped(half, pair[1]) ? 10.0F : 0.0F;
        return std::min(agreement(half, pair[0]), agreement(half, pair[1])) - 0.02F * shape - flip;
    };
    const auto& best = score(first) >= score(second) ? first : second;
    half.triangles.insert(half.triangles.end(), best.begin(), best.end());
}

} // namespace

HalfMesh halfVertices(const PolarGrid& grid)
{
    const int columns = grid.columns();
    HalfMesh half;

    half.indices.push_back({0, 0});
    for (int i = 1; i <= grid.rings(); ++i)
        for (int j = 0; j <= columns; j += columnStep(i, columns))
            half.indices.push_back({i, j});
    half.positions.resize(half.indices.size());
    half.normals.resize(half.indices.size());
    parallelFor(static_cast<int>(half.indices.size()), [&](int v) {
        const auto k = static_cast<std::size_t>(v);
        half.positions[k] = grid.at(half.indices[k].ring, half.indices[k].column);
        glm::vec3 gradient = bustGradient(half.positions[k], {}, 0.0006F);
        if (half.isMiddle(k))
            gradient.x = 0.0F;
        half.normals[k] = glm::normalize(gradient);
    });

    return half;
}

void addTriangles(HalfMesh& half, const PolarGrid& grid)
{
    const int columns = grid.columns();
    const std::vector<std::uint32_t> ids = verticesByPosition(half, grid);
    const auto id = [&](int ring, int column) { return ids[grid.index(ring, column)]; };
    const int poleStep = columnStep(1, columns);
    for (int j = 0; j < columns; j += poleStep)
        half.triangles.push_back({0, id(1, j), id(1, j + poleStep)});
    for (int i = 1; i < grid.rings(); ++i) {
        const int upper = columnStep(i, columns);
        const int lower = columnStep(i + 1, columns);
        for (int j = 0; j < columns; j += upper) {
            if (upper == lower) {
                addQuad(half, id(i, j), id(i + 1, j), id(i + 1, j + upper), id(i, j + upper));
                continue;
            }
            // A fan to each end of the upper edge, and one triangle between the fans.
            const int middle = j + upper / lower / 2 * lower;
            for (int k = j; k < j + upper; k += lower)
                half.triangles.push_back({id(i, k < middle ? j : j + upper), id(i + 1, k), id(i + 1, k + lower)});
            half.triangles.push_back({id(i, j), id(i + 1, middle), id(i, j + upper)});
        }
    }
}

sim::HeadMesh mirroredMesh(const HalfMesh& half)
{
    // Multiples of 2^-22 near 0.5 are exact in float, and so is 1 minus them.
    constexpr double lattice = 4194304.0;
    sim::HeadMesh mesh;
    mesh.positionsHd = half.positions;
    mesh.normalsHd = half.normals;
    for (const Triangle& t : half.triangles)
        mesh.triangles.emplace_back(t[0], t[1], t[2]);
    for (const glm::dvec2& uv : half.uvs)
        mesh.uvs.emplace_back(0.5 + std::round(uv.x * lattice) / lattice, 0.5 + std::round(uv.y * lattice) / lattice);
    std::vector<std::uint32_t> twin(half.positions.size());
    for (std::size_t v = 0; v < half.positions.size(); ++v) {
        twin[v] = static_cast<std::uint32_t>(half.isMiddle(v) ? v : mesh.positionsHd.size());
        if (half.isMiddle(v))
            continue;
        const glm::vec3 p = half.positions[v];
        const glm::vec3 n = half.normals[v];
        const glm::vec2 uv = mesh.uvs[v];
        mesh.positionsHd.emplace_back(-p.x, p.y, p.z);
        mesh.normalsHd.emplace_back(-n.x, n.y, n.z);
        mesh.uvs.emplace_back(1.0F - uv.x, uv.y);
    }
    for (const Triangle& t : half.triangles)
        mesh.triangles.emplace_back(twin[t[0]], twin[t[2]], twin[t[1]]);
    return mesh;
}

MeshReport inspected(const HalfMesh& half)
{
    MeshReport report{0.0F, 1.0F, 0};
    for (const Triangle& t : half.triangles) {
        report.worstAspect = std::max(report.worstAspect, aspect(half, t));
        const float fit = agreement(half, t);
        report.worstAgreement = std::min(report.worstAgreement, fit);
        report.foldedFaces += fit <= 0.0F ? 1 : 0;
    }
    return report;
}

} // namespace hairpaint::heads
