// Copy-on-write tiles: see the header.
#include "sim/tiled_raster.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr int kTile = TiledRaster::kTileSize;
constexpr std::size_t kTileTexels = static_cast<std::size_t>(kTile) * kTile;

std::size_t texelOffset(int x, int y, int channels)
{
    return (static_cast<std::size_t>(y % kTile) * kTile + static_cast<std::size_t>(x % kTile)) *
           static_cast<std::size_t>(channels);
}

} // namespace

TiledRaster::TiledRaster(int size, int channels, Texel fill)
    : m_size(size), m_channels(channels), m_tilesAcross(size / kTileSize)
{
    assert(size >= kTileSize && size % kTileSize == 0 && channels >= 1 && channels <= 4);
    for (std::size_t channel = static_cast<std::size_t>(channels); channel < fill.size(); ++channel)
        fill[channel] = 0;
    auto tile = std::make_shared<RasterTile>();
    tile->uniform = fill;
    m_tiles.assign(static_cast<std::size_t>(m_tilesAcross) * static_cast<std::size_t>(m_tilesAcross), tile);
}

TexelRect TiledRaster::tileRect(int tileIndex) const
{
    const int x = tileIndex % m_tilesAcross * kTileSize;
    const int y = tileIndex / m_tilesAcross * kTileSize;
    return {x, y, x + kTileSize, y + kTileSize};
}

void TiledRaster::setTile(int tileIndex, RasterTilePtr tile)
{
    m_tiles[static_cast<std::size_t>(tileIndex)] = std::move(tile);
}

void TiledRaster::setUniform(int tileIndex, Texel value)
{
    auto tile = std::make_shared<RasterTile>();
    tile->uniform = value;
    setTile(tileIndex, std::move(tile));
}

std::span<std::uint16_t> TiledRaster::writableTile(int tileIndex)
{
    RasterTilePtr& slot = m_tiles[static_cast<std::size_t>(tileIndex)];
    const auto channels = static_cast<std::size_t>(m_channels);
    if (slot.use_count() > 1 || slot->isUniform()) {
        auto own = std::make_shared<RasterTile>();
        if (slot->isUniform()) {
            own->pixels.resize(kTileTexels * channels);
            for (std::size_t i = 0; i < own->pixels.size(); ++i)
                own->pixels[i] = slot->uniform[i % channels];
        } else {
            own->pixels = slot->pixels;
        }
        slot = std::move(own);
    }
    // Sole owner now, and every tile is created non-const above or by a caller that handed it over.
    return const_cast<RasterTile&>(*slot).pixels;
}

void TiledRaster::compact(int tileIndex)
{
    const RasterTile& tile = *m_tiles[static_cast<std::size_t>(tileIndex)];
    if (tile.isUniform())
        return;
    const auto channels = static_cast<std::size_t>(m_channels);
    for (std::size_t i = channels; i < tile.pixels.size(); ++i)
        if (tile.pixels[i] != tile.pixels[i - channels])
            return;
    Texel value{};
    std::copy_n(tile.pixels.begin(), channels, value.begin());
    setUniform(tileIndex, value);
}

Texel TiledRaster::texel(int x, int y) const
{
    const RasterTile& tile = *m_tiles[static_cast<std::size_t>(tileIndexAt(x, y))];
    if (tile.isUniform())
        return tile.uniform;
    Texel value{};
    std::copy_n(tile.pixels.begin() + static_cast<std::ptrdiff_t>(texelOffset(x, y, m_channels)), m_channels,
                value.begin());
    return value;
}

void TiledRaster::setTexel(int x, int y, Texel value)
{
    const std::span<std::uint16_t> pixels = writableTile(tileIndexAt(x, y));
    std::copy_n(value.begin(), m_channels, pixels.begin() + static_cast<std::ptrdiff_t>(texelOffset(x, y, m_channels)));
}

glm::vec4 TiledRaster::sampleBilinear(glm::vec2 uv) const
{
    const auto size = static_cast<float>(m_size);
    const float x = std::clamp(uv.x, 0.0F, 1.0F) * size - 0.5F;
    const float y = (1.0F - std::clamp(uv.y, 0.0F, 1.0F)) * size - 0.5F;
    const float floorX = std::floor(x);
    const float floorY = std::floor(y);
    const float shareX = x - floorX;
    const float shareY = y - floorY;
    const int x0 = std::clamp(static_cast<int>(floorX), 0, m_size - 1);
    const int y0 = std::clamp(static_cast<int>(floorY), 0, m_size - 1);
    const int x1 = std::clamp(static_cast<int>(floorX) + 1, 0, m_size - 1);
    const int y1 = std::clamp(static_cast<int>(floorY) + 1, 0, m_size - 1);
    const auto asVector = [](const Texel& t) { return glm::vec4(t[0], t[1], t[2], t[3]) * (1.0F / 65535.0F); };
    const glm::vec4 top = asVector(texel(x0, y0)) * (1.0F - shareX) + asVector(texel(x1, y0)) * shareX;
    const glm::vec4 bottom = asVector(texel(x0, y1)) * (1.0F - shareX) + asVector(texel(x1, y1)) * shareX;
    return top * (1.0F - shareY) + bottom * shareY;
}

Texel TiledRaster::sampleNearest(glm::vec2 uv) const
{
    const auto size = static_cast<float>(m_size);
    const int x = std::clamp(static_cast<int>(std::clamp(uv.x, 0.0F, 1.0F) * size), 0, m_size - 1);
    const int y = std::clamp(static_cast<int>((1.0F - std::clamp(uv.y, 0.0F, 1.0F)) * size), 0, m_size - 1);
    return texel(x, y);
}

std::size_t TiledRaster::byteCount() const
{
    std::size_t bytes = 0;
    for (const RasterTilePtr& tile : m_tiles)
        bytes += tile->pixels.size() * sizeof(std::uint16_t);
    return bytes;
}

bool operator==(const TiledRaster& a, const TiledRaster& b)
{
    if (a.m_size != b.m_size || a.m_channels != b.m_channels)
        return false;
    for (int index = 0; index < a.tileCount(); ++index) {
        const RasterTilePtr& tileA = a.tile(index);
        const RasterTilePtr& tileB = b.tile(index);
        if (tileA == tileB)
            continue;
        if (tileA->isUniform() && tileB->isUniform()) {
            if (tileA->uniform != tileB->uniform)
                return false;
            continue;
        }
        const TexelRect rect = a.tileRect(index);
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int x = rect.x0; x < rect.x1; ++x)
                if (a.texel(x, y) != b.texel(x, y))
                    return false;
    }
    return true;
}

} // namespace hairpaint::sim
