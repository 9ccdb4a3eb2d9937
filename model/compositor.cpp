// Resolving of layers, tile by tile.
#include "model/compositor.h"

#include "sim/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hairpaint::model {

namespace {

constexpr std::size_t kTileTexels = static_cast<std::size_t>(sim::TiledRaster::kTileSize) * sim::TiledRaster::kTileSize;

/// How one layer lies over what is below it.
struct LayerStep
{
    const sim::RasterTile* tile = nullptr;
    BlendMode blend = BlendMode::Normal;
    std::uint16_t opacity = 65535;
};

template<BlendMode blend>
std::uint16_t blended(std::uint16_t below, std::uint16_t value)
{
    if constexpr (blend == BlendMode::Multiply)
        return mul16(below, value);
    else
        return value;
}

sim::Texel stepTexel(const MapSpec& spec, const LayerStep& step, sim::Texel below, const sim::Texel& layer)
{
    const std::uint16_t share = mul16(layer[static_cast<std::size_t>(spec.valueChannels)], step.opacity);
    if (spec.texel == TexelKind::Index) {
        if (share >= kHalfCoverage)
            below[0] = layer[0];
        return below;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(spec.valueChannels); ++i) {
        const std::uint16_t above = step.blend == BlendMode::Multiply ? mul16(below[i], layer[i]) : layer[i];
        below[i] = lerp16(below[i], above, share);
    }
    return below;
}

template<int channels, BlendMode blend>
void stepPixels(const std::uint16_t* layer, std::uint16_t opacity, std::uint16_t* map)
{
    for (std::size_t texel = 0; texel < kTileTexels; ++texel) {
        const std::uint16_t* source = layer + texel * (channels + 1);
        std::uint16_t* target = map + texel * channels;
        const std::uint16_t share = mul16(source[channels], opacity);
        for (int i = 0; i < channels; ++i)
            target[i] = lerp16(target[i], blended<blend>(target[i], source[i]), share);
    }
}

void stepIndexPixels(const std::uint16_t* layer, std::uint16_t opacity, std::uint16_t* map)
{
    for (std::size_t texel = 0; texel < kTileTexels; ++texel)
        map[texel] = mul16(layer[texel * 2 + 1], opacity) >= kHalfCoverage ? layer[texel * 2] : map[texel];
}

/// A layer's tile of one value over pixels.
void stepUniform(const MapSpec& spec, const LayerStep& step, std::uint16_t* map)
{
    const auto channels = static_cast<std::size_t>(spec.valueChannels);
    for (std::size_t texel = 0; texel < kTileTexels; ++texel) {
        sim::Texel below{};
        std::copy_n(map + texel * channels, channels, below.begin());
        below = stepTexel(spec, step, below, step.tile->uniform);
        std::copy_n(below.begin(), channels, map + texel * channels);
    }
}

void stepTile(const MapSpec& spec, const LayerStep& step, std::uint16_t* map)
{
    const std::uint16_t* layer = step.tile->pixels.data();
    const bool multiply = step.blend == BlendMode::Multiply;
    if (step.tile->isUniform())
        stepUniform(spec, step, map);
    else if (spec.texel == TexelKind::Index)
        stepIndexPixels(layer, step.opacity, map);
    else if (spec.valueChannels == 1)
        multiply ? stepPixels<1, BlendMode::Multiply>(layer, step.opacity, map)
                 : stepPixels<1, BlendMode::Normal>(layer, step.opacity, map);
    else
        multiply ? stepPixels<3, BlendMode::Multiply>(layer, step.opacity, map)
                 : stepPixels<3, BlendMode::Normal>(layer, step.opacity, map);
}

/// The layers that show in a tile; from the last uniform, fully covering one upward, where there is one.
std::vector<LayerStep> stepsOf(const MapStack& stack, const MapSpec& spec, int tileIndex)
{
    std::vector<LayerStep> steps;
    for (const Layer& layer : stack.layers) {
        const sim::RasterTile& tile = *layer.raster.tile(tileIndex);
        const LayerStep step{&tile, layer.blend, unit16(layer.opacity)};
        if (!layer.visible || step.opacity == 0)
            continue;
        if (tile.isUniform()) {
            const std::uint16_t coverage = tile.uniform[static_cast<std::size_t>(spec.valueChannels)];
            if (coverage == 0)
                continue;
            if (mul16(coverage, step.opacity) == 65535 && layer.blend == BlendMode::Normal)
                steps.clear();
        }
        steps.push_back(step);
    }
    return steps;
}

bool sameTexels(const sim::RasterTile& a, const sim::RasterTile& b)
{
    return a.isUniform() == b.isUniform() && (a.isUniform() ? a.uniform == b.uniform : a.pixels == b.pixels);
}

sim::RasterTilePtr resolveTile(const MapStack& stack, int tileIndex)
{
    const MapSpec& spec = mapSpec(stack.kind);
    const std::vector<LayerStep> steps = stepsOf(stack, spec, tileIndex);
    auto result = std::make_shared<sim::RasterTile>();
    result->uniform = spec.defaultValue;
    const auto channels = static_cast<std::size_t>(spec.valueChannels);
    auto step = steps.begin();
    for (; step != steps.end() && step->tile->isUniform(); ++step)
        result->uniform = stepTexel(spec, *step, result->uniform, step->tile->uniform);
    if (step == steps.end())
        return result;
    result->pixels.resize(kTileTexels * channels);
    for (std::size_t i = 0; i < result->pixels.size(); ++i)
        result->pixels[i] = result->uniform[i % channels];
    for (; step != steps.end(); ++step)
        stepTile(spec, *step, result->pixels.data());
    // Back to one value where the texels are equal.
    if (std::equal(result->pixels.begin() + static_cast<std::ptrdiff_t>(channels), result->pixels.end(),
                   result->pixels.begin())) {
        std::copy_n(result->pixels.begin(), channels, result->uniform.begin());
        result->pixels = {};
    } else {
        result->uniform = {};
    }
    return result;
}

/// In parallel: a whole map at once when a project opens, or at each tick of a layer's opacity.
std::vector<sim::RasterTilePtr> tilesResolved(const MapStack& stack, std::span<const int> indices)
{
    constexpr std::size_t kTilesAtOnce = 8;
    std::vector<sim::RasterTilePtr> tiles(indices.size());
    sim::parallelFor(indices.size(), kTilesAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            tiles[i] = resolveTile(stack, indices[i]);
    });
    return tiles;
}

