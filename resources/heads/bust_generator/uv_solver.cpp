// Projected Newton with a sparse Cholesky factorisation.
#include "uv_solver.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "parallel_for.h"

namespace hairpaint::heads {

namespace {

using Gradient = Eigen::Matrix<double, 6, 1>;
using Hessian = Eigen::Matrix<double, 6, 6>;

// A triangle's map: J = sum over corners of uv * slope, the energy of J, and its derivatives by the six corner
// coordinates.
struct Element
{
    std::array<glm::dvec2, 3>
        slopes;    // of the corners' hat functions, in the triangle's plane, divided by the wanted scale
    double weight; // energy per density
    double areaWeight;
};

struct Jacobian
{
    double a, b, c, d; // rows u and v, columns along and across the triangle's first edge
    double det() const { return a * d - b * c; }
    double squares() const { return a * a + b * b + c * c + d * d; }
};

Jacobian jacobian(const Element& e, const std::array<glm::dvec2, 3>& uvs)
{
    Jacobian j{0.0, 0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < 3; ++k) {
        j.a += uvs[k].x * e.slopes[k].x;
        j.b += uvs[k].x * e.slopes[k].y;
        j.c += uvs[k].y * e.slopes[k].x;
        j.d += uvs[k].y * e.slopes[k].y;
    }
    return j;
}

double energy(const Element& e, const Jacobian& j)
{
    const double det = j.det();
    if (det <= 1.0e-12)
        return std::numeric_limits<double>::infinity();
    const double inverse = 1.0 / (det * det);
    return e.weight * (j.squares() * (1.0 + inverse) + e.areaWeight * (det * det + inverse));
}

// With F = |J|^2, D = det J, C = dD/dJ: the gradient is 2 (1 + D^-2) J + s C, s = -2 F D^-3 + area (2 D - 2 D^-3).
void derivatives(const Element& e, const Jacobian& j, Gradient& gradient, Hessian& hessian)
{
    const Eigen::Vector4d value(j.a, j.b, j.c, j.d);
    const Eigen::Vector4d cofactor(j.d, -j.c, -j.b, j.a);
    const double det = j.det();
    const double inverse2 = 1.0 / (det * det);
    const double inverse3 = inverse2 / det;
    const double inverse4 = inverse2 * inverse2;
    const double squares = j.squares();
    const double slope = -2.0 * squares * inverse3 + e.areaWeight * 2.0 * (det - inverse3);
    const Eigen::Vector4d byValue = 2.0 * (1.0 + inverse2) * value + slope * cofactor;
    Eigen::Matrix4d second = 2.0 * (1.0 + inverse2) * Eigen::Matrix4d::Identity();
    second -= 4.0 * inverse3 * (value * cofactor.transpose() + cofactor * value.transpose());
    second += (6.0 * squares * inverse4 + e.areaWeight * (2.0 + 6.0 * inverse4)) * cofactor * cofactor.transpose();
    second(0, 3) += slope;
    second(3, 0) += slope;
    second(1, 2) -= slope;
    second(2, 1) -= slope;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(second);
    const Eigen::Vector4d positive = eigen.eigenvalues().cwiseMax(1.0e-6);
    second = eigen.eigenvectors() * positive.asDiagonal() * eigen.eigenvectors().transpose();

    Eigen::Matrix<double, 4, 6> byCorner = Eigen::Matrix<double, 4, 6>::Zero();
    for (int k = 0; k < 3; ++k) {
        const glm::dvec2& s = e.slopes[static_cast<std::size_t>(k)];
        byCorner(0, 2 * k) = byCorner(2, 2 * k + 1) = s.x;
        byCorner(1, 2 * k) = byCorner(3, 2 * k + 1) = s.y;
    }
    gradient = e.weight * byCorner.transpose() * byValue;
    hessian = e.weight * byCorner.transpose() * second * byCorner;
}

// The step at which the triangle first has no area: det(J + t dJ) = 0.
double flipStep(const Jacobian& j, const Jacobian& dj)
{
    const double square = dj.det();
    const double linear = j.a * dj.d + dj.a * j.d - j.b * dj.c - dj.b * j.c;
    const double constant = j.det();
    const double discriminant = linear * linear - 4.0 * square * constant;
    if (discriminant < 0.0)
        return std::numeric_limits<double>::infinity();
    const double stable = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));
    double first = std::numeric_limits<double>::infinity();
    for (const double t : {stable / square, constant / stable})
        if (t > 0.0 && std::isfinite(t))
            first = std::min(first, t);
    return first;
}

class Flattening
{
public:
    Flattening(HalfMesh& half, const std::vector<UvGoal>& goals) : m_half(half)
    {
        m_unknowns.assign(2 * half.positions.size(), -1);
        for (std::size_t v = 1; v < half.positions.size(); ++v) {
            if (!half.isMiddle(v))
                m_unknowns[2 * v] = m_count++;
            m_unknowns[2 * v + 1] = m_count++;
        }
        for (std::size_t t = 0; t < half.triangles.size(); ++t)
            m_elements.push_back(element(half.triangles[t], goals[t]));
    }

    double total(const std::vector<glm::dvec2>& uvs) const
    {
        double sum = 0.0;
        for (std::size_t t = 0; t < m_elements.size(); ++t)
            sum += energy(m_elements[t], jacobian(m_elements[t], corners(uvs, t)));
        return sum;
    }

