// Counting sort of the faces into cells, and the search in one cell.
#include "sim/skin/uv_grid.h"

#include "sim/skin/head_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hairpaint::sim {

namespace {

constexpr int kMostUvCellsAcross = 1024;
constexpr std::size_t kEntriesPerFace = 16;
/// Fraction of a triangle by which it may be missed: a uv on an edge must find one of its two faces.
constexpr float kEdgeTolerance = 2e-5F;

} // namespace

bool UvGrid::usable(const HeadMesh& mesh, std::uint32_t face)
{
    const glm::uvec3 t = mesh.triangles[face];
    for (int corner = 0; corner < 3; ++corner) {
        const glm::vec2 uv = mesh.uvs[t[corner]];
        if (!(std::abs(uv.x) <= kFarthestUv && std::abs(uv.y) <= kFarthestUv)) // also false for NaN
            return false;
    }
    return true;
}

int UvGrid::cellOf(float offset, float scale) const
{
    return static_cast<int>(std::clamp(offset * scale, 0.0F, static_cast<float>(m_cellsAcross - 1)));
}

UvGrid::CellRange UvGrid::cellsOf(const HeadMesh& mesh, std::uint32_t face) const
{
    const glm::uvec3 t = mesh.triangles[face];
    const glm::vec2 lowest = glm::min(mesh.uvs[t.x], glm::min(mesh.uvs[t.y], mesh.uvs[t.z])) - m_lowestUv;
    const glm::vec2 highest = glm::max(mesh.uvs[t.x], glm::max(mesh.uvs[t.y], mesh.uvs[t.z])) - m_lowestUv;
    return {{cellOf(lowest.x, m_cellsPerUv.x), cellOf(lowest.y, m_cellsPerUv.y)},
            {cellOf(highest.x, m_cellsPerUv.x), cellOf(highest.y, m_cellsPerUv.y)}};
}

void UvGrid::chooseResolution(const HeadMesh& mesh, GoingOn& goingOn)
{
    const std::size_t faceCount = mesh.triangles.size();
    m_cellsAcross = std::clamp(static_cast<int>(std::sqrt(static_cast<float>(faceCount))), 1, kMostUvCellsAcross);
    for (;; m_cellsAcross /= 2) {
        const glm::vec2 extent = glm::max(m_highestUv - m_lowestUv, glm::vec2(1e-20F));
        m_cellsPerUv = static_cast<float>(m_cellsAcross) / extent;
        std::size_t entries = 0;
        for (std::uint32_t face = 0; face < faceCount; ++face) {
            if (!goingOn.after(1))
                return;
            if (!usable(mesh, face))
                continue;
            const CellRange range = cellsOf(mesh, face);
            const glm::ivec2 cells = range.last - range.first + 1;
            entries += static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y);
        }
        if (m_cellsAcross == 1 || entries <= kEntriesPerFace * faceCount)
            return;
    }
}

UvGrid::UvGrid(const HeadMesh& mesh, GoingOn& goingOn)
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const auto faceCount = static_cast<std::uint32_t>(mesh.triangles.size());
    glm::vec2 lowest(kInfinity);
    glm::vec2 highest(-kInfinity);
    for (std::uint32_t face = 0; face < faceCount && goingOn.after(1); ++face) {
        if (!usable(mesh, face))
            continue;
        for (int corner = 0; corner < 3; ++corner) {
            lowest = glm::min(lowest, mesh.uvs[mesh.triangles[face][corner]]);
            highest = glm::max(highest, mesh.uvs[mesh.triangles[face][corner]]);
        }
    }
    if (lowest.x > highest.x) {
        m_cellStart.assign(2, 0);
        return;
    }
    m_lowestUv = lowest;
    m_highestUv = highest;
    chooseResolution(mesh, goingOn);
    if (goingOn.stopped())
        return;

    const auto across = static_cast<std::size_t>(m_cellsAcross);
    m_cellStart.assign(across * across + 1, 0);
    const auto forEachCell = [&](std::uint32_t face, const auto& visit) {
        const CellRange range = cellsOf(mesh, face);
        for (int y = range.first.y; y <= range.last.y; ++y)
            for (int x = range.first.x; x <= range.last.x; ++x)
                visit(static_cast<std::size_t>(y) * across + static_cast<std::size_t>(x));
    };
    for (std::uint32_t face = 0; face < faceCount && goingOn.after(1); ++face)
        if (usable(mesh, face))
            forEachCell(face, [&](std::size_t cell) { ++m_cellStart[cell + 1]; });
    for (std::size_t cell = 0; cell + 1 < m_cellStart.size(); ++cell)
        m_cellStart[cell + 1] += m_cellStart[cell];
    m_faces.resize(m_cellStart.back());
    std::vector<std::uint32_t> next(m_cellStart.begin(), m_cellStart.end() - 1);
    for (std::uint32_t face = 0; face < faceCount && goingOn.after(1); ++face)
        if (usable(mesh, face))
            forEachCell(face, [&](std::size_t cell) { m_faces[next[cell]++] = face; });
}

std::optional<std::pair<std::uint32_t, glm::vec3>> UvGrid::find(const HeadMesh& mesh, glm::vec2 uv) const
{
    const glm::vec2 margin = (m_highestUv - m_lowestUv) * 1e-6F;
    // Written so that a NaN lies off every island.
    if (!(uv.x >= m_lowestUv.x - margin.x && uv.x <= m_highestUv.x + margin.x && uv.y >= m_lowestUv.y - margin.y &&
          uv.y <= m_highestUv.y + margin.y))
        return std::nullopt;
    const auto cell = static_cast<std::size_t>(cellOf(uv.y - m_lowestUv.y, m_cellsPerUv.y)) *
                          static_cast<std::size_t>(m_cellsAcross) +
                      static_cast<std::size_t>(cellOf(uv.x - m_lowestUv.x, m_cellsPerUv.x));
    for (std::uint32_t i = m_cellStart[cell]; i < m_cellStart[cell + 1]; ++i) {
        const std::uint32_t face = m_faces[i];
        const glm::uvec3 t = mesh.triangles[face];
        const glm::dvec2 a = mesh.uvs[t.x];
        const glm::dvec2 ab = glm::dvec2(mesh.uvs[t.y]) - a;
        const glm::dvec2 ac = glm::dvec2(mesh.uvs[t.z]) - a;
        const glm::dvec2 ap = glm::dvec2(uv) - a;
        const double twiceArea = ab.x * ac.y - ab.y * ac.x;
        if (twiceArea == 0.0)
            continue;
        const auto v = static_cast<float>((ap.x * ac.y - ap.y * ac.x) / twiceArea);
        const auto w = static_cast<float>((ab.x * ap.y - ab.y * ap.x) / twiceArea);
        if (v < -kEdgeTolerance || w < -kEdgeTolerance || v + w > 1.0F + kEdgeTolerance)
            continue;
        const float clampedV = std::clamp(v, 0.0F, 1.0F);
        const float clampedW = std::clamp(w, 0.0F, 1.0F - clampedV);
        return std::pair{face, glm::vec3(1.0F - clampedV - clampedW, clampedV, clampedW)};
    }
    return std::nullopt;
}

} // namespace hairpaint::sim
