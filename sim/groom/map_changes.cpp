// Tiles first, then the candidates that sample them.
#include "sim/groom/map_changes.h"

#include "sim/base/parallel.h"

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

const TileIndex& MapChanges::indexFor(int rasterSize)
{
    const auto found = m_indices.find(rasterSize);
    if (found != m_indices.end())
        return found->second;
    return m_indices.emplace(rasterSize, TileIndex(m_roots->uv, rasterSize)).first->second;
}

void MapChanges::prepare(const GroupMaps& maps)
{
    for (const MapRule& rule : kMapRules)
        (void)indexFor(maps[rule.slot]->size());
}

template<typename Visit>
void MapChanges::visitCandidates(const TiledRaster& before, const TiledRaster& after, const Visit& visit)
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
        const std::size_t chunks = (m_roots->count() + kChunkSlots - 1) / kChunkSlots;
        parallelFor(chunks, 4, [&](std::size_t begin, std::size_t end) {
            const std::size_t last = std::min(end * kChunkSlots, m_roots->count());
            for (std::size_t slot = begin * kChunkSlots; slot < last; ++slot)
                visit(static_cast<std::uint32_t>(slot));
        });
        return;
    }
    const TileIndex& index = indexFor(after.size());
    for (const int tile : tilesReading(changedTiles, after.tilesAcross()))
        for (const std::uint32_t slot : index.slotsOf(tile))
            visit(slot);
}

template<typename Read>
void MapChanges::compare(const MapRule& rule, const Read& read, const TiledRaster& before, const TiledRaster& after,
                         ChangedSlots& changed)
{
    const auto basisCount = static_cast<std::uint32_t>(m_roots->basisSlot.size());
    const MapEffect effect = rule.effect;
    const bool ofAll = effect.hairs || effect.look;
    visitCandidates(before, after, [&](std::uint32_t slot) {
        const bool isBasis = effect.basis && m_roots->rankOfSlot[slot] < basisCount;
        if ((!ofAll && !isBasis) || read(before, m_roots->uv[slot]) == read(after, m_roots->uv[slot]))
            return;
        if (effect.hairs)
            changed.hairs.insert(slot);
        if (isBasis)
            changed.basis.insert(slot);
        if (effect.look)
            changed.look.insert(slot);
    });
}

void MapChanges::find(const GroupMaps& before, const GroupMaps& after, ChangedSlots& changed)
{
    const auto nearest = [](const TiledRaster& map, glm::vec2 uv) { return map.sampleNearest(uv); };
    const auto scalar = [](const TiledRaster& map, glm::vec2 uv) { return map.sampleScalar(uv); };
    const auto channels = [](const TiledRaster& map, glm::vec2 uv) { return map.sampleBilinear(uv); };
    for (const MapRule& rule : kMapRules) {
        const MapRaster& was = before[rule.slot];
        const MapRaster& is = after[rule.slot];
        // A map that shows another's own raster does not differ anywhere else.
        const auto isCompared = [&](const MapRule& other) {
            return other.slot < rule.slot && other.effect == rule.effect && before[other.slot] == was &&
                   after[other.slot] == is;
        };
        if (was == is || std::ranges::any_of(kMapRules, isCompared))
            continue;
        if (rule.sampling == MapSampling::Nearest)
            compare(rule, nearest, *was, *is, changed);
        else if (rule.channels == 1)
            compare(rule, scalar, *was, *is, changed);
        else
            compare(rule, channels, *was, *is, changed);
    }
}

} // namespace hairpaint::sim
