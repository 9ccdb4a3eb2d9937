// Relaxation and the schedule that grows the ears.
#include "grid_relaxer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "parallel_for.h"
#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

struct DensitySpot
{
    float weight;
    glm::vec3 centre; // on the left side, m
    float radius;     // m
};

constexpr std::array<DensitySpot, 8> densitySpots = {{{1.6F, {0.0F, -0.030F, 0.100F}, 0.075F},
                                                      {5.0F, {0.031F, -0.003F, 0.083F}, 0.019F},
                                                      {4.0F, {0.012F, -0.069F, 0.093F}, 0.020F},
                                                      {1.5F, {0.0F, -0.105F, 0.085F}, 0.030F},
                                                      {3.0F, {0.008F, -0.045F, 0.098F}, 0.014F},
                                                      {4.5F, {0.082F, -0.016F, -0.016F}, 0.032F},
                                                      {4.0F, {0.074F, -0.044F, -0.006F}, 0.012F},
                                                      {0.6F, {0.0F, -0.330F, -0.038F}, 0.080F}}};

float densityAt(const glm::vec3& p)
{
    const glm::vec3 folded(std::abs(p.x), p.y, p.z);
    float density = 1.0F;
    for (const DensitySpot& spot : densitySpots)
        density += spot.weight * bell(folded, spot.centre, glm::vec3(spot.radius));
    return density;
}

} // namespace

GridRelaxer::GridRelaxer(PolarGrid& grid) : m_grid(grid)
{
    measureRings();
}

void GridRelaxer::measureRings()
{
    const int rings = m_grid.rings();
    const int columns = m_grid.columns();
    const std::size_t size = static_cast<std::size_t>(rings) + 1;
    std::vector<float> radius(size, 0.0F);
    std::vector<float> spacing(size, 0.0F);
    for (int i = 1; i <= rings; ++i) {
        float around = 0.0F;
        float down = 0.0F;
        for (int j = 0; j < columns; ++j)
            around += glm::distance(m_grid.at(i, j + 1), m_grid.at(i, j));
        for (int j = 0; j <= columns; ++j)
            down += glm::distance(m_grid.at(i, j), m_grid.at(i - 1, j));
        radius[static_cast<std::size_t>(i)] = around / std::numbers::pi_v<float>;
        spacing[static_cast<std::size_t>(i)] = down / static_cast<float>(columns + 1);
    }
    for (int pass = 0; pass < rings / 8; ++pass) {
        const std::vector<float> oldRadius = radius;
        const std::vector<float> oldSpacing = spacing;
        for (std::size_t i = 1; i + 1 < size; ++i) {
            radius[i] = 0.25F * oldRadius[i - 1] + 0.5F * oldRadius[i] + 0.25F * oldRadius[i + 1];
            if (i > 1)
                spacing[i] = 0.25F * oldSpacing[i - 1] + 0.5F * oldSpacing[i] + 0.25F * oldSpacing[i + 1];
        }
    }
    const float angle = std::numbers::pi_v<float> / static_cast<float>(columns);
    m_acrossRing.assign(size, 0.0F);
    m_alongRing.assign(size, 0.0F);
    for (std::size_t i = 1; i < size; ++i) {
        m_acrossRing[i] = 0.5F * (radius[i] + radius[i - 1]) * angle / spacing[i];
        const float height = i + 1 < size ? 0.5F * (spacing[i] + spacing[i + 1]) : 0.5F * spacing[i];
        m_alongRing[i] = height / (radius[i] * angle);
    }
}

float GridRelaxer::density(int ring, int column) const
{
    const int last = m_grid.columns();
    const int inside = column < 0 ? -column : (column > last ? 2 * last - column : column);
    return m_density[m_grid.index(ring, inside)];
}

