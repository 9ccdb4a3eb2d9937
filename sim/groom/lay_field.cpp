// The map, cell by cell.
#include "sim/groom/lay_field.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr float kShortFallM = 0.08F; ///< Shorter hair lies as it grows, whatever it weighs;
constexpr float kLongFallM = 0.20F;  ///< longer hair falls to its side.
constexpr std::size_t kCellGrain = 4096;

/// How long hair that nobody has combed falls: to its own side of the middle and a little back from the face.
glm::vec3 fallDirection(glm::vec3 positionHd, glm::vec3 normal)
{
    constexpr float kSideways = 2.4F; // Against 1 for down, on top and at the forehead.
    constexpr float kBackward = 1.1F;
    constexpr float kMiddleM = 0.004F; // Where both sides meet.
    constexpr float kFlatness = 0.977F;
    const float front = std::clamp(normal.z, 0.0F, 1.0F);
    const float combing = std::max(std::clamp(normal.y, 0.0F, 1.0F), front);
    const float side = std::clamp(positionHd.x / kMiddleM, -1.0F, 1.0F);
    const glm::vec3 wanted(kSideways * combing * side, 0.9F * front - 1.0F, -kBackward * combing);
    const glm::vec3 along = wanted - normal * glm::dot(wanted, normal);
    const float square = glm::dot(along, along);
    return square > 1e-12F ? along * (kFlatness / std::sqrt(square)) : glm::vec3(kFlatness, 0.0F, 0.0F);
}

Growth growthOf(glm::vec3 projectedHd)
{
    const float flatness = std::sqrt(glm::dot(projectedHd, projectedHd));
    return flatness > 1e-6F ? Growth{projectedHd / flatness, std::min(flatness, 1.0F)} : Growth{};
}

DirectionVector sampled(const TiledRaster& map, glm::vec2 uv)
{
    constexpr float kGreatest = 65535.0F;
    return directionOfChannels(glm::vec2(map.sampleBilinear(uv)) * kGreatest);
}

} // namespace

Growth GrowthDirections::between(float falls) const
{
    const glm::vec3 before = grown.alongHd * grown.flatness;
    return growthOf(before + (fallen.alongHd * fallen.flatness - before) * falls);
}

float fallFraction(float lengthM)
{
    const float t = std::clamp((lengthM - kShortFallM) / (kLongFallM - kShortFallM), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

GrowthDirections growthDirections(DirectionVector painted, const DirectionVector* natural, glm::vec3 positionHd,
                                  const SkinFrame& frame)
{
    const glm::vec3 grown = frame.toHd(painted);
    GrowthDirections directions;
    directions.grown = growthOf(grown);
    directions.fallen = directions.grown;
    if (natural == nullptr)
        return directions;
    // Where the map shows something else than the stream, somebody has combed.
    constexpr float kCombed = 0.03F;
    const float uncombed = 1.0F - glm::length(painted - *natural) / kCombed;
    if (uncombed > 0.0F)
        directions.fallen = growthOf(grown + (fallDirection(positionHd, frame.normal) - grown) * uncombed);
    return directions;
}

LayField::LayField(std::shared_ptr<const SkinBand> band, MapRaster natural, const MapRaster& direction)
    : m_band(std::move(band)), m_natural(std::move(natural)), m_direction(direction), m_cells(m_band->cells().size())
{
    parallelFor(m_cells.size(), kCellGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            m_cells[i] = cellFrom(static_cast<std::uint32_t>(i), *direction);
    });
}

LayField::Cell LayField::cellFrom(std::uint32_t index, const TiledRaster& direction) const
{
    const SkinBand::Cell& place = m_band->cells()[index];
    const DirectionVector natural = m_natural ? sampled(*m_natural, place.uv) : DirectionVector(0.0F);
    return {
        place.positionHd, place.frame.normal,
        growthDirections(sampled(direction, place.uv), m_natural ? &natural : nullptr, place.positionHd, place.frame)};
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
    const auto look = [&](std::uint32_t index) {
        const Cell cell = cellFrom(index, *direction);
        if (cell.directions == m_cells[index].directions)
            return;
        difference.indices.push_back(index);
        difference.cells.push_back(cell);
    };
    if (const std::optional<std::vector<int>> tiles = tilesThatDiffer(*m_direction, *direction)) {
        const TileIndex& index = tilesFor(direction->size());
        for (const int tile : *tiles)
            for (const std::uint32_t cell : index.slotsOf(tile))
                look(cell);
    } else {
        for (std::uint32_t index = 0; index < m_cells.size(); ++index)
            look(index);
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
