// Copy-on-write tiles: see the header.
#include "sim/base/tiled_raster.h"

#include <algorithm>
#include <cassert>

namespace hairpaint::sim {

namespace {

constexpr int kTile = TiledRaster::kTileSize;
static_assert(kTileTexels == static_cast<std::size_t>(kTile) * kTile);

std::size_t texelOffset(int x, int y, int channels)
{
    return (static_cast<std::size_t>(y % kTile) * kTile + static_cast<std::size_t>(x % kTile)) *
           static_cast<std::size_t>(channels);
}

/// One to four channels; copying a number of them that is not known calls the library for a few bytes.
Texel texelOf(const std::uint16_t* from, int channels)
{
    Texel texel{from[0]};
    if (channels > 1)
        texel[1] = from[1];
    if (channels > 2)
        texel[2] = from[2];
    if (channels > 3)
        texel[3] = from[3];
    return texel;
}

/// Not a number becomes 0.
float unitClamp(float x)
{
    if (!(x > 0.0F))
        return 0.0F;
    return x < 1.0F ? x : 1.0F;
}

/// The four texels around a uv and its weights between them.
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

std::optional<Texel> commonTexel(std::span<const std::uint16_t> pixels)
{
    const std::size_t channels = pixels.size() / kTileTexels;
    if (!std::equal(pixels.begin() + static_cast<std::ptrdiff_t>(channels), pixels.end(), pixels.begin()))
        return std::nullopt;
    Texel value{};
    std::copy_n(pixels.begin(), channels, value.begin());
    return value;
}

std::vector<std::uint16_t> expanded(const RasterTile& tile, int channels)
{
    if (!tile.isUniform())
        return tile.pixels;
    const auto step = static_cast<std::size_t>(channels);
    std::vector<std::uint16_t> pixels(kTileTexels * step);
    std::copy_n(tile.uniform.begin(), step, pixels.begin());
    // What is there, once more after itself: the number of texels is a power of two.
    for (std::size_t done = step; done < pixels.size(); done *= 2)
        std::copy_n(pixels.begin(), done, pixels.begin() + static_cast<std::ptrdiff_t>(done));
    return pixels;
}

RasterTile folded(RasterTile tile)
{
    if (tile.isUniform())
        return tile;
    if (const std::optional<Texel> value = commonTexel(tile.pixels))
        return {.uniform = *value, .pixels = {}};
    return {.uniform = {}, .pixels = std::move(tile.pixels)};
}

bool sameTexels(const RasterTile& a, const RasterTile& b)
{
    if (a.isUniform() != b.isUniform())
        return a.isUniform() ? commonTexel(b.pixels) == a.uniform : commonTexel(a.pixels) == b.uniform;
    return a.isUniform() ? a.uniform == b.uniform : a.pixels == b.pixels;
}

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
    if (slot.use_count() > 1 || slot->isUniform()) {
        auto own = std::make_shared<RasterTile>();
        own->pixels = expanded(*slot, m_channels);
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
    if (const std::optional<Texel> value = commonTexel(tile.pixels))
        setUniform(tileIndex, *value);
}

const std::uint16_t* TiledRaster::channelsAt(int x, int y) const
{
    const RasterTile& tile = *m_tiles[static_cast<std::size_t>(tileIndexAt(x, y))];
    return tile.isUniform() ? tile.uniform.data() : tile.pixels.data() + texelOffset(x, y, m_channels);
}

Texel TiledRaster::texel(int x, int y) const
{
    return texelOf(channelsAt(x, y), m_channels);
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

std::array<const std::uint16_t*, 4> TiledRaster::corners(glm::ivec2 first, glm::ivec2 last) const
{
    // Unsigned, dividing is a shift.
    const auto tileOf = [](int at) { return static_cast<unsigned>(at) / unsigned{kTile}; };
    if (tileOf(first.x) != tileOf(last.x) || tileOf(first.y) != tileOf(last.y))
        return {channelsAt(first.x, first.y), channelsAt(last.x, first.y), channelsAt(first.x, last.y),
                channelsAt(last.x, last.y)};
    const RasterTile& tile = *m_tiles[static_cast<std::size_t>(tileIndexAt(first.x, first.y))];
    if (tile.isUniform())
        return {tile.uniform.data(), tile.uniform.data(), tile.uniform.data(), tile.uniform.data()};
    const std::uint16_t* upper = tile.pixels.data() + texelOffset(first.x, first.y, m_channels);
    const std::uint16_t* lower = tile.pixels.data() + texelOffset(first.x, last.y, m_channels);
    const std::ptrdiff_t right = last.x > first.x ? m_channels : 0;
    return {upper, upper + right, lower, lower + right};
}

glm::vec4 TiledRaster::sampleBilinear(glm::vec2 uv) const
{
    const Footprint f(uv, m_size);
    const auto [a, b, c, d] = corners({f.x0, f.y0}, {f.x1, f.y1});
    glm::vec4 value(0.0F);
    for (int i = 0; i < m_channels; ++i)
        value[i] = f.blend(a[i], b[i], c[i], d[i]);
    return value;
}

float TiledRaster::sampleScalar(glm::vec2 uv) const
{
    const Footprint f(uv, m_size);
    const auto [a, b, c, d] = corners({f.x0, f.y0}, {f.x1, f.y1});
    // One texel that stands for all of a tile: what blend() makes of four equal ones. Diagonal tiles may be one and the
    // same, with others between them.
    return a == b && a == c && a == d ? static_cast<float>(*a) / 65535.0F : f.blend(*a, *b, *c, *d);
}

TiledRaster::Neighbours TiledRaster::neighbours(glm::vec2 uv) const
{
    const Footprint f(uv, m_size);
    const std::array<const std::uint16_t*, 4> channels = corners({f.x0, f.y0}, {f.x1, f.y1});
    Neighbours found{.weights = {(1.0F - f.fractionX) * (1.0F - f.fractionY), f.fractionX * (1.0F - f.fractionY),
                                 (1.0F - f.fractionX) * f.fractionY, f.fractionX * f.fractionY}};
    for (std::size_t i = 0; i < channels.size(); ++i)
        found.texels[i] = texelOf(channels[i], m_channels);
    return found;
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
    for (int index = 0; index < a.tileCount(); ++index)
        if (a.tile(index) != b.tile(index) && !sameTexels(*a.tile(index), *b.tile(index)))
            return false;
    return true;
}

} // namespace hairpaint::sim
