// Fitting ellipsoids to a mesh: one after the other, each takes as much of what is left of the inside as it can.
#include "sim/skin/ellipsoid.h"

#include "sim/skin/going_on.h"
#include "sim/skin/head_mesh.h"
#include "sim/skin/solid_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr int kCells = 36;
constexpr float kOutsideCosts = 3.0F; ///< A cell outside the mesh, in cells gained inside.
constexpr double kLeastGain = 0.004;  ///< Fraction of the inside that one more ellipsoid must take.
constexpr float kFirstStep = 0.3F;
constexpr int kStepSizes = 7;  ///< Each 0.6 of the one before, down to a hundredth.
constexpr int kMostRounds = 8; ///< With steps of one size.

/// One change of an ellipsoid in the search: shift, scale of an axis, or turn (by the tangent of half the angle).
constexpr int kMoves = 9;

Ellipsoid moved(const Ellipsoid& e, int move, float step)
{
    Ellipsoid m = e;
    const int axis = move % 3;
    if (move < 3) {
        m.centreHd[axis] += step * e.semiAxesM[axis];
    } else if (move < 6) {
        m.semiAxesM[axis] *= 1.0F + step;
    } else {
        glm::quat turn(1.0F, 0.0F, 0.0F, 0.0F);
        turn[axis] = 0.5F * step;
        m.rotation = e.rotation * turn;
        m.rotation = m.rotation * (1.0F / std::sqrt(glm::dot(m.rotation, m.rotation)));
    }
    return m;
}

/// Calls visit(index) for the cells inside the ellipsoid.
template<typename Visit>
void forCellsIn(const SolidGrid& grid, const Ellipsoid& e, Visit visit)
{
    const glm::mat3 axes = glm::mat3_cast(e.rotation);
    glm::vec3 reach;
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 row(axes[0][i] * e.semiAxesM[0], axes[1][i] * e.semiAxesM[1], axes[2][i] * e.semiAxesM[2]);
        reach[i] = std::sqrt(glm::dot(row, row));
    }
    const glm::vec3 first = glm::ceil((e.centreHd - reach - grid.originHd) / grid.cellM);
    const glm::vec3 last = glm::floor((e.centreHd + reach - grid.originHd) / grid.cellM);
    glm::ivec3 cell;
    for (cell.z = std::max(0, static_cast<int>(first.z)); cell.z <= std::min(grid.size.z - 1, static_cast<int>(last.z));
         ++cell.z) {
        for (cell.y = std::max(0, static_cast<int>(first.y));
             cell.y <= std::min(grid.size.y - 1, static_cast<int>(last.y)); ++cell.y) {
            for (cell.x = std::max(0, static_cast<int>(first.x));
                 cell.x <= std::min(grid.size.x - 1, static_cast<int>(last.x)); ++cell.x) {
                const glm::vec3 q = (grid.middleHd(cell) - e.centreHd) * axes / e.semiAxesM;
                if (glm::dot(q, q) <= 1.0F)
                    visit(grid.indexOf(cell));
            }
        }
    }
}

/// Cells gained less what the cells outside cost. What lies off the grid costs nothing and gains nothing.
float scoreOf(const SolidGrid& grid, const std::vector<std::uint8_t>& left, const Ellipsoid& e)
{
    float score = 0.0F;
    forCellsIn(grid, e, [&](std::size_t index) {
        if (left[index] != 0)
            score += 1.0F;
        else if (grid.inside[index] == 0)
            score -= kOutsideCosts;
    });
    return score;
}

/// Pattern search: any single move that scores better is taken; where none does, moves become smaller.
Ellipsoid improved(const SolidGrid& grid, const std::vector<std::uint8_t>& left, Ellipsoid best,
                   const std::array<bool, kMoves>& allowed, const std::function<bool()>& goesOn)
{
    float bestScore = scoreOf(grid, left, best);
    float step = kFirstStep;
    for (int size = 0; size < kStepSizes; ++size, step *= 0.6F) {
        bool any = true;
        for (int round = 0; any && round < kMostRounds; ++round) {
            if (!goesOn())
                return best;
            any = false;
            for (int move = 0; move < kMoves; ++move) {
                if (!allowed[static_cast<std::size_t>(move)])
                    continue;
                for (const float sign : {step, -step}) {
                    const Ellipsoid tried = moved(best, move, sign);
                    const float score = scoreOf(grid, left, tried);
                    if (score > bestScore) {
                        best = tried;
                        bestScore = score;
                        any = true;
                    }
                }
            }
        }
    }
    return best;
}

