// Copy-on-write tiles: see the header.
#include "sim/base/tiled_raster.h"

#include <algorithm>
#include <cassert>

namespace hairpaint::sim {

namespace {

constexpr int kTile = TiledRaster::kTileSize;
constexpr std::size_t kTileTexels = static_cast<std::size_t>(kTile) * kTile;

std::size_t texelOffset(int x, int y, int channels)
{
    return (static_cast<std::size_t>(y % kTile) * kTile + static_cast<std::size_t>(x % kTile)) *
           static_cast<std::size_t>(channels);
}

/// Not a number becomes 0.
float unitClamp(float x)
{
    if (!(x > 0.0F))
        return 0.0F;
    return x < 1.0F ? x : 1.0F;
}

/// The four texels around a uv and its place between them.
struct Footprint
{
    Footprint(glm::vec2 uv, int size)
    {
        const float x = unitClamp(uv.x) * static_cast<float>(size) - 0.5F;
        const float y = (1.0F - unitClamp(uv.y)) * static_cast<float>(size) - 0.5F;
        const int left = x < 0.0F ? -1 : static_cast<int>(x);
        const int top = y < 0.0F ? -1 : static_cast<int>(y);
        fractionX = x - static_cast<float>(left);
        fractionY = y - static_cast<float>(top);
        x0 = std::max(left, 0);
        y0 = std::max(top, 0);
        x1 = std::min(left + 1, size - 1);
        y1 = std::min(top + 1, size - 1);
    }

    /// In this form equal texels give exactly their value, however they are stored.
    [[nodiscard]] float blend(std::uint16_t a, std::uint16_t b, std::uint16_t c, std::uint16_t d) const
    {
        const auto mix = [](float from, float to, float fraction) { return from + (to - from) * fraction; };
        const float upper = mix(static_cast<float>(a), static_cast<float>(b), fractionX);
        const float lower = mix(static_cast<float>(c), static_cast<float>(d), fractionX);
        return mix(upper, lower, fractionY) / 65535.0F;
    }

    int x0, y0, x1, y1;
    float fractionX, fractionY;
};

} // namespace

TiledRaster::TiledRaster(int size, int channels, Texel fill)
    : m_size(size), m_channels(channels), m_tilesAcross(size / kTileSize)
{
    assert(size >= kTileSize && size % kTileSize == 0 && channels >= 1 && channels <= 4);
    for (auto channel = static_cast<std::size_t>(channels); channel < fill.size(); ++channel)
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

glm::ivec2 TiledRaster::footprint(glm::vec2 uv, int size)
{
    const Footprint f(uv, size);
    return {f.x0, f.y0};
}

glm::vec4 TiledRaster::sampleBilinear(glm::vec2 uv) const
{
    const Footprint f(uv, m_size);
    const Texel a = texel(f.x0, f.y0);
    const Texel b = texel(f.x1, f.y0);
    const Texel c = texel(f.x0, f.y1);
    const Texel d = texel(f.x1, f.y1);
    glm::vec4 value(0.0F);
    for (int channel = 0; channel < m_channels; ++channel) {
        const auto i = static_cast<std::size_t>(channel);
        value[channel] = f.blend(a[i], b[i], c[i], d[i]);
    }
    return value;
}

float TiledRaster::sampleScalar(glm::vec2 uv) const
{
    const Footprint f(uv, m_size);
    if (f.x0 / kTile != f.x1 / kTile || f.y0 / kTile != f.y1 / kTile)
        return f.blend(texel(f.x0, f.y0)[0], texel(f.x1, f.y0)[0], texel(f.x0, f.y1)[0], texel(f.x1, f.y1)[0]);
    const RasterTile& tile = *m_tiles[static_cast<std::size_t>(tileIndexAt(f.x0, f.y0))];
    if (tile.isUniform())
        return static_cast<float>(tile.uniform[0]) / 65535.0F;
    const std::uint16_t* upper = tile.pixels.data() + texelOffset(f.x0, f.y0, m_channels);
    const std::uint16_t* lower = tile.pixels.data() + texelOffset(f.x0, f.y1, m_channels);
    const std::ptrdiff_t right = f.x1 > f.x0 ? m_channels : 0;
    return f.blend(upper[0], upper[right], lower[0], lower[right]);
}

Texel TiledRaster::sampleNearest(glm::vec2 uv) const
{
    const auto size = static_cast<float>(m_size);
    const int x = std::min(static_cast<int>(unitClamp(uv.x) * size), m_size - 1);
    const int y = std::min(static_cast<int>((1.0F - unitClamp(uv.y)) * size), m_size - 1);
    return texel(x, y);
}

std::optional<Texel> TiledRaster::uniformValue() const
{
    const RasterTilePtr& first = m_tiles.front();
    for (const RasterTilePtr& tile : m_tiles)
        if (tile != first && !(tile->isUniform() && tile->uniform == first->uniform))
            return std::nullopt;
    return first->isUniform() ? std::optional(first->uniform) : std::nullopt;
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
