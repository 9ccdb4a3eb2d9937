// Maps made visible tile by tile.
#include "model/maps/map_colours.h"

#include "model/maps/texel_ops.h"
#include "model/values/srgb.h"
#include "sim/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr float kMostLift = 40.0F;       ///< Strength at which a black scale lifts low values; see shownFraction().
constexpr float kLeastNightLight = 0.2F; ///< Relative luminance at 1 on night paper.
constexpr std::size_t kTableSteps = 4096;
using ColourTable = std::array<QRgb, kTableSteps>;

float luminance(QRgb colour)
{
    const auto channel = [](int byte) { return linearFromSrgb(static_cast<float>(byte) / 255.0F); };
    return 0.2126F * channel(qRed(colour)) + 0.7152F * channel(qGreen(colour)) + 0.0722F * channel(qBlue(colour));
}

/// How far along a scale from the paper's colour to its own the values are shown.
class ShownScale
{
public:
    explicit ShownScale(const MapSpec& spec)
    {
        const float dark = 1.0F - luminance(spec.scaleColour);
        m_lift = kMostLift * dark * dark;
        m_whole = std::log1p(m_lift);
    }

    [[nodiscard]] float fractionAt(float value) const
    {
        constexpr float kLeastLift = 0.01F;
        const float v = std::clamp(value, 0.0F, 1.0F);
        return m_lift < kLeastLift ? v : std::log1p(m_lift * v) / m_whole;
    }

private:
    float m_lift = 0.0F;
    float m_whole = 0.0F;
};

/// The colour at 1: lightened evenly in linear light where it would be too dark.
std::array<float, 3> shownFull(const MapSpec& spec, bool nightPaper)
{
    const float light = luminance(spec.scaleColour);
    const float white = nightPaper ? std::max(0.0F, (kLeastNightLight - light) / (1.0F - light)) : 0.0F;
    const auto channel = [white](int byte) {
        const float own = linearFromSrgb(static_cast<float>(byte) / 255.0F);
        return srgbFromLinear(own + (1.0F - own) * white);
    };
    return {channel(qRed(spec.scaleColour)), channel(qGreen(spec.scaleColour)), channel(qBlue(spec.scaleColour))};
}

ColourTable makeTable(const MapSpec& spec, bool nightPaper)
{
    ColourTable table{};
    const std::array<float, 3> full = shownFull(spec, nightPaper);
    const float paper = nightPaper ? 0.0F : 1.0F;
    const ShownScale scale(spec);
    for (std::size_t i = 0; i < kTableSteps; ++i) {
        const float t = scale.fractionAt(static_cast<float>(i) / (kTableSteps - 1));
        std::array<int, 3> mixed{};
        for (std::size_t c = 0; c < 3; ++c)
            mixed[c] = static_cast<int>(std::lround((paper + (full[c] - paper) * t) * 255.0F));
        table[i] = qRgb(mixed[0], mixed[1], mixed[2]);
    }
    return table;
}

/// By map: the tables for white paper and for night paper.
std::vector<std::array<ColourTable, 2>> makeTables()
{
    std::vector<std::array<ColourTable, 2>> tables;
    for (const MapSpec& spec : mapSpecs())
        tables.push_back({makeTable(spec, false), makeTable(spec, true)});
    return tables;
}

sim::RasterTilePtr colouredTile(const sim::RasterTile& from, std::size_t channels, const MapSpec& spec)
{
    auto tile = std::make_shared<sim::RasterTile>();
    if (from.isUniform()) {
        shownColours(spec, false, from.uniform.data(), 0, 1, tile->uniform.data());
    } else {
        tile->pixels.resize(sim::kTileTexels * 3);
        shownColours(spec, false, from.pixels.data(), channels, sim::kTileTexels, tile->pixels.data());
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

float shownFraction(const MapSpec& spec, float value)
{
    return ShownScale(spec).fractionAt(value);
}

QRgb shownColour(const MapSpec& spec, std::uint16_t value, bool nightPaper)
{
    static const std::vector<std::array<ColourTable, 2>> tables = makeTables();
    const std::size_t step = (static_cast<std::size_t>(value) * (kTableSteps - 1) + 32767U) / 65535U;
    return tables[static_cast<std::size_t>(spec.kind)][nightPaper ? 1 : 0][step];
}

void shownColours(const MapSpec& spec, bool nightPaper, const std::uint16_t* values, std::size_t step,
                  std::size_t count, std::uint16_t* colours)
{
    if (spec.scale == nullptr) {
        texelOps(spec).toColours(spec, nightPaper, values, step, count, colours);
        return;
    }
    for (std::size_t i = 0; i < count; ++i, values += step, colours += 3) {
        const QRgb colour = shownColour(spec, *values, nightPaper);
        colours[0] = static_cast<std::uint16_t>(qRed(colour) * 257);
        colours[1] = static_cast<std::uint16_t>(qGreen(colour) * 257);
        colours[2] = static_cast<std::uint16_t>(qBlue(colour) * 257);
    }
}

QRgb shownTexel(const MapSpec& spec, const sim::Texel& texel, bool nightPaper)
{
    return spec.scale != nullptr ? shownColour(spec, texel[0], nightPaper) : colourOfTexel(spec, texel, nightPaper);
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