/// Whether two stacks differ in their tiles alone.
bool sameButTiles(const MapStack& a, const MapStack& b)
{
    return a.kind == b.kind && a.size == b.size &&
           std::ranges::equal(a.layers, b.layers, [](const Layer& x, const Layer& y) {
               return x.id == y.id && x.visible == y.visible && x.opacity == y.opacity && x.blend == y.blend &&
                      x.raster.size() == y.raster.size();
           });
}

} // namespace

std::uint16_t unit16(float value)
{
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 65535.0F));
}

sim::Texel resolveTexel(const MapStack& stack, int x, int y)
{
    const MapSpec& spec = mapSpec(stack.kind);
    sim::Texel result = spec.defaultValue;
    for (const Layer& layer : stack.layers)
        if (layer.visible)
            result = stepTexel(spec, {nullptr, layer.blend, unit16(layer.opacity)}, result, layer.raster.texel(x, y));
    return result;
}

sim::TiledRaster resolveStack(const MapStack& stack)
{
    const MapSpec& spec = mapSpec(stack.kind);
    sim::TiledRaster result(stack.size, spec.valueChannels, spec.defaultValue);
    std::vector<int> all(static_cast<std::size_t>(result.tileCount()));
    std::iota(all.begin(), all.end(), 0);
    std::vector<sim::RasterTilePtr> tiles = tilesResolved(stack, all);
    for (int index = 0; index < result.tileCount(); ++index) {
        sim::RasterTilePtr& tile = tiles[static_cast<std::size_t>(index)];
        if (!sameTexels(*tile, *result.tile(index)))
            result.setTile(index, std::move(tile));
    }
    return result;
}

ResolvedMap::ResolvedMap(const MapStack& stack)
    : m_seen(stack), m_result(std::make_shared<const sim::TiledRaster>(resolveStack(stack)))
{}

bool ResolvedMap::update(const MapStack& stack)
{
    if (stack.size != m_seen.size) {
        *this = ResolvedMap(stack);
        return true;
    }
    std::vector<int> tiles;
    const bool structureKept = sameButTiles(m_seen, stack);
    for (int index = 0; index < m_result->tileCount(); ++index) {
        bool differs = !structureKept;
        for (std::size_t layer = 0; layer < stack.layers.size() && !differs; ++layer)
            differs = stack.layers[layer].raster.tile(index) != m_seen.layers[layer].raster.tile(index);
        if (differs)
            tiles.push_back(index);
    }
    if (tiles.empty())
        return false;
    m_seen = stack;
    return resolveTiles(tiles);
}

bool ResolvedMap::updateTiles(const MapStack& stack, Id layer, std::span<const int> tiles)
{
    const auto now = std::ranges::find(stack.layers, layer, &Layer::id);
    const auto seen = std::ranges::find(m_seen.layers, layer, &Layer::id);
    if (now == stack.layers.end() || seen == m_seen.layers.end())
        return update(stack);
    for (const int index : tiles)
        seen->raster.setTile(index, now->raster.tile(index));
    return resolveTiles(tiles);
}

bool ResolvedMap::resolveTiles(std::span<const int> tiles)
{
    std::shared_ptr<sim::TiledRaster> next;
    std::vector<sim::RasterTilePtr> made = tilesResolved(m_seen, tiles);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const int index = tiles[i];
        sim::RasterTilePtr& tile = made[i];
        if (sameTexels(*tile, *m_result->tile(index)))
            continue;
        if (next == nullptr)
            next = std::make_shared<sim::TiledRaster>(*m_result);
        next->setTile(index, std::move(tile));
    }
    if (next == nullptr)
        return false;
    m_result = std::move(next);
    return true;
}

} // namespace hairpaint::model
