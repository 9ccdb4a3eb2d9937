// What is seen of a head and its hair from a side, as one shape, and how far two such shapes cover each other. m.
#pragma once

#include "model/exporting/curve_set.h"
#include "model/project/project.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace hairpaint::test {

enum class OutlineSide : std::uint8_t
{
    Front, ///< What is seen from behind is its mirror image.
    Left
};

/// The squares of a plane that a shape covers; the origin is in its middle.
class Outline
{
public:
    static constexpr int kColumns = 60;
    static constexpr int kRows = 100;
    static constexpr std::size_t kSquares = std::size_t{kColumns} * kRows;
    static constexpr float kSquareM = 0.008F;

    [[nodiscard]] static std::optional<std::size_t> squareAt(glm::vec2 p)
    {
        const int column = static_cast<int>(std::floor(p.x / kSquareM)) + kColumns / 2;
        const int row = static_cast<int>(std::floor(p.y / kSquareM)) + kRows / 2;
        if (column < 0 || column >= kColumns || row < 0 || row >= kRows)
            return std::nullopt;
        return indexOf(column, row);
    }
    [[nodiscard]] static glm::vec2 middleOf(std::size_t square)
    {
        const std::size_t column = square % kColumns;
        const std::size_t row = square / kColumns;
        return kSquareM * (glm::vec2(column, row) - 0.5F * glm::vec2(kColumns - 1, kRows - 1));
    }
    [[nodiscard]] bool covers(std::size_t square) const { return m_isCovered[square]; }
    [[nodiscard]] bool covers(glm::vec2 p) const
    {
        const std::optional<std::size_t> square = squareAt(p);
        return square && m_isCovered[*square];
    }
    void cover(std::size_t square) { m_isCovered[square] = true; }
    /// Gaps up to two squares wide, as between braids or spikes, belong to the shape.
    void closeGaps()
    {
        takeFromNeighbours(true);
        takeFromNeighbours(false);
    }

private:
    [[nodiscard]] static std::size_t indexOf(int column, int row)
    {
        return static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column);
    }
    /// A square becomes so if one around it is.
    void takeFromNeighbours(bool isCovered)
    {
        const std::vector<bool> before = m_isCovered;
        for (int row = 1; row + 1 < kRows; ++row)
            for (int column = 1; column + 1 < kColumns; ++column)
                for (int up = -1; up <= 1; ++up)
                    for (int right = -1; right <= 1; ++right)
                        if (before[indexOf(column + right, row + up)] == isCovered)
                            m_isCovered[indexOf(column, row)] = isCovered;
    }

    std::vector<bool> m_isCovered = std::vector<bool>(kSquares);
};

struct HairOutline
{
    Outline hair; ///< Of the hair alone.
    Outline all;  ///< And with the head.
};

