// Preparing ellipsoids for the kernels.
#include "sim/solver/collider_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace hairpaint::sim {

namespace {

constexpr float kShortestAxisM = 1e-3F;
/// A root may lift its ellipsoid by this fraction, to the skin it grows on.
constexpr float kLargestLift = 1.06F;

bool isFinite(const Ellipsoid& e)
{
    float sum = 0.0F;
    for (int i = 0; i < 3; ++i)
        sum += e.centreHd[i] + e.semiAxesM[i];
    sum += e.rotation.x + e.rotation.y + e.rotation.z + e.rotation.w;
    return std::isfinite(sum);
}

glm::vec3 fromCentre(const Collider& c, glm::vec3 pHd)
{
    return {pHd.x - c.centre[0], pHd.y - c.centre[1], pHd.z - c.centre[2]};
}

/// Half the gradient of the form.
glm::vec3 halfGradient(const Collider& c, glm::vec3 p)
{
    return {c.squares[0] * p.x + 0.5F * (c.mixed[0] * p.y + c.mixed[1] * p.z),
            c.squares[1] * p.y + 0.5F * (c.mixed[0] * p.x + c.mixed[2] * p.z),
            c.squares[2] * p.z + 0.5F * (c.mixed[1] * p.x + c.mixed[2] * p.y)};
}

} // namespace

float Collider::radius2(glm::vec3 pHd) const
{
    const glm::vec3 p = fromCentre(*this, pHd);
    return glm::dot(p, halfGradient(*this, p));
}

glm::vec3 Collider::pushedOut(glm::vec3 pHd, float scale) const
{
    const float r2 = radius2(pHd);
    if (r2 >= scale * scale)
        return pHd;
    const glm::vec3 gradient = halfGradient(*this, fromCentre(*this, pHd));
    const float r = std::sqrt(r2);
    const float g2 = std::max(glm::dot(gradient, gradient), 1e-12F);
    return pHd + gradient * ((scale - r) * r / g2);
}

ColliderSet prepareColliders(std::span<const Ellipsoid> ellipsoids, std::shared_ptr<const DistanceGrid> grid)
{
    ColliderSet set;
    if (grid) {
        set.skin = skinFieldOf(*grid);
        set.grid = std::move(grid);
    }
    for (const Ellipsoid& e : ellipsoids) {
        if (set.count == kMaxColliders)
            break;
        const float norm2 = glm::dot(e.rotation, e.rotation);
        if (!isFinite(e) || norm2 < 1e-12F)
            continue;
        const float toUnitLength = 1.0F / std::sqrt(norm2);
        const glm::mat3 axes = glm::mat3_cast(e.rotation * toUnitLength);
        Collider& c = set.items[static_cast<std::size_t>(set.count++)];
        c.meanAxisM = 0.0F;
        c.centre = {e.centreHd.x, e.centreHd.y, e.centreHd.z};
        for (int i = 0; i < 3; ++i) {
            const float axis = std::max(std::abs(e.semiAxesM[i]), kShortestAxisM);
            const glm::vec3 toUnit = axes[i] / axis;
            for (int j = 0; j < 3; ++j)
                c.squares[static_cast<std::size_t>(j)] += toUnit[j] * toUnit[j];
            c.mixed[0] += 2.0F * toUnit.x * toUnit.y;
            c.mixed[1] += 2.0F * toUnit.x * toUnit.z;
            c.mixed[2] += 2.0F * toUnit.y * toUnit.z;
            c.meanAxisM += axis / 3.0F;
        }
    }
    return set;
}

float strandScale(const Collider& collider, std::span<const glm::vec3> restHd, float growthM)
{
    float nearest2 = kLargestLift * kLargestLift;
    std::array<float, 2> first2 = {2.0F * nearest2, 0.0F}; // Of the first nodes.
    for (std::size_t i = 0; i < restHd.size(); ++i) {
        const float node2 = collider.radius2(restHd[i]);
        nearest2 = std::min(nearest2, node2);
        if (i < first2.size())
            first2[i] = node2;
    }
    float scale = std::sqrt(nearest2);
    // A root far outside belongs to another part of the head: there the ellipsoid keeps its size.
    if (first2[0] > kLargestLift * kLargestLift)
        scale = std::min(scale, 1.0F);
    const float grown = scale + growthM / collider.meanAxisM;
    if (restHd.size() < 2)
        return grown;
    // What bends a hair up at its root all the time would make it flutter.
    return std::clamp(std::sqrt(first2[1]), scale, grown);
}

namespace {

/// Whether a strand is laid: not straight, and every node much nearer to the skin than it is far along the strand.
bool liesOnSkin(const DistanceGrid& grid, std::span<const glm::vec3> restHd)
{
    constexpr float kOfTheLength = 0.5F;
    const glm::vec3 first = restHd[1] - restHd[0];
    const float segmentM = std::sqrt(glm::dot(first, first));
    constexpr float kStraight = 0.9999F;
    const glm::vec3 reach = restHd.back() - restHd.front();
    if (std::sqrt(glm::dot(reach, reach)) > kStraight * segmentM * static_cast<float>(restHd.size() - 1))
        return false;
    for (std::size_t i = 2; i < restHd.size(); ++i) {
        const auto sample = grid.at(restHd[i]);
        if (!sample || sample->distanceM > kOfTheLength * segmentM * static_cast<float>(i))
            return false;
    }
    return true;
}

/// Whether the skin is surely further away than that; a look at one corner of the cell, where its samples differ from
/// it by its diagonal at most.
bool isFurther(const SkinField& skin, glm::vec3 pHd, float distanceM)
{
    constexpr float kRounding = 1.0F; // Units.
    std::array<std::int32_t, 3> cell{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const float at = (pHd[axis] - skin.origin[i]) * skin.inverseCell;
        if (!(at >= 0.0F && at < skin.last[i]))
            return false;
        cell[i] = static_cast<std::int32_t>(at);
    }
    const DistanceGrid::Pair& pair = skin.pairs[cell[2] * skin.slice + cell[1] * skin.row + cell[0]];
    return (static_cast<float>(pair.value) - skin.unitsADiagonal - kRounding) * DistanceGrid::kUnitM > distanceM;
}

} // namespace

float skinClearance(const ColliderSet& colliders, std::span<const glm::vec3> restHd, float wishedM)
{
    if (!colliders.grid)
        return 0.0F;
    if (liesOnSkin(*colliders.grid, restHd))
        return wishedM;
    float clearance = wishedM;
    for (std::size_t i = 1; i < restHd.size(); ++i)
        for (const float part : kSegmentParts) {
            if (i == 1 && part < 1.0F)
                continue; // The first segment begins on the skin.
            const glm::vec3 at = restHd[i - 1] + part * (restHd[i] - restHd[i - 1]);
            if (isFurther(colliders.skin, at, clearance))
                continue;
            const auto sample = colliders.grid->at(at);
            if (!sample)
                continue;
            if (sample->distanceM < 0.0F)
                return wishedM;
            clearance = std::min(clearance, sample->distanceM);
        }
    return clearance;
}

} // namespace hairpaint::sim
