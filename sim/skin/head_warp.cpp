// The spline's weights from one small system.
#include "sim/skin/head_warp.h"

#include <Eigen/Dense>

#include <algorithm>

namespace hairpaint::sim {

HeadWarp::HeadWarp(const HeadLandmarks& from, const HeadLandmarks& to)
{
    constexpr auto kCount = static_cast<Eigen::Index>(kHeadLandmarkCount);
    constexpr auto kTerms = static_cast<Eigen::Index>(kHeadLandmarkCount + kAffineTerms);
    std::ranges::copy(from.positionsHd, m_centres.begin());
    Eigen::Matrix<double, kTerms, kTerms> system = Eigen::Matrix<double, kTerms, kTerms>::Zero();
    Eigen::Matrix<double, kTerms, 3> wanted = Eigen::Matrix<double, kTerms, 3>::Zero();
    for (Eigen::Index i = 0; i < kCount; ++i) {
        const glm::dvec3 centre = m_centres[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < kCount; ++j)
            system(i, j) = glm::distance(centre, m_centres[static_cast<std::size_t>(j)]);
        system.row(i).tail<kAffineTerms>() << 1.0, centre.x, centre.y, centre.z;
        system.col(i).tail<kAffineTerms>() = system.row(i).tail<kAffineTerms>().transpose();
        const glm::dvec3 target = to.positionsHd[static_cast<std::size_t>(i)];
        wanted.row(i) << target.x, target.y, target.z;
    }
    const Eigen::Matrix<double, kTerms, 3> weights = system.completeOrthogonalDecomposition().solve(wanted);
    for (Eigen::Index i = 0; i < kTerms; ++i)
        m_weights[static_cast<std::size_t>(i)] = {weights(i, 0), weights(i, 1), weights(i, 2)};
}

glm::vec3 HeadWarp::operator()(const glm::vec3& positionHd) const
{
    const glm::dvec3 p(positionHd);
    constexpr std::size_t kAffine = kHeadLandmarkCount;
    glm::dvec3 sum =
        m_weights[kAffine] + p.x * m_weights[kAffine + 1] + p.y * m_weights[kAffine + 2] + p.z * m_weights[kAffine + 3];
    for (std::size_t i = 0; i < kHeadLandmarkCount; ++i)
        sum += glm::distance(p, m_centres[i]) * m_weights[i];
    return sum;
}

} // namespace hairpaint::sim
