// First grid, refinement, and the projection that keeps points on the surface.
#include "polar_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "parallel_for.h"
#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

// The axis from which the rings' rays start, by the ring's parameter s in [0, 1]: start height and depth (m), the
// axis's tilt backward, the ray's angle from the axis, and how much further it dips at the front (degrees).
struct AxisKey
{
    float s;
    float height;
    float depth;
    float tilt;
    float angle;
    float dip;
};

constexpr std::array<AxisKey, 12> axisKeys = {{{0.00F, 0.020F, -0.015F, 14.0F, 0.0F, 0.0F},
                                               {0.22F, 0.020F, -0.012F, 14.0F, 60.0F, 0.0F},
                                               {0.35F, 0.012F, -0.005F, 12.0F, 90.0F, 0.0F},
                                               {0.48F, -0.010F, 0.005F, 6.0F, 100.0F, 6.0F},
                                               {0.57F, -0.035F, 0.005F, 0.0F, 108.0F, 12.0F},
                                               {0.645F, -0.060F, -0.005F, 0.0F, 112.0F, 24.0F},
                                               {0.73F, -0.110F, -0.025F, 0.0F, 102.0F, 5.0F},
                                               {0.79F, -0.160F, -0.042F, 0.0F, 94.0F, 0.0F},
                                               {0.85F, -0.205F, -0.044F, 0.0F, 90.0F, 0.0F},
                                               {0.92F, -0.255F, -0.044F, 0.0F, 92.0F, 0.0F},
                                               {0.97F, -0.290F, -0.044F, 0.0F, 95.0F, 0.0F},
                                               {1.00F, baseHeight, -0.044F, 0.0F, 90.0F, 0.0F}}};

AxisKey axisAt(float s)
{
    std::size_t k = 0;
    while (k + 2 < axisKeys.size() && s > axisKeys[k + 1].s)
        ++k;
    const AxisKey& a = axisKeys[k];
    const AxisKey& b = axisKeys[k + 1];
    const float t = (s - a.s) / (b.s - a.s);
    return {s,
            glm::mix(a.height, b.height, t),
            glm::mix(a.depth, b.depth, t),
            glm::mix(a.tilt, b.tilt, t),
            glm::mix(a.angle, b.angle, t),
            glm::mix(a.dip, b.dip, t)};
}

glm::vec3 shotPoint(float s, float azimuth, const ShapeOptions& options)
{
    const AxisKey key = axisAt(s);
    const float frontness = 0.5F + 0.5F * std::cos(azimuth);
    const float angle = glm::radians(key.angle + key.dip * frontness * frontness);
    const float tilt = glm::radians(key.tilt);
    const glm::vec3 axis(0.0F, std::cos(tilt), -std::sin(tilt));
    const glm::vec3 front(0.0F, std::sin(tilt), std::cos(tilt));
    const glm::vec3 left(1.0F, 0.0F, 0.0F);
    const glm::vec3 ray =
        axis * std::cos(angle) + (front * std::cos(azimuth) + left * std::sin(azimuth)) * std::sin(angle);
    const glm::vec3 start(0.0F, key.height, key.depth);
    float reach = 0.34F;
    for (int i = 0; i < 300 && reach > 0.005F; ++i) {
        const float distance = bustDistance(start + ray * reach, options);
        if (distance < 2.0e-5F)
            break;
        reach -= distance * 0.7F;
    }
    return start + ray * reach;
}

} // namespace

glm::vec3 PolarGrid::mirrored(int ring, int column) const
{
    const bool isOutside = column < 0 || column > m_columns;
    const int inside = column < 0 ? -column : (column > m_columns ? 2 * m_columns - column : column);
    const glm::vec3& p = at(ring, inside);
    return isOutside ? glm::vec3(-p.x, p.y, p.z) : p;
}

PolarGrid startGrid(int columns, int rings)
{
    PolarGrid grid(columns, rings);
    const ShapeOptions options{.earGrowth = 0.0F};
    parallelFor(rings + 1, [&](int i) {
        for (int j = 0; j <= columns; ++j) {
            const float azimuth = std::numbers::pi_v<float> * static_cast<float>(j) / static_cast<float>(columns);
            glm::vec3 p = shotPoint(static_cast<float>(i) / static_cast<float>(rings), azimuth, options);
            if (j == 0 || j == columns)
                p.x = 0.0F;
            if (i == rings)
                p.y = baseHeight;
            grid.at(i, j) = p;
        }
    });
    return grid;
}

glm::vec3 onSurface(glm::vec3 p, const ShapeOptions& options, bool isBase, bool isMiddle)
{
    constexpr float gradientStep = 0.0002F;
    constexpr float longestStep = 0.003F;
    for (int i = 0; i < 2; ++i) {
        glm::vec3 gradient = bustGradient(p, options, gradientStep);
        if (isBase)
            gradient.y = 0.0F;
        if (isMiddle)
            gradient.x = 0.0F;
        glm::vec3 step = gradient * (bustDistance(p, options) / std::max(glm::dot(gradient, gradient), 0.04F));
        const float length = glm::length(step);
        if (length > longestStep)
            step *= longestStep / length;
        p -= step;
    }
    if (isBase)
        p.y = baseHeight;
    if (isMiddle)
        p.x = 0.0F;
    return p;
}

PolarGrid refined(const PolarGrid& grid, const ShapeOptions& options)
{
    PolarGrid fine(grid.columns() * 2, grid.rings() * 2);
    parallelFor(fine.rings() + 1, [&](int i) {
        for (int j = 0; j <= fine.columns(); ++j) {
            const int a = i / 2;
            const int b = j / 2;
            const auto between = [&](int ring) {
                return (grid.mirrored(ring, b) + grid.mirrored(ring, b + 1)) * 0.5625F -
                       (grid.mirrored(ring, b - 1) + grid.mirrored(ring, b + 2)) * 0.0625F;
            };
            glm::vec3 p = j % 2 == 0 ? grid.at(a, b) : between(a);
            if (i % 2 == 1)
                p = 0.5F * (p + (j % 2 == 0 ? grid.at(a + 1, b) : between(a + 1)));
            if (i > 0)
                p = onSurface(p, options, i == fine.rings(), j == 0 || j == fine.columns());
            fine.at(i, j) = p;
        }
    });
    return fine;
}

PolarGrid coarsened(const PolarGrid& grid)
{
    PolarGrid coarse(grid.columns() / 2, grid.rings() / 2);
    for (int i = 0; i <= coarse.rings(); ++i)
        for (int j = 0; j <= coarse.columns(); ++j)
            coarse.at(i, j) = grid.at(2 * i, 2 * j);
    return coarse;
}

} // namespace hairpaint::heads
