// Counting, and comparing tiles by their pointers.
#include "sim/groom/tile_index.h"

#include <algorithm>

namespace hairpaint::sim {

namespace {

/// Past this fraction of changed tiles every candidate is looked at, on all threads.
constexpr std::size_t kManyTiles = 4;

/// The tiles in which samples begin that may read one of the changed tiles: those tiles, and left of and above them.
std::vector<int> tilesReading(const std::vector<int>& changedTiles, int tilesAcross)
{
    std::vector<int> reading;
    reading.reserve(changedTiles.size() * 4);
    for (const int tile : changedTiles) {
        const bool hasLeft = tile % tilesAcross > 0;
        const bool hasUpper = tile >= tilesAcross;
        reading.push_back(tile);
        if (hasLeft)
            reading.push_back(tile - 1);
        if (hasUpper)
            reading.push_back(tile - tilesAcross);
        if (hasLeft && hasUpper)
            reading.push_back(tile - tilesAcross - 1);
    }
    std::sort(reading.begin(), reading.end());
    reading.erase(std::unique(reading.begin(), reading.end()), reading.end());
    return reading;
}

} // namespace

TileIndex::TileIndex(std::span<const glm::vec2> uvs, int rasterSize)
{
    const int across = rasterSize / TiledRaster::kTileSize;
    const auto tileOf = [&](glm::vec2 uv) {
        const glm::ivec2 texel = TiledRaster::footprint(uv, rasterSize) / TiledRaster::kTileSize;
        const int tile = texel.y * across + texel.x;
        return static_cast<std::size_t>(tile);
    };
    m_start.assign(static_cast<std::size_t>(across) * static_cast<std::size_t>(across) + 1, 0);
    for (const glm::vec2& uv : uvs)
        ++m_start[tileOf(uv) + 1];
    for (std::size_t tile = 0; tile + 1 < m_start.size(); ++tile)
        m_start[tile + 1] += m_start[tile];
    m_slots.resize(uvs.size());
    std::vector<std::uint32_t> next(m_start.begin(), m_start.end() - 1);
    for (std::uint32_t slot = 0; slot < uvs.size(); ++slot)
        m_slots[next[tileOf(uvs[slot])]++] = slot;
}

std::vector<std::uint32_t> TileIndex::slotsOf(std::span<const int> tiles) const
{
    std::vector<std::uint32_t> slots;
    for (const int tile : tiles) {
        const std::span<const std::uint32_t> those = slotsOf(tile);
        slots.insert(slots.end(), those.begin(), those.end());
    }
    return slots;
}

std::optional<std::vector<int>> tilesThatDiffer(const TiledRaster& before, const TiledRaster& after)
{
    if (before.size() != after.size() || before.channels() != after.channels())
        return std::nullopt;
    std::vector<int> changed;
    for (int tile = 0; tile < after.tileCount(); ++tile)
        if (before.tile(tile) != after.tile(tile))
            changed.push_back(tile);
    if (changed.size() * kManyTiles > static_cast<std::size_t>(after.tileCount()))
        return std::nullopt;
    return tilesReading(changed, after.tilesAcross());
}

} // namespace hairpaint::sim