/// Cells are coarse: in the end the ellipsoid is scaled to the vertices whose skin it follows, a little inside most.
void snapToSkin(const HeadMesh& mesh, Ellipsoid& e)
{
    const glm::mat3 axes = glm::mat3_cast(e.rotation);
    std::vector<float> radii;
    for (std::size_t i = 0; i < mesh.positionsHd.size(); ++i) {
        const glm::vec3 q = (mesh.positionsHd[i] - e.centreHd) * axes / e.semiAxesM;
        const float r = std::sqrt(glm::dot(q, q));
        if (r < 0.85F || r > 1.15F)
            continue;
        const glm::vec3 normal = axes * (q / e.semiAxesM);
        const float along = glm::dot(normal, mesh.normalsHd[i]);
        if (along > 0.9F * std::sqrt(glm::dot(normal, normal)))
            radii.push_back(r);
    }
    if (radii.size() < 16)
        return;
    const auto lower = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 4);
    std::nth_element(radii.begin(), lower, radii.end());
    e.semiAxesM *= std::clamp(*lower, 0.9F, 1.1F);
}

} // namespace

std::vector<Ellipsoid> fitEllipsoids(const HeadMesh& mesh, int count, const std::function<bool(double)>& goesOn)
{
    std::vector<Ellipsoid> result;
    const auto mayGoOn = [&] {
        return !goesOn || goesOn(static_cast<double>(result.size()) / static_cast<double>(count));
    };
    if (!mayGoOn())
        return result;
    const std::function<bool()> ask = mayGoOn;
    GoingOn goingOn(ask);
    const SolidGrid grid = solidGridOf(mesh, kCells, goingOn);
    const auto total = static_cast<double>(std::count(grid.inside.begin(), grid.inside.end(), std::uint8_t{1}));
    if (total == 0.0)
        return result;
    const float middle = grid.originHd.x + 0.5F * static_cast<float>(grid.size.x - 1) * grid.cellM;
    const bool symmetric = std::abs(middle) < 0.75F * grid.cellM;
    // On a symmetric head every ellipsoid stands in the plane of symmetry and only nods.
    const std::array<bool, kMoves> allowed{!symmetric, true, true, true, true, true, true, !symmetric, !symmetric};

    std::vector<std::uint8_t> left = grid.inside;
    while (static_cast<int>(result.size()) < count && mayGoOn()) {
        const std::vector<int> depth = depthsOf(grid, left);
        Ellipsoid start;
        int deepest = 0;
        glm::ivec3 cell;
        for (cell.z = 0; cell.z < grid.size.z; ++cell.z) {
            for (cell.y = 0; cell.y < grid.size.y; ++cell.y) {
                for (cell.x = 0; cell.x < grid.size.x; ++cell.x) {
                    const glm::vec3 p = grid.middleHd(cell);
                    const bool eligible = !symmetric || std::abs(p.x) <= 0.75F * grid.cellM;
                    if (eligible && depth[grid.indexOf(cell)] > deepest) {
                        deepest = depth[grid.indexOf(cell)];
                        start.centreHd = p;
                    }
                }
            }
        }
        if (deepest == 0)
            break;
        if (symmetric)
            start.centreHd.x = 0.0F;
        start.semiAxesM = glm::vec3(static_cast<float>(deepest) * grid.cellM);
        Ellipsoid fitted = improved(grid, left, start, allowed, mayGoOn);
        if (static_cast<double>(scoreOf(grid, left, fitted)) < kLeastGain * total)
            break;
        forCellsIn(grid, fitted, [&](std::size_t index) { left[index] = 0; });
        snapToSkin(mesh, fitted);
        result.push_back(fitted);
    }
    return result;
}

} // namespace hairpaint::sim
