// Maps made visible tile by tile.
#include "model/map_colours.h"

#include "sim/base/parallel.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

sim::Texel colourOf(const std::uint16_t* value, const MapSpec& spec)
{
    if (spec.texel == TexelKind::Colour)
        return {value[0], value[1], value[2], 0};
    const QRgb colour = spec.texel == TexelKind::Index
                            ? spec.palette[std::min<std::size_t>(value[0], spec.palette.size() - 1)].colour
                            : scaleToColour(spec, static_cast<float>(value[0]) / 65535.0F, false);
    const auto wide = [](int channel) { return static_cast<std::uint16_t>(channel * 257); };
    return {wide(qRed(colour)), wide(qGreen(colour)), wide(qBlue(colour)), 0};
}

sim::RasterTilePtr colouredTile(const sim::RasterTile& from, std::size_t channels, const MapSpec& spec)
{
    auto tile = std::make_shared<sim::RasterTile>();
    if (from.isUniform())
        tile->uniform = colourOf(from.uniform.data(), spec);
    tile->pixels.reserve(from.pixels.size() / channels * 3);
    for (std::size_t at = 0; at < from.pixels.size(); at += channels) {
        const sim::Texel colour = colourOf(from.pixels.data() + at, spec);
        tile->pixels.insert(tile->pixels.end(), colour.begin(), colour.begin() + 3);
    }
    return tile;
}

/// Tiles that `before` has too come from `colouredBefore`; null: none.
std::shared_ptr<const sim::TiledRaster> coloured(const sim::TiledRaster& resolved, const MapSpec& spec,
                                                 const sim::TiledRaster* before, const sim::TiledRaster* colouredBefore)
{
    auto raster = std::make_shared<sim::TiledRaster>(resolved.size(), 3);
    const auto channels = static_cast<std::size_t>(resolved.channels());
    std::vector<sim::RasterTilePtr> tiles(static_cast<std::size_t>(resolved.tileCount()));
    sim::parallelFor(tiles.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t at = begin; at < end; ++at) {
            const int index = static_cast<int>(at);
            tiles[at] = before != nullptr && before->tile(index) == resolved.tile(index)
                            ? colouredBefore->tile(index)
                            : colouredTile(*resolved.tile(index), channels, spec);
        }
    });
    for (std::size_t index = 0; index < tiles.size(); ++index)
        raster->setTile(static_cast<int>(index), std::move(tiles[index]));
    return raster;
}

} // namespace

std::shared_ptr<const sim::TiledRaster> colouredMap(const sim::TiledRaster& resolved, const MapSpec& spec)
{
    return coloured(resolved, spec, nullptr, nullptr);
}

std::shared_ptr<const sim::TiledRaster> MapColours::of(std::shared_ptr<const sim::TiledRaster> resolved,
                                                       const MapSpec& spec)
{
    if (m_resolved == resolved && m_spec == &spec)
        return m_coloured;
    const bool known = m_resolved && m_spec == &spec && m_resolved->size() == resolved->size();
    m_coloured = coloured(*resolved, spec, known ? m_resolved.get() : nullptr, m_coloured.get());
    m_resolved = std::move(resolved);
    m_spec = &spec;
    return m_coloured;
}

} // namespace hairpaint::model