    // Returns the new energy.
    double step(double before)
    {
        assemble();
        if (!m_isAnalysed)
            m_solver.analyzePattern(m_hessian);
        m_isAnalysed = true;
        m_solver.factorize(m_hessian);
        const Eigen::VectorXd solution = m_solver.solve(-m_gradient);
        std::vector<glm::dvec2> direction(m_half.uvs.size(), glm::dvec2(0.0));
        for (std::size_t v = 0; v < direction.size(); ++v)
            for (int c = 0; c < 2; ++c)
                if (const int unknown = m_unknowns[2 * v + static_cast<std::size_t>(c)]; unknown >= 0)
                    direction[v][c] = solution[unknown];
        double length = 1.0;
        for (std::size_t t = 0; t < m_elements.size(); ++t)
            length = std::min(length, 0.8 * flipStep(jacobian(m_elements[t], corners(m_half.uvs, t)),
                                                     jacobian(m_elements[t], corners(direction, t))));
        const double slope = m_gradient.dot(solution);
        while (length > 1.0e-10) {
            std::vector<glm::dvec2> moved = m_half.uvs;
            for (std::size_t v = 0; v < moved.size(); ++v)
                moved[v] += length * direction[v];
            const double after = total(moved);
            if (after <= before + 1.0e-4 * length * slope) {
                m_half.uvs = std::move(moved);
                return after;
            }
            length *= 0.5;
        }
        return before;
    }

private:
    Element element(const Triangle& t, const UvGoal& goal) const
    {
        const glm::dvec3 p = m_half.positions[t[0]];
        const glm::dvec3 first = glm::dvec3(m_half.positions[t[1]]) - p;
        const glm::dvec3 second = glm::dvec3(m_half.positions[t[2]]) - p;
        const double length = glm::length(first);
        const double along = glm::dot(second, first) / length;
        const double across = glm::length(glm::cross(first, second)) / length;
        // Inverse of the edge matrix ((length, along), (0, across)).
        const glm::dvec2 one = glm::dvec2(1.0 / length, -along / (length * across)) / goal.scale;
        const glm::dvec2 two = glm::dvec2(0.0, 1.0 / across) / goal.scale;
        return {{-one - two, one, two}, goal.weight * 0.5 * length * across, goal.areaWeight};
    }

    std::array<glm::dvec2, 3> corners(const std::vector<glm::dvec2>& uvs, std::size_t t) const
    {
        const Triangle& triangle = m_half.triangles[t];
        return {uvs[triangle[0]], uvs[triangle[1]], uvs[triangle[2]]};
    }

    void assemble()
    {
        std::vector<Gradient> gradients(m_elements.size());
        std::vector<Hessian> hessians(m_elements.size());
        parallelFor(static_cast<int>(m_elements.size()), [&](int i) {
            const auto t = static_cast<std::size_t>(i);
            derivatives(m_elements[t], jacobian(m_elements[t], corners(m_half.uvs, t)), gradients[t], hessians[t]);
        });
        m_gradient = Eigen::VectorXd::Zero(m_count);
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(m_elements.size() * 21);
        for (std::size_t t = 0; t < m_elements.size(); ++t) {
            const Triangle& triangle = m_half.triangles[t];
            for (int r = 0; r < 6; ++r) {
                const int row =
                    m_unknowns[2 * triangle[static_cast<std::size_t>(r / 2)] + static_cast<std::size_t>(r % 2)];
                if (row < 0)
                    continue;
                m_gradient[row] += gradients[t][r];
                for (int c = 0; c < 6; ++c) {
                    const int column =
                        m_unknowns[2 * triangle[static_cast<std::size_t>(c / 2)] + static_cast<std::size_t>(c % 2)];
                    if (column >= 0 && column <= row)
                        entries.emplace_back(row, column, hessians[t](r, c));
                }
            }
        }
        m_hessian.resize(m_count, m_count);
        m_hessian.setFromTriplets(entries.begin(), entries.end());
    }

    HalfMesh& m_half;
    std::vector<int> m_unknowns; // by vertex and coordinate, -1 where fixed
    int m_count = 0;
    std::vector<Element> m_elements;
    Eigen::VectorXd m_gradient;
    Eigen::SparseMatrix<double> m_hessian; // lower triangle
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> m_solver;
    bool m_isAnalysed = false;
};

} // namespace

std::vector<glm::dvec2> polarUvs(const PolarGrid& grid, const HalfMesh& half)
{
    std::vector<double> radius(static_cast<std::size_t>(grid.rings() + 1), 0.0);
    for (int i = 1; i <= grid.rings(); ++i) {
        double sum = 0.0;
        for (int j = 0; j <= grid.columns(); ++j)
            sum += static_cast<double>(glm::distance(grid.at(i, j), grid.at(i - 1, j)));
        radius[static_cast<std::size_t>(i)] = radius[static_cast<std::size_t>(i - 1)] + sum / (grid.columns() + 1);
    }
    std::vector<glm::dvec2> uvs;
    for (const auto& [ring, column] : half.indices) {
        const double azimuth = std::numbers::pi * column / grid.columns();
        const bool isMiddle = column == 0 || column == grid.columns();
        uvs.push_back(radius[static_cast<std::size_t>(ring)] *
                      glm::dvec2(isMiddle ? 0.0 : std::sin(azimuth), -std::cos(azimuth)));
    }
    return uvs;
}

double improveUvs(HalfMesh& half, const std::vector<UvGoal>& goals, int iterations)
{
    Flattening flattening(half, goals);
    double energy = flattening.total(half.uvs);
    for (int i = 0; i < iterations; ++i) {
        const double after = flattening.step(energy);
        const bool isDone = energy - after < 1.0e-6 * energy;
        energy = after;
        if (isDone)
            break;
    }
    return energy;
}

} // namespace hairpaint::heads
