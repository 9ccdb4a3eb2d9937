// Counting, and comparing tiles: first their pointers, then their texels.
#include "sim/groom/tile_index.h"

#include <algorithm>
#include <map>

namespace hairpaint::sim {

namespace {

constexpr int kTile = TiledRaster::kTileSize;
/// Past this fraction of changed tiles every candidate is looked at, on all threads.
constexpr std::size_t kManyTiles = 4;

bool mayDiffer(const RasterTilePtr& before, const RasterTilePtr& after)
{
    return before != after && !(before->isUniform() && after->isUniform() && before->uniform == after->uniform);
}

/// The smallest rectangle around the texels that differ, counted from the tile's corner; empty where none does.
TexelRect differingTexels(const RasterTile& a, const RasterTile& b, int channels)
{
    if (a.isUniform() && b.isUniform())
        return a.uniform == b.uniform ? TexelRect{} : TexelRect{0, 0, kTile, kTile};
    const std::vector<std::uint16_t> filled = a.isUniform()   ? expanded(a, channels)
                                              : b.isUniform() ? expanded(b, channels)
                                                              : std::vector<std::uint16_t>{};
    const std::span<const std::uint16_t> ofA = a.isUniform() ? filled : a.pixels;
    const std::span<const std::uint16_t> ofB = b.isUniform() ? filled : b.pixels;
    TexelRect rect{kTile, kTile, 0, 0};
    const std::size_t rowLength = std::size_t{kTile} * static_cast<std::size_t>(channels);
    for (int y = 0; y < kTile; ++y) {
        const auto rowA = ofA.subspan(static_cast<std::size_t>(y) * rowLength, rowLength);
        const auto rowB = ofB.subspan(static_cast<std::size_t>(y) * rowLength, rowLength);
        if (std::ranges::equal(rowA, rowB))
            continue;
        const auto first = std::mismatch(rowA.begin(), rowA.end(), rowB.begin()).first - rowA.begin();
        const auto last = rowA.rend() - std::mismatch(rowA.rbegin(), rowA.rend(), rowB.rbegin()).first;
        rect.x0 = std::min(rect.x0, static_cast<int>(first) / channels);
        rect.x1 = std::max(rect.x1, (static_cast<int>(last) + channels - 1) / channels);
        rect.y0 = std::min(rect.y0, y);
        rect.y1 = y + 1;
    }
    return rect.empty() ? TexelRect{} : rect;
}

/// The smallest rectangle around both.
TexelRect around(const TexelRect& a, const TexelRect& b)
{
    if (a.empty())
        return b;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

TexelRect within(const TexelRect& a, const TexelRect& b)
{
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

} // namespace

TileIndex::TileIndex(std::span<const glm::vec2> uvs, int rasterSize) : m_tilesAcross(rasterSize / kTile)
{
    const auto tileOf = [&](glm::ivec2 texel) {
        const int tile = texel.y / kTile * m_tilesAcross + texel.x / kTile;
        return static_cast<std::size_t>(tile);
    };
    const auto across = static_cast<std::size_t>(m_tilesAcross);
    m_start.assign(across * across + 1, 0);
    for (const glm::vec2& uv : uvs)
        ++m_start[tileOf(TiledRaster::footprint(uv, rasterSize)) + 1];
    for (std::size_t tile = 0; tile + 1 < m_start.size(); ++tile)
        m_start[tile + 1] += m_start[tile];
    m_entries.resize(uvs.size());
    std::vector<std::uint32_t> next(m_start.begin(), m_start.end() - 1);
    for (std::uint32_t slot = 0; slot < uvs.size(); ++slot) {
        const glm::ivec2 texel = TiledRaster::footprint(uvs[slot], rasterSize);
        m_entries[next[tileOf(texel)]++] = {slot, static_cast<std::uint16_t>(texel.x),
                                            static_cast<std::uint16_t>(texel.y)};
    }
}

std::vector<std::uint32_t> TileIndex::slotsIn(std::span<const TexelRect> footprints) const
{
    std::vector<std::uint32_t> slots;
    for (const TexelRect& rect : footprints) {
        const int tile = rect.y0 / kTile * m_tilesAcross + rect.x0 / kTile;
        const auto at = static_cast<std::size_t>(tile);
        for (std::uint32_t i = m_start[at]; i < m_start[at + 1]; ++i) {
            const Entry& entry = m_entries[i];
            if (entry.x >= rect.x0 && entry.x < rect.x1 && entry.y >= rect.y0 && entry.y < rect.y1)
                slots.push_back(entry.slot);
        }
    }
    return slots;
}

std::optional<std::vector<TexelRect>> footprintsThatDiffer(const TiledRaster& before, const TiledRaster& after)
{
    if (before.size() != after.size() || before.channels() != after.channels())
        return std::nullopt;
    std::vector<int> changed;
    for (int tile = 0; tile < after.tileCount(); ++tile)
        if (mayDiffer(before.tile(tile), after.tile(tile)))
            changed.push_back(tile);
    if (changed.size() * kManyTiles > static_cast<std::size_t>(after.tileCount()))
        return std::nullopt;

    std::map<int, TexelRect> footprints; ///< By the tile that they are in.
    for (const int tile : changed) {
        const TexelRect differing = differingTexels(*before.tile(tile), *after.tile(tile), after.channels());
        if (differing.empty())
            continue;
        // A sample reads the texel at which it begins, that to its right and those below both.
        const TexelRect bounds = after.tileRect(tile);
        const TexelRect readers{std::max(bounds.x0 + differing.x0 - 1, 0), std::max(bounds.y0 + differing.y0 - 1, 0),
                                bounds.x0 + differing.x1, bounds.y0 + differing.y1};
        for (const int y : {bounds.y0 - kTile, bounds.y0})
            for (const int x : {bounds.x0 - kTile, bounds.x0}) {
                const TexelRect part = within(readers, {x, y, x + kTile, y + kTile});
                if (part.empty())
                    continue;
                TexelRect& rect = footprints[after.tileIndexAt(x, y)];
                rect = around(rect, part);
            }
    }
    std::vector<TexelRect> rects;
    rects.reserve(footprints.size());
    for (const auto& [tile, rect] : footprints)
        rects.push_back(rect);
    return rects;
}

} // namespace hairpaint::sim
