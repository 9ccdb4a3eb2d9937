// Preparing ellipsoids for the kernels.
#include "sim/solver/collider_set.h"

#include <algorithm>
#include <cmath>

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

glm::vec3 toUnit(const Collider& c, glm::vec3 pHd)
{
    const glm::vec3 d(pHd.x - c.centre[0], pHd.y - c.centre[1], pHd.z - c.centre[2]);
    glm::vec3 q;
    for (int i = 0; i < 3; ++i) {
        const auto& row = c.rows[static_cast<std::size_t>(i)];
        q[i] = row[0] * d.x + row[1] * d.y + row[2] * d.z;
    }
    return q;
}

} // namespace

float Collider::radius2(glm::vec3 pHd) const
{
    const glm::vec3 q = toUnit(*this, pHd);
    return q.x * q.x + q.y * q.y + q.z * q.z;
}

glm::vec3 Collider::pushedOut(glm::vec3 pHd, float scale) const
{
    const glm::vec3 q = toUnit(*this, pHd);
    const float r2 = q.x * q.x + q.y * q.y + q.z * q.z;
    if (r2 >= scale * scale)
        return pHd;
    glm::vec3 gradient(0.0F);
    for (int i = 0; i < 3; ++i) {
        const auto& row = rows[static_cast<std::size_t>(i)];
        gradient += q[i] * glm::vec3(row[0], row[1], row[2]);
    }
    const float r = std::sqrt(r2);
    const float g2 = std::max(glm::dot(gradient, gradient), 1e-12F);
    return pHd + gradient * ((scale - r) * r / g2);
}

ColliderSet prepareColliders(std::span<const Ellipsoid> ellipsoids)
{
    ColliderSet set;
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
        for (int i = 0; i < 3; ++i) {
            const auto row = static_cast<std::size_t>(i);
            const float axis = std::max(std::abs(e.semiAxesM[i]), kShortestAxisM);
            c.centre[row] = e.centreHd[i];
            for (int j = 0; j < 3; ++j)
                c.rows[row][static_cast<std::size_t>(j)] = axes[i][j] / axis;
            c.meanAxisM += axis / 3.0F;
        }
    }
    return set;
}

float strandScale(const Collider& collider, std::span<const glm::vec3> restHd, float growthM)
{
    float nearest2 = kLargestLift * kLargestLift;
    for (const glm::vec3& node : restHd)
        nearest2 = std::min(nearest2, collider.radius2(node));
    float scale = std::sqrt(nearest2);
    // A root far outside belongs to another part of the head: there the ellipsoid keeps its size.
    if (restHd.empty() || collider.radius2(restHd.front()) > kLargestLift * kLargestLift)
        scale = std::min(scale, 1.0F);
    return scale + growthM / collider.meanAxisM;
}

} // namespace hairpaint::sim
