// Parameters of a symmetric ellipsoid: height, depth, log semi-axes, pitch; of a paired one: centre, log semi-axes,
// turn.
#include "collider_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

struct Sample
{
    glm::vec3 p;
    float weight;
    bool isScalp;
};

glm::quat turn(const glm::vec3& rotation)
{
    const float angle = glm::length(rotation);
    return angle > 0.0F ? glm::angleAxis(angle, rotation / angle) : glm::quat(1.0F, 0.0F, 0.0F, 0.0F);
}

float distanceTo(const sim::Ellipsoid& e, const glm::vec3& p)
{
    return ellipsoid(glm::conjugate(e.rotation) * (p - e.centreHd), glm::vec3(0.0F), e.semiAxesM);
}

// Nose, lips and chin: hair seldom gets there, so they may stick out.
bool isMask(const glm::vec3& p)
{
    return p.z > 0.085F && p.y < 0.010F;
}

float unionDistance(std::span<const sim::Ellipsoid> ellipsoids, const glm::vec3& p)
{
    float nearest = 1.0F;
    for (const sim::Ellipsoid& e : ellipsoids)
        nearest = std::min(nearest, distanceTo(e, p));
    return nearest;
}

std::vector<Sample> samples(const HalfMesh& half)
{
    std::vector<Sample> all;
    for (std::size_t v = 0; v < half.positions.size(); v += 2) {
        const glm::vec3& p = half.positions[v];
        const bool isScalp = bust2().regions.scalpDistance(p) > 0.0F;
        const bool isEar = !isScalp && glm::distance(p, glm::vec3(0.080F, -0.016F, -0.014F)) < 0.042F;
        if (isEar || p.y < -0.290F)
            continue;
        const float weight = isScalp ? 1.0F : (isMask(p) ? 0.03F : (p.y > -0.16F ? 0.30F : 0.20F));
        all.push_back({p, weight, isScalp});
    }
    return all;
}

// The ellipsoids as one vector, and back.
class Parameters
{
public:
    explicit Parameters(std::span<const sim::Ellipsoid> start) : m_start(start.begin(), start.end())
    {
        for (std::size_t i = 0; i < m_start.size(); i += isPaired(i) ? 2 : 1)
            m_count += isPaired(i) ? 9 : 6;
    }

    int count() const { return m_count; }

    // Values are offsets from the start, zero there; lengths in units of 10 mm.
    std::vector<sim::Ellipsoid> ellipsoids(const Eigen::VectorXd& values) const
    {
        std::vector<sim::Ellipsoid> all = m_start;
        Eigen::Index k = 0;
        const auto next = [&] { return static_cast<float>(values[k++]); };
        for (std::size_t i = 0; i < all.size(); ++i) {
            sim::Ellipsoid& e = all[i];
            const float x = isPaired(i) ? 0.01F * next() : 0.0F;
            const float y = 0.01F * next();
            const float z = 0.01F * next();
            e.centreHd += glm::vec3(x, y, z);
            for (int axis = 0; axis < 3; ++axis)
                e.semiAxesM[axis] *= std::exp(next());
            const float pitch = next();
            const float yaw = isPaired(i) ? next() : 0.0F;
            const float roll = isPaired(i) ? next() : 0.0F;
            e.rotation = e.rotation * turn({pitch, yaw, roll});
            if (!isPaired(i))
                continue;
            const glm::quat& q = e.rotation;
            all[i + 1] = {{-e.centreHd.x, e.centreHd.y, e.centreHd.z}, e.semiAxesM, {q.w, q.x, -q.y, -q.z}};
            ++i;
        }
        return all;
    }

private:
    bool isPaired(std::size_t i) const { return m_start[i].centreHd.x != 0.0F; }

    std::vector<sim::Ellipsoid> m_start;
    int m_count = 0;
};

} // namespace

std::vector<sim::Ellipsoid> fittedColliders(const HalfMesh& half, std::span<const sim::Ellipsoid> start)
{
    constexpr int iterations = 400;
    constexpr double nudge = 1.0e-3;
    constexpr double restraint = 1.0; // keeps the shoulders apart, which weigh little

    std::vector<Sample> points = samples(half);
    const Parameters parameters(start);
    const auto residuals = [&](const Eigen::VectorXd& values) {
        const std::vector<sim::Ellipsoid> ellipsoids = parameters.ellipsoids(values);
        const auto count = static_cast<Eigen::Index>(points.size());
        Eigen::VectorXd r(count + values.size());
        r.tail(values.size()) = values * restraint;
        for (std::size_t i = 0; i < points.size(); ++i)
            r[static_cast<Eigen::Index>(i)] =
                static_cast<double>(points[i].weight * unionDistance(ellipsoids, points[i].p)) * 1000.0;
        return r;
    };
    Eigen::VectorXd values = Eigen::VectorXd::Zero(parameters.count());
    double damping = 1.0e-2;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        if (iteration % 20 == 19) {
            const std::vector<sim::Ellipsoid> ellipsoids = parameters.ellipsoids(values);
            for (Sample& s : points)
                s.weight *=
                    1.0F +
                    0.3F * std::max(std::abs(unionDistance(ellipsoids, s.p)) / (s.isScalp ? 0.0014F : 0.008F) - 1.0F,
                                    0.0F);
        }
        const Eigen::VectorXd r = residuals(values);
        Eigen::MatrixXd jacobian(r.size(), values.size());
        for (Eigen::Index k = 0; k < values.size(); ++k) {
            Eigen::VectorXd nudged = values;
            nudged[k] += nudge;
            jacobian.col(k) = (residuals(nudged) - r) / nudge;
        }
        Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
        normal.diagonal() += damping * (normal.diagonal() + Eigen::VectorXd::Constant(values.size(), 1.0e-3));
        const Eigen::VectorXd candidate = values - normal.ldlt().solve(jacobian.transpose() * r);
        const bool isBetter = residuals(candidate).squaredNorm() < r.squaredNorm();
        damping = std::clamp(isBetter ? damping * 0.5 : damping * 4.0, 1.0e-6, 1.0e4);
        if (isBetter)
            values = candidate;
    }
    return parameters.ellipsoids(values);
}

ColliderReport inspected(const HalfMesh& half, std::span<const sim::Ellipsoid> colliders)
{
    ColliderReport report{0.0F, 0.0F, 0.0F};
    for (const Sample& s : samples(half)) {
        const float distance = unionDistance(colliders, s.p);
        if (s.isScalp) {
            report.scalpOutside = std::max(report.scalpOutside, distance);
            report.scalpInside = std::max(report.scalpInside, -distance);
        } else if (!isMask(s.p)) {
            report.elsewhere = std::max(report.elsewhere, std::abs(distance));
        }
    }
    return report;
}

} // namespace hairpaint::heads
