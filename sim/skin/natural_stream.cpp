// Heat from the whorl, and its gradient.
#include "sim/skin/natural_stream.h"

#include "sim/base/deterministic.h"
#include "sim/skin/vertex_clusters.h"
#include "sim/skin/vertex_weld.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hairpaint::sim {

namespace {

constexpr float kGrownHeadM = 0.25F;  ///< Length from crown to chin of the head that the lengths here are for.
constexpr double kHeatReachM = 0.04;  ///< Square root of the time over which heat spreads (Crane et al. 2013).
constexpr float kSwirlReachM = 0.03F; ///< Distance from the whorl at which that is about gone.
constexpr int kSmoothings = 4;
constexpr std::size_t kMostHeated = 60'000; ///< Number of vertices above which a coarser mesh is heated.

struct NaturalWhorl
{
    glm::vec3 positionHd{0.0F};
    float scale = 1.0F; ///< Size of the head over a grown one's.
};

NaturalWhorl whorlOf(const Skin& skin, const std::optional<HeadLandmarks>& landmarks)
{
    if (landmarks) {
        const glm::vec3 crown = (*landmarks)[HeadLandmark::Crown];
        const float scale = std::max(glm::length(crown - (*landmarks)[HeadLandmark::Chin]) / kGrownHeadM, 1e-3F);
        const glm::vec3 behind = crown + glm::vec3(-0.006F, -0.004F, -0.012F) * scale;
        return {.positionHd = skin.nearest(behind).positionHd, .scale = scale};
    }
    const std::vector<glm::vec3>& positions = skin.mesh().positionsHd;
    const auto highest = std::ranges::max_element(positions, {}, &glm::vec3::y);
    return {.positionHd = highest != positions.end() ? *highest : glm::vec3(0.0F)};
}

/// How flat hair grows at a distance from the whorl: cosines of people's angles, 90 degrees there, 12 at the nape.
float flatnessAt(float distanceM)
{
    struct Row
    {
        float distanceM, flatness;
    };
    constexpr std::array kRows{Row{0.0F, 0.0F},   Row{0.003F, 0.35F}, Row{0.010F, 0.55F}, Row{0.030F, 0.72F},
                               Row{0.06F, 0.86F}, Row{0.10F, 0.94F},  Row{0.13F, 0.975F}, Row{0.25F, 0.975F},
                               Row{0.30F, 0.12F}}; // Past the neck nothing holds it.
    for (std::size_t i = 1; i < kRows.size(); ++i) {
        if (distanceM < kRows[i].distanceM) {
            const float t = (distanceM - kRows[i - 1].distanceM) / (kRows[i].distanceM - kRows[i - 1].distanceM);
            return kRows[i - 1].flatness + t * (kRows[i].flatness - kRows[i - 1].flatness);
        }
    }
    return kRows.back().flatness;
}

/// Heat at the welded vertices after it spread from the whorl; 0 where it does not come.
std::vector<double> heatFrom(glm::vec3 sourceHd, double reachM, const HeadMesh& mesh,
                             const std::vector<unsigned>& welded)
{
    const auto count = static_cast<Eigen::Index>(mesh.positionsHd.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(mesh.triangles.size() * 12);
    Eigen::VectorXd heat = Eigen::VectorXd::Zero(count);
    const double time = reachM * reachM;
    double nearest = 1e30;
    unsigned source = 0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const std::array<unsigned, 3> corner{welded[triangle.x], welded[triangle.y], welded[triangle.z]};
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
            continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const unsigned a = corner[(i + 1) % 3];
            const unsigned b = corner[(i + 2) % 3];
            const glm::dvec3 at(mesh.positionsHd[corner[i]]);
            const glm::dvec3 toA = glm::dvec3(mesh.positionsHd[a]) - at;
            const glm::dvec3 toB = glm::dvec3(mesh.positionsHd[b]) - at;
            const double twiceArea = glm::length(glm::cross(toA, toB));
            // Never negative, so that heat has no minimum of its own inside.
            const double weight = time * 0.5 * std::max(glm::dot(toA, toB) / std::max(twiceArea, 1e-16), 1e-3);
            entries.emplace_back(corner[i], corner[i], twiceArea / 6.0);
            entries.emplace_back(a, a, weight);
            entries.emplace_back(b, b, weight);
            entries.emplace_back(a, b, -weight);
            entries.emplace_back(b, a, -weight);
            const glm::dvec3 apart = at - glm::dvec3(sourceHd);
            if (const double square = glm::dot(apart, apart); square < nearest) {
                nearest = square;
                source = corner[i];
            }
        }
    }
    for (Eigen::Index i = 0; i < count; ++i)
        entries.emplace_back(i, i, 1e-14); // Vertices that no triangle uses.
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    heat[source] = 1.0;
    if (solver.info() == Eigen::Success)
        heat = solver.solve(heat).eval();
    return {heat.data(), heat.data() + count};
}

glm::vec3 unitOrZero(glm::dvec3 v)
{
    const double square = glm::dot(v, v);
    return square > 0.0 && std::isfinite(square) ? glm::vec3(v / std::sqrt(square)) : glm::vec3(0.0F);
}

