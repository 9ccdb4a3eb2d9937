// What the bust's uv layout should be like, region by region, and how well a layout does.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/heads/built_in_heads.h"
#include "sdf_primitives.h"
#include "uv_solver.h"

namespace hairpaint::heads {

namespace {

glm::vec3 centroid(const HalfMesh& half, const Triangle& t)
{
    return (half.positions[t[0]] + half.positions[t[1]] + half.positions[t[2]]) / 3.0F;
}

// 1 on the scalp and in a margin around it, 0 away from it.
double scalpness(const glm::vec3& p)
{
    return static_cast<double>(smoothStep(-0.012F, -0.002F, bust2().regions.scalpDistance(p)));
}

UvGoal goalAt(const glm::vec3& p)
{
    const glm::vec3 folded(std::abs(p.x), p.y, p.z);
    const auto scalp = scalpness(p);
    const auto face =
        static_cast<double>(smoothStep(0.000F, 0.030F, p.z) * smoothStep(-0.125F, -0.095F, p.y)) * (1.0 - scalp);
    const auto ear =
        static_cast<double>(bell(folded, {0.082F, -0.016F, -0.014F}, {0.016F, 0.035F, 0.024F})) * (1.0 - scalp);
    const auto trunk = static_cast<double>(1.0F - smoothStep(-0.20F, -0.11F, p.y));
    UvGoal goal{};
    const auto beard =
        static_cast<double>(smoothStep(-0.010F, 0.002F, bust2().regions.beardDistance(p))) * (1.0 - scalp);
    goal.scale = std::lerp(std::lerp(0.40 - 0.24 * trunk, 0.95, std::max(face, beard)), 1.0, scalp);
    goal.weight = (0.10 - 0.04 * trunk + 2.0 * std::max(face, beard) + 5.0 * scalp) * (1.0 - 0.7 * ear);
    goal.areaWeight = 2.0 * scalp;
    return goal;
}

struct Distortion
{
    double skinArea;
    double uvArea;
    double stretch;
};

Distortion distortion(const HalfMesh& half, const Triangle& t)
{
    const glm::dvec3 p = half.positions[t[0]];
    const glm::dvec3 first = glm::dvec3(half.positions[t[1]]) - p;
    const glm::dvec3 second = glm::dvec3(half.positions[t[2]]) - p;
    const glm::dvec2 firstUv = half.uvs[t[1]] - half.uvs[t[0]];
    const glm::dvec2 secondUv = half.uvs[t[2]] - half.uvs[t[0]];
    const double length = glm::length(first);
    const double along = glm::dot(second, first) / length;
    const double across = glm::length(glm::cross(first, second)) / length;
    const glm::dvec2 columnOne = firstUv / length;
    const glm::dvec2 columnTwo = (secondUv - columnOne * along) / across;
    // Singular values from the squares' sum and the determinant.
    const double squares = glm::dot(columnOne, columnOne) + glm::dot(columnTwo, columnTwo);
    const double det = columnOne.x * columnTwo.y - columnOne.y * columnTwo.x;
    const double spread = std::sqrt(std::max(squares * squares - 4.0 * det * det, 0.0));
    return {0.5 * length * across, 0.5 * length * across * det,
            std::sqrt((squares + spread) / std::max(squares - spread, 1.0e-30))};
}

// The value below which the given part of the weights lies.
double quantile(std::vector<std::pair<double, double>> valuesAndWeights, double part)
{
    std::sort(valuesAndWeights.begin(), valuesAndWeights.end());
    const double total = std::accumulate(valuesAndWeights.begin(), valuesAndWeights.end(), 0.0,
                                         [](double sum, const auto& entry) { return sum + entry.second; });
    double below = 0.0;
    for (const auto& [value, weight] : valuesAndWeights) {
        below += weight;
        if (below >= part * total)
            return value;
    }
    return valuesAndWeights.back().first;
}

} // namespace

UvReport measured(const HalfMesh& half)
{
    std::vector<std::pair<double, double>> scales;
    std::vector<std::pair<double, double>> stretches;
    double scalpUv = 0.0;
    double allUv = 0.0;
    for (const Triangle& t : half.triangles) {
        const Distortion d = distortion(half, t);
        allUv += d.uvArea;
        if (bust2().regions.scalpDistance(centroid(half, t)) <= 0.0F)
            continue;
        scalpUv += d.uvArea;
        scales.emplace_back(d.uvArea / d.skinArea, d.skinArea);
        stretches.emplace_back(d.stretch, d.skinArea);
    }
    UvReport report;
    report.scalpAreaRatio = quantile(scales, 1.0) / quantile(scales, 0.0);
    report.scalpAreaRatio99 = quantile(scales, 0.995) / quantile(scales, 0.005);
    report.scalpStretch = quantile(stretches, 1.0);
    report.scalpStretch99 = quantile(stretches, 0.99);
    report.scalpFraction = scalpUv / allUv;
    return report;
}

UvReport layOutBust(const PolarGrid& grid, HalfMesh& half)
{
    constexpr int rounds = 4;
    constexpr double halfWidth = 0.485;
    half.uvs = polarUvs(grid, half);
    std::vector<UvGoal> goals;
    for (const Triangle& t : half.triangles)
        goals.push_back(goalAt(centroid(half, t)));
    double energy = improveUvs(half, goals, 80);
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t t = 0; t < goals.size(); ++t) {
            const double stretch = distortion(half, half.triangles[t]).stretch;
            const double excess = std::max(stretch - 1.5, 0.0) * scalpness(centroid(half, half.triangles[t]));
            goals[t].weight *= 1.0 + std::min(2.0 * excess, 4.0);
        }
        energy = improveUvs(half, goals, 20);
    }
    double reach = 0.0;
    for (const glm::dvec2& uv : half.uvs)
        reach = std::max({reach, std::abs(uv.x), std::abs(uv.y)});
    for (glm::dvec2& uv : half.uvs)
        uv *= halfWidth / reach;
    UvReport report = measured(half);
    report.energy = energy;
    return report;
}

} // namespace hairpaint::heads