/// A head above the chin and its hair, about the middle between the ears.
inline HairOutline outlineOf(const model::Head& head, const model::CurveSet& curves, OutlineSide side)
{
    constexpr float kStepM = 0.5F * Outline::kSquareM;
    const sim::HeadLandmarks& marks = *head.landmarks;
    const glm::vec3 middle = 0.5F * (marks[sim::HeadLandmark::EarLeft] + marks[sim::HeadLandmark::EarRight]);
    // Scans may look anywhere.
    const glm::vec3 toLeft = marks[sim::HeadLandmark::EarLeft] - middle;
    const glm::vec3 left = glm::normalize(glm::vec3(toLeft.x, 0.0F, toLeft.z));
    const glm::vec3 across = side == OutlineSide::Front ? left : glm::cross(left, glm::vec3(0.0F, 1.0F, 0.0F));
    const auto squareOf = [&](const glm::vec3& pointHd) {
        return Outline::squareAt({glm::dot(pointHd - middle, across), pointHd.y - middle.y});
    };
    const auto part = [](int k, int steps) { return static_cast<float>(k) / static_cast<float>(steps); };

    HairOutline outline;
    constexpr int kLeastHairs = 2; // A single one is no outline.
    std::vector<int> hairs(Outline::kSquares, 0);
    std::vector<int> lastHair(Outline::kSquares, 0);
    int number = 0;
    model::CurveScratch scratch;
    for (const model::Curve& curve : curves.curves()) {
        ++number;
        const std::span<const glm::vec3> points = curves.points(curve, scratch);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const int steps = 1 + static_cast<int>(glm::distance(points[i - 1], points[i]) / kStepM);
            for (int k = 0; k <= steps; ++k) {
                const auto square = squareOf(glm::mix(points[i - 1], points[i], part(k, steps)));
                if (square && std::exchange(lastHair[*square], number) != number && ++hairs[*square] == kLeastHairs) {
                    outline.hair.cover(*square);
                    outline.all.cover(*square);
                }
            }
        }
    }
    const sim::HeadMesh& mesh = head.skin->mesh();
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3& a = mesh.positionsHd[t.x];
        const glm::vec3 ab = mesh.positionsHd[t.y] - a;
        const glm::vec3 ac = mesh.positionsHd[t.z] - a;
        const int steps = 1 + static_cast<int>(std::max(glm::length(ab), glm::length(ac)) / kStepM);
        for (int i = 0; i <= steps; ++i)
            for (int k = 0; i + k <= steps; ++k) {
                const glm::vec3 p = a + part(i, steps) * ab + part(k, steps) * ac;
                if (const auto square = squareOf(p); square && p.y > marks[sim::HeadLandmark::Chin].y)
                    outline.all.cover(*square);
            }
    }
    outline.hair.closeGaps();
    outline.all.closeGaps();
    return outline;
}

/// Common area over the whole.
struct Overlap
{
    float hair = 0.0F;
    float all = 0.0F;
};

/// Where an outline lies in another: its point p at offset + scale * p.
struct OutlineFit
{
    glm::vec2 scale{1.0F};
    glm::vec2 offset{0.0F};
};

/// Of what lies above `lowestM` in `a`.
inline float overlapOf(const Outline& a, const Outline& b, const OutlineFit& fit, float lowestM)
{
    int common = 0;
    int whole = 0;
    for (std::size_t square = 0; square < Outline::kSquares; ++square) {
        const glm::vec2 p = Outline::middleOf(square);
        if (p.y < lowestM)
            continue;
        const bool inA = a.covers(square);
        const bool inB = b.covers(fit.offset + fit.scale * p);
        common += inA && inB ? 1 : 0;
        whole += inA || inB ? 1 : 0;
    }
    return static_cast<float>(common) / static_cast<float>(std::max(whole, 1));
}

/// Fits that overlap more and more, from `fit` on.
inline OutlineFit improvedFit(const Outline& a, const Outline& b, OutlineFit fit, float lowestM)
{
    constexpr float kOffsetsM = 0.15F; // An offset's change, for a change of scale by 1.
    float most = overlapOf(a, b, fit, lowestM);
    for (const float step : {0.04F, 0.02F, 0.01F})
        for (bool isBetter = true; isBetter;) {
            isBetter = false;
            for (int which = 0; which < 4; ++which)
                for (const float by : {-step, step}) {
                    OutlineFit tried = fit;
                    (which < 2 ? tried.scale : tried.offset)[which % 2] += which < 2 ? by : by * kOffsetsM;
                    const float found = overlapOf(a, b, tried, lowestM);
                    if (found > most) {
                        most = found;
                        fit = tried;
                        isBetter = true;
                    }
                }
        }
    return fit;
}

/// Once `b` is moved and stretched so that all of it lies on `a` as well as it can: heads differ in size.
inline Overlap fittedOverlap(const HairOutline& a, const HairOutline& b, float lowestM)
{
    Overlap best;
    for (const float wide : {0.9F, 1.0F, 1.1F})
        for (const float high : {0.9F, 1.0F, 1.1F}) {
            const OutlineFit fit = improvedFit(a.all, b.all, {.scale = {wide, high}, .offset = {}}, lowestM);
            if (const float all = overlapOf(a.all, b.all, fit, lowestM); all > best.all)
                best = {.hair = overlapOf(a.hair, b.hair, fit, lowestM), .all = all};
        }
    return best;
}

} // namespace hairpaint::test