/// Where heat falls fastest, the mean of the faces around each welded vertex.
std::vector<glm::vec3> awayFromHeat(const std::vector<double>& heat, const HeadMesh& mesh,
                                    const std::vector<unsigned>& welded)
{
    std::vector<glm::vec3> away(mesh.positionsHd.size(), glm::vec3(0.0F));
    for (const glm::uvec3& triangle : mesh.triangles) {
        const std::array<unsigned, 3> corner{welded[triangle.x], welded[triangle.y], welded[triangle.z]};
        const glm::dvec3 a(mesh.positionsHd[corner[0]]);
        const glm::dvec3 b(mesh.positionsHd[corner[1]]);
        const glm::dvec3 c(mesh.positionsHd[corner[2]]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double greatest = std::max({heat[corner[0]], heat[corner[1]], heat[corner[2]]});
        if (!(greatest > 0.0))
            continue;
        // In units of the face's own heat: far away it falls below what squares can hold.
        const glm::dvec3 gradient = glm::cross(normal, c - b) * (heat[corner[0]] / greatest) +
                                    glm::cross(normal, a - c) * (heat[corner[1]] / greatest) +
                                    glm::cross(normal, b - a) * (heat[corner[2]] / greatest);
        const glm::vec3 unit = -unitOrZero(gradient) * static_cast<float>(glm::length(normal));
        for (const unsigned vertex : corner)
            away[vertex] += unit;
    }
    return away;
}

glm::vec3 onTangentPlane(glm::vec3 v, glm::vec3 normal)
{
    return unitOrZero(glm::dvec3(v - normal * glm::dot(v, normal)));
}

/// [vertices] unit direction away from the whorl, at the welded vertices; zero where the heat does not come. The finest
/// meshes take a coarser one's, or the heat alone would take minutes.
std::vector<glm::vec3> awayFrom(const NaturalWhorl& whorl, const HeadMesh& mesh, const std::vector<unsigned>& welded)
{
    const double reachM = kHeatReachM * static_cast<double>(whorl.scale);
    if (mesh.positionsHd.size() <= kMostHeated)
        return awayFromHeat(heatFrom(whorl.positionHd, reachM, mesh, welded), mesh, welded);
    const CoarseMesh coarse = coarsened(mesh, kMostHeated);
    std::vector<unsigned> all(coarse.mesh.positionsHd.size());
    std::iota(all.begin(), all.end(), 0U);
    const std::vector<glm::vec3> coarseAway =
        awayFromHeat(heatFrom(whorl.positionHd, reachM, coarse.mesh, all), coarse.mesh, all);
    std::vector<glm::vec3> away(welded.size());
    for (std::size_t i = 0; i < away.size(); ++i)
        away[i] = coarseAway[coarse.clusterOf[welded[i]]];
    return away;
}

} // namespace

std::vector<glm::vec3> naturalStream(const Skin& skin, const std::optional<HeadLandmarks>& landmarks,
                                     const std::function<bool()>& goesOn)
{
    const HeadMesh& mesh = skin.mesh();
    const std::size_t count = mesh.positionsHd.size();
    const std::vector<unsigned> welded = weldedVertices(mesh);
    const NaturalWhorl whorl = whorlOf(skin, landmarks);
    std::vector<glm::vec3> direction = awayFrom(whorl, mesh, welded);
    if (goesOn && !goesOn())
        return {};
    std::vector<glm::vec3> normals(count, glm::vec3(0.0F));
    for (std::size_t i = 0; i < count; ++i)
        normals[welded[i]] += mesh.normalsHd[i];
    for (std::size_t i = 0; i < count; ++i) {
        normals[i] = unitOrZero(glm::dvec3(normals[i]));
        // What is apart from the head, such as an eye's globe, has hair that hangs.
        if (direction[i] == glm::vec3(0.0F))
            direction[i] = glm::vec3(0.0F, -1.0F, 0.0F);
        direction[i] = onTangentPlane(direction[i], normals[i]);
    }
    for (int pass = 0; pass < kSmoothings; ++pass) {
        std::vector<glm::vec3> sum = direction;
        for (const glm::uvec3& triangle : mesh.triangles)
            for (int i = 0; i < 3; ++i)
                for (int j = 1; j < 3; ++j)
                    sum[welded[triangle[i]]] += 0.5F * direction[welded[triangle[(i + j) % 3]]];
        for (std::size_t i = 0; i < count; ++i)
            direction[i] = onTangentPlane(sum[i], normals[i]);
    }
    std::vector<glm::vec3> stream(count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 normal = normals[welded[i]];
        const glm::vec3 along = direction[welded[i]];
        const float distance = glm::length(mesh.positionsHd[i] - whorl.positionHd) / whorl.scale;
        const float reach = distance / kSwirlReachM;
        const float turn = -kSwirlRad * expDet(-std::min(reach * reach, 40.0F)); // Clockwise, seen from outside.
        const glm::vec3 turned = along * cosDet(turn) + glm::cross(normal, along) * sinDet(turn);
        stream[i] = turned * flatnessAt(distance);
    }
    return stream;
}

} // namespace hairpaint::sim
