// Tiles first, then the candidates that sample them.
#include "sim/groom/map_changes.h"

#include "sim/base/parallel.h"

#include <algorithm>

namespace hairpaint::sim {

namespace {

/// Past this share of changed tiles every candidate is looked at, on all threads.
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

const TileIndex& MapChanges::indexFor(int rasterSize)
{
    const auto found = m_indices.find(rasterSize);
    if (found != m_indices.end())
        return found->second;
    return m_indices.emplace(rasterSize, TileIndex(m_roots->uv, rasterSize)).first->second;
}

void MapChanges::prepare(const GroupMaps& maps)
{
    for (const auto* map : {&maps.density, &maps.length, &maps.curl, &maps.braid, &maps.colour, &maps.clump, &maps.gel})
        (void)indexFor((*map)->size());
}

template<typename Differs>
void MapChanges::compare(const TiledRaster& before, const TiledRaster& after, const Differs& differs, SlotSet& changed)
{
    const bool sameShape = before.size() == after.size() && before.channels() == after.channels();
    std::vector<int> changedTiles;
    if (sameShape) {
        for (int tile = 0; tile < after.tileCount(); ++tile)
            if (before.tile(tile) != after.tile(tile))
                changedTiles.push_back(tile);
        if (changedTiles.empty())
            return;
    }
    if (!sameShape || changedTiles.size() * kManyTiles > static_cast<std::size_t>(after.tileCount())) {
        parallelFor(changed.chunkCount(), 4, [&](std::size_t begin, std::size_t end) {
            const std::size_t last = std::min(end * kChunkSlots, m_roots->count());
            for (std::size_t slot = begin * kChunkSlots; slot < last; ++slot)
                if (differs(static_cast<std::uint32_t>(slot)))
                    changed.insert(static_cast<std::uint32_t>(slot));
        });
        return;
    }
    const TileIndex& index = indexFor(after.size());
    for (const int tile : tilesReading(changedTiles, after.tilesAcross()))
        for (const std::uint32_t slot : index.slotsOf(tile))
            if (differs(slot))
                changed.insert(slot);
}

void MapChanges::find(const GroupMaps& before, const GroupMaps& after, SlotSet& changed)
{
    const std::vector<glm::vec2>& uvs = m_roots->uv;
    const auto compareScalars = [&](const auto& a, const auto& b) {
        if (a != b)
            compare(
                *a, *b, [&](std::uint32_t slot) { return a->sampleScalar(uvs[slot]) != b->sampleScalar(uvs[slot]); },
                changed);
    };
    compareScalars(before.density, after.density);
    compareScalars(before.length, after.length);
    compareScalars(before.curl, after.curl);
    compareScalars(before.clump, after.clump);
    if (before.colour != after.colour) {
        compare(
            *before.colour, *after.colour,
            [&](std::uint32_t slot) {
                return before.colour->sampleBilinear(uvs[slot]) != after.colour->sampleBilinear(uvs[slot]);
            },
            changed);
    }
    if (before.braid != after.braid) {
        compare(
            *before.braid, *after.braid,
            [&](std::uint32_t slot) {
                return before.braid->sampleNearest(uvs[slot])[0] != after.braid->sampleNearest(uvs[slot])[0];
            },
            changed);
    }
    if (before.gel != after.gel) {
        const auto basisCount = static_cast<std::uint32_t>(m_roots->basisSlot.size());
        compare(
            *before.gel, *after.gel,
            [&](std::uint32_t slot) {
                return m_roots->rankOfSlot[slot] < basisCount &&
                       before.gel->sampleScalar(uvs[slot]) != after.gel->sampleScalar(uvs[slot]);
            },
            changed);
    }
}

} // namespace hairpaint::sim
