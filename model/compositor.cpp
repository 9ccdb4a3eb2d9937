// Resolving of layers, tile by tile.
#include "model/compositor.h"

#include "model/texel_ops.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

/// How one layer lies over what is below it.
struct LayerStep
{
    const sim::RasterTile* tile = nullptr;
    BlendMode blend = BlendMode::Normal;
    std::uint16_t opacity = 65535;
};

void stepTexel(const MapSpec& spec, const LayerStep& step, sim::Texel& below, const sim::Texel& layer)
{
    texelOps(spec).blend(step.blend, layer.data(), 0, step.opacity, below.data(), 1);
}

void stepTile(const MapSpec& spec, const LayerStep& step, std::uint16_t* map)
{
    const bool uniform = step.tile->isUniform();
    texelOps(spec).blend(step.blend, uniform ? step.tile->uniform.data() : step.tile->pixels.data(),
                         uniform ? 0 : static_cast<std::size_t>(spec.layerChannels()), step.opacity, map, kTileTexels);
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
        stepTexel(spec, *step, result->uniform, step->tile->uniform);
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

sim::Texel resolveTexel(const MapStack& stack, int x, int y)
{
    const MapSpec& spec = mapSpec(stack.kind);
    sim::Texel result = spec.defaultValue;
    for (const Layer& layer : stack.layers)
        if (layer.visible)
            stepTexel(spec, {nullptr, layer.blend, unit16(layer.opacity)}, result, layer.raster.texel(x, y));
    return result;
}

sim::TiledRaster resolveStack(const MapStack& stack)
{
    const MapSpec& spec = mapSpec(stack.kind);
    sim::TiledRaster result(stack.size, spec.valueChannels, spec.defaultValue);
    for (int index = 0; index < result.tileCount(); ++index) {
        sim::RasterTilePtr tile = resolveTile(stack, index);
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
    for (const int index : tiles) {
        sim::RasterTilePtr tile = resolveTile(m_seen, index);
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