glm::vec3 GridRelaxer::relaxedPoint(const PolarGrid& old, int ring, int column, float step,
                                    const ShapeOptions& options) const
{
    constexpr float gradientStep = 0.0006F;
    const bool isBase = ring == old.rings();
    const bool isMiddle = column == 0 || column == old.columns();
    const float ownDensity = density(ring, column);
    glm::vec3 sum(0.0F);
    float total = 0.0F;
    const auto pull = [&](int i, int j, float weight) {
        weight *= 0.5F * (ownDensity + density(i, j));
        sum += old.mirrored(i, j) * weight;
        total += weight;
    };
    const auto r = static_cast<std::size_t>(ring);
    pull(ring, column - 1, m_alongRing[r]);
    pull(ring, column + 1, m_alongRing[r]);
    if (!isBase) {
        pull(ring - 1, column, m_acrossRing[r]);
        pull(ring + 1, column, m_acrossRing[r + 1]);
    }
    glm::vec3 p = old.at(ring, column);
    glm::vec3 gradient = bustGradient(p, options, gradientStep);
    if (isBase)
        gradient.y = 0.0F;
    const glm::vec3 normal = gradient / (glm::length(gradient) + 1.0e-20F);
    glm::vec3 move = sum / total - p;
    move -= normal * glm::dot(move, normal);
    if (isBase)
        move.y = 0.0F;
    p += move * step;
    p.x = isMiddle ? 0.0F : std::max(p.x, 1.0e-5F);
    return onSurface(p, options, isBase, isMiddle);
}

void GridRelaxer::relaxPole(const ShapeOptions& options)
{
    const int columns = m_grid.columns();
    glm::vec3 sum(0.0F);
    for (int j = 0; j <= columns; ++j) {
        const glm::vec3& p = m_grid.at(1, j);
        sum += glm::vec3(0.0F, p.y, p.z) * (j == 0 || j == columns ? 0.5F : 1.0F);
    }
    const glm::vec3 pole = onSurface(sum / static_cast<float>(columns), options, false, true);
    for (int j = 0; j <= columns; ++j)
        m_grid.at(0, j) = pole;
}

void GridRelaxer::relax(int iterations, float step, const ShapeOptions& options)
{
    constexpr int densityInterval = 4;
    const int rings = m_grid.rings();
    const int columns = m_grid.columns();
    for (int iteration = 0; iteration < iterations; ++iteration) {
        if (iteration % densityInterval == 0) {
            m_density.resize(m_grid.index(rings, columns) + 1);
            for (int i = 0; i <= rings; ++i)
                for (int j = 0; j <= columns; ++j)
                    m_density[m_grid.index(i, j)] = densityAt(m_grid.at(i, j));
        }
        const PolarGrid old = m_grid;
        parallelFor(rings, [&](int i) {
            for (int j = 0; j <= columns; ++j)
                m_grid.at(i + 1, j) = relaxedPoint(old, i + 1, j, step, options);
        });
        relaxPole(options);
    }
}

PolarGrid bustGrid()
{
    constexpr float step = 0.6F;
    const ShapeOptions earless{.earGrowth = 0.0F};
    PolarGrid coarse = startGrid(40, 64);
    {
        GridRelaxer relaxer(coarse);
        relaxer.relax(150, step, earless);
        relaxer.measureRings();
        relaxer.relax(60, step, earless);
        for (int k = 1; k <= 10; ++k)
            relaxer.relax(30, step, {.earGrowth = 0.05F * static_cast<float>(k)});
    }
    PolarGrid middle = refined(coarse, {.earGrowth = 0.5F});
    {
        GridRelaxer relaxer(middle);
        relaxer.relax(30, step, {.earGrowth = 0.5F});
        for (int k = 1; k <= 20; ++k)
            relaxer.relax(8, step, {.earGrowth = 0.5F + 0.025F * static_cast<float>(k)});
        relaxer.relax(40, step, {});
    }
    PolarGrid fine = refined(middle, {});
    GridRelaxer relaxer(fine);
    relaxer.relax(40, 0.5F, {});
    return fine;
}

} // namespace hairpaint::heads
