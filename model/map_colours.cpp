// Maps made visible tile by tile.
#include "model/map_colours.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr float kMostLift = 40.0F;       ///< Of a black scale.
constexpr float kLeastNightLight = 0.2F; ///< Relative luminance at 1 on night paper.
constexpr std::size_t kTableSteps = 4096;
using ColourTable = std::array<QRgb, kTableSteps>;

float linear(float encoded)
{
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

float encoded(float linear)
{
    return linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

float luminance(QRgb colour)
{
    const auto channel = [](int byte) { return linear(static_cast<float>(byte) / 255.0F); };
    return 0.2126F * channel(qRed(colour)) + 0.7152F * channel(qGreen(colour)) + 0.0722F * channel(qBlue(colour));
}

/// The colour at 1: lightened evenly in linear light where it would be too dark.
std::array<float, 3> shownFull(const MapSpec& spec, bool nightPaper)
{
    const float light = luminance(spec.scaleColour);
    const float white = nightPaper ? std::max(0.0F, (kLeastNightLight - light) / (1.0F - light)) : 0.0F;
    const auto channel = [white](int byte) {
        const float own = linear(static_cast<float>(byte) / 255.0F);
        return encoded(own + (1.0F - own) * white);
    };
    return {channel(qRed(spec.scaleColour)), channel(qGreen(spec.scaleColour)), channel(qBlue(spec.scaleColour))};
}

ColourTable makeTable(const MapSpec& spec, bool nightPaper)
{
    ColourTable table{};
    const std::array<float, 3> full = shownFull(spec, nightPaper);
    const float paper = nightPaper ? 0.0F : 1.0F;
    for (std::size_t i = 0; i < kTableSteps; ++i) {
        const float t = shownFraction(spec, static_cast<float>(i) / (kTableSteps - 1));
        std::array<int, 3> mixed{};
        for (std::size_t c = 0; c < 3; ++c)
            mixed[c] = static_cast<int>(std::lround((paper + (full[c] - paper) * t) * 255.0F));
        table[i] = qRgb(mixed[0], mixed[1], mixed[2]);
    }
    return table;
}

/// Of every map, on white paper and on night paper.
std::vector<std::array<ColourTable, 2>> makeTables()
{
    std::vector<std::array<ColourTable, 2>> tables;
    for (const MapSpec& spec : mapSpecs())
        tables.push_back({makeTable(spec, false), makeTable(spec, true)});
    return tables;
}

sim::Texel colourOf(const std::uint16_t* value, const MapSpec& spec)
{
    if (spec.texel == TexelKind::Colour)
        return {value[0], value[1], value[2], 0};
    const QRgb colour = spec.texel == TexelKind::Index
                            ? spec.palette[std::min<std::size_t>(value[0], spec.palette.size() - 1)].colour
                            : shownColour(spec, value[0], false);
    const auto wide = [](int channel) { return static_cast<std::uint16_t>(channel * 257); };
    return {wide(qRed(colour)), wide(qGreen(colour)), wide(qBlue(colour)), 0};
}

} // namespace

float shownFraction(const MapSpec& spec, float value)
{
    const float dark = 1.0F - luminance(spec.scaleColour);
    const float lift = kMostLift * dark * dark;
    const float v = std::clamp(value, 0.0F, 1.0F);
    return lift < 0.01F ? v : std::log1p(lift * v) / std::log1p(lift);
}

QRgb shownColour(const MapSpec& spec, std::uint16_t value, bool nightPaper)
{
    static const std::vector<std::array<ColourTable, 2>> tables = makeTables();
    const std::size_t step = (static_cast<std::size_t>(value) * (kTableSteps - 1) + 32767U) / 65535U;
    return tables[static_cast<std::size_t>(spec.kind)][nightPaper ? 1 : 0][step];
}

std::shared_ptr<const sim::TiledRaster> colouredMap(const sim::TiledRaster& resolved, const MapSpec& spec)
{
    auto raster = std::make_shared<sim::TiledRaster>(resolved.size(), 3);
    const auto channels = static_cast<std::size_t>(resolved.channels());
    std::vector<sim::RasterTilePtr> tiles(static_cast<std::size_t>(resolved.tileCount()));
    sim::parallelFor(tiles.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const sim::RasterTile& from = *resolved.tile(static_cast<int>(index));
            auto tile = std::make_shared<sim::RasterTile>();
            if (from.isUniform())
                tile->uniform = colourOf(from.uniform.data(), spec);
            for (std::size_t at = 0; at < from.pixels.size(); at += channels) {
                const sim::Texel colour = colourOf(from.pixels.data() + at, spec);
                tile->pixels.insert(tile->pixels.end(), colour.begin(), colour.begin() + 3);
            }
            tiles[index] = std::move(tile);
        }
    });
    for (std::size_t index = 0; index < tiles.size(); ++index)
        raster->setTile(static_cast<int>(index), std::move(tiles[index]));
    return raster;
}

} // namespace hairpaint::model
