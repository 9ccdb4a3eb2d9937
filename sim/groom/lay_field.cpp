// The map, cell by cell.
#include "sim/groom/lay_field.h"

#include "sim/base/parallel.h"

#include <numeric>

namespace hairpaint::sim {

namespace {

constexpr std::size_t kCellGrain = 4096;
constexpr std::size_t kCandidateGrain = 256;

} // namespace

LayField::LayField(std::shared_ptr<const SkinBand> band, MapRaster natural, const MapRaster& direction)
    : m_band(std::move(band)), m_natural(std::move(natural)), m_direction(direction), m_cells(m_band->cells().size())
{
    parallelFor(m_cells.size(), kCellGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            m_cells[i] = cellFrom(static_cast<std::uint32_t>(i), *direction);
    });
}

LayCell LayField::cellFrom(std::uint32_t index, const TiledRaster& direction) const
{
    const SkinBand::Cell& cell = m_band->cells()[index];
    const DirectionVector natural = m_natural ? directionAt(*m_natural, cell.uv) : DirectionVector(0.0F);
    return {
        cell.frame.normal, glm::dot(cell.positionHd, cell.frame.normal),
        growthDirections(directionAt(direction, cell.uv), m_natural ? &natural : nullptr, cell.positionHd, cell.frame)};
}

const TileIndex& LayField::tilesFor(int rasterSize)
{
    const auto found = m_tiles.find(rasterSize);
    if (found != m_tiles.end())
        return found->second;
    std::vector<glm::vec2> uvs;
    uvs.reserve(m_cells.size());
    for (const SkinBand::Cell& cell : m_band->cells())
        uvs.push_back(cell.uv);
    return m_tiles.emplace(rasterSize, TileIndex(uvs, rasterSize)).first->second;
}

LayField::Difference LayField::differenceTo(const MapRaster& direction)
{
    Difference difference{.direction = direction, .indices = {}, .cells = {}};
    std::vector<std::uint32_t> candidates;
    if (const std::optional<std::vector<TexelRect>> footprints = footprintsThatDiffer(*m_direction, *direction)) {
        candidates = tilesFor(direction->size()).slotsIn(*footprints);
    } else {
        candidates.resize(m_cells.size());
        std::iota(candidates.begin(), candidates.end(), 0U);
    }
    std::vector<LayCell> cells(candidates.size());
    parallelFor(candidates.size(), kCandidateGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            cells[i] = cellFrom(candidates[i], *direction);
    });
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (cells[i].directions == m_cells[candidates[i]].directions)
            continue;
        difference.indices.push_back(candidates[i]);
        difference.cells.push_back(cells[i]);
    }
    return difference;
}

void LayField::apply(const Difference& difference)
{
    for (std::size_t i = 0; i < difference.indices.size(); ++i)
        m_cells[difference.indices[i]] = difference.cells[i];
    m_direction = difference.direction;
}

} // namespace hairpaint::sim
