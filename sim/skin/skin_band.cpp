// Samples of the skin, spread to the cells around them.
#include "sim/skin/skin_band.h"

#include "sim/base/kept_with.h"
#include "sim/base/parallel.h"
#include "sim/skin/mesh_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr float kCellM = 0.004F;
constexpr float kMostBandCellsAcross = 256.0F; ///< Larger heads have larger cells.

struct Seed
{
    std::uint32_t face = 0;
    glm::vec3 barycentric{0.0F};
    glm::vec3 positionHd{0.0F};
};

float square(glm::vec3 v)
{
    return glm::dot(v, v);
}

} // namespace

SkinBand::SkinBand(const Skin& skin)
{
    const HeadMesh& mesh = skin.mesh();
    const MeshBounds bounds = boundsOf(mesh);
    const glm::vec3 size = bounds.size();
    const float cellM = std::max(kCellM, std::max({size.x, size.y, size.z}) / kMostBandCellsAcross);
    const int layers = static_cast<int>(std::ceil(kReachM / cellM));
    m_perCell = 1.0F / cellM;
    const float marginM = cellM * static_cast<float>(layers + 1);
    m_originHd = bounds.least - marginM;
    const glm::ivec3 cells = glm::ivec3((size + 2.0F * marginM) * m_perCell) + 1;
    m_size = glm::vec3(cells);
    m_columns = static_cast<std::size_t>(cells.x);
    m_rows = static_cast<std::size_t>(cells.y);
    m_index.assign(m_columns * m_rows * static_cast<std::size_t>(cells.z), kNone);

    const auto cellOf = [&](glm::vec3 p) { return glm::ivec3((p - m_originHd) * m_perCell); };
    const auto indexOfCell = [&](glm::ivec3 c) {
        return (static_cast<std::size_t>(c.z) * m_rows + static_cast<std::size_t>(c.y)) * m_columns +
               static_cast<std::size_t>(c.x);
    };
    const auto middleOf = [&](glm::ivec3 c) { return m_originHd + (glm::vec3(c) + 0.5F) * cellM; };

    std::vector<Seed> seeds;
    std::vector<glm::ivec3> filled; ///< [seeds]
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
        const glm::uvec3 t = mesh.triangles[face];
        const glm::vec3 a = mesh.positionsHd[t.x];
        const glm::vec3 b = mesh.positionsHd[t.y];
        const glm::vec3 c = mesh.positionsHd[t.z];
        const float longest = std::sqrt(std::max({square(b - a), square(c - b), square(a - c)}));
        const int parts = std::max(static_cast<int>(std::ceil(longest * m_perCell * 2.0F)), 1);
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; i + j <= parts; ++j) {
                const glm::vec2 w = glm::vec2(i, j) / static_cast<float>(parts);
                const glm::vec3 weights(1.0F - w.x - w.y, w.x, w.y);
                const glm::vec3 p = a * weights.x + b * weights.y + c * weights.z;
                const glm::ivec3 cell = cellOf(p);
                std::int32_t& index = m_index[indexOfCell(cell)];
                if (index == kNone) {
                    index = static_cast<std::int32_t>(seeds.size());
                    seeds.push_back({face, weights, p});
                    filled.push_back(cell);
                } else if (square(p - middleOf(cell)) <
                           square(seeds[static_cast<std::size_t>(index)].positionHd - middleOf(cell))) {
                    seeds[static_cast<std::size_t>(index)] = {face, weights, p};
                }
            }
    }
    // Layer by layer, each from the cells of the layer before alone, so that the order does not matter.
    std::size_t layerBegin = 0;
    for (int layer = 0; layer < layers; ++layer) {
        const std::size_t layerEnd = filled.size();
        for (std::size_t i = layerBegin; i < layerEnd; ++i) {
            const glm::ivec3 cell = filled[i];
            for (int n = 0; n < 27; ++n) {
                const glm::ivec3 next = cell + glm::ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
                if (glm::any(glm::lessThan(next, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(next, cells)))
                    continue;
                std::int32_t& index = m_index[indexOfCell(next)];
                if (index == kNone) {
                    index = static_cast<std::int32_t>(seeds.size());
                    seeds.push_back(seeds[i]);
                    filled.push_back(next);
                } else if (static_cast<std::size_t>(index) >= layerEnd &&
                           square(seeds[i].positionHd - middleOf(next)) <
                               square(seeds[static_cast<std::size_t>(index)].positionHd - middleOf(next))) {
                    seeds[static_cast<std::size_t>(index)] = seeds[i];
                }
            }
        }
        layerBegin = layerEnd;
    }
    m_gridIndex.reserve(filled.size());
    for (const glm::ivec3& cell : filled)
        m_gridIndex.push_back(static_cast<std::uint32_t>(indexOfCell(cell)));
    m_cells.resize(seeds.size());
    parallelFor(seeds.size(), 2048, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const SurfacePoint point = skin.at(seeds[i].face, seeds[i].barycentric);
            m_cells[i] = {point.positionHd, point.uv, SkinFrame::at(point)};
        }
    });
}

std::int32_t SkinBand::cellAt(glm::vec3 positionHd) const
{
    const glm::vec3 at = (positionHd - m_originHd) * m_perCell;
    // False for what is not a number.
    if (!(glm::all(glm::greaterThanEqual(at, glm::vec3(0.0F))) && glm::all(glm::lessThan(at, m_size))))
        return kNone;
    const glm::u64vec3 cell(at);
    return m_index[(cell.z * m_rows + cell.y) * m_columns + cell.x];
}

std::vector<std::uint32_t> SkinBand::around(std::span<const std::uint32_t> cells, float reachM) const
{
    // The outermost cells of the grid are empty.
    const auto reach = static_cast<std::int64_t>(std::ceil(reachM * m_perCell));
    const auto columns = static_cast<std::int64_t>(m_columns);
    const auto layer = columns * static_cast<std::int64_t>(m_rows);
    const auto size = static_cast<std::int64_t>(m_index.size());
    std::vector<std::uint8_t> isAround(m_cells.size(), 0);
    std::vector<std::uint32_t> found;
    for (const std::uint32_t cell : cells)
        for (std::int64_t z = -reach; z <= reach; ++z)
            for (std::int64_t y = -reach; y <= reach; ++y)
                for (std::int64_t x = -reach; x <= reach; ++x) {
                    const std::int64_t at = static_cast<std::int64_t>(m_gridIndex[cell]) + z * layer + y * columns + x;
                    const std::int32_t index = at >= 0 && at < size ? m_index[static_cast<std::size_t>(at)] : kNone;
                    if (index == kNone || isAround[static_cast<std::size_t>(index)] != 0)
                        continue;
                    isAround[static_cast<std::size_t>(index)] = 1;
                    found.push_back(static_cast<std::uint32_t>(index));
                }
    std::ranges::sort(found);
    return found;
}

std::shared_ptr<const SkinBand> bandOf(const std::shared_ptr<const Skin>& skin)
{
    static KeptWith<Skin, SkinBand> bands;
    return bands.of(skin, [](const Skin& of) { return std::make_shared<const SkinBand>(of); });
}

} // namespace hairpaint::sim
