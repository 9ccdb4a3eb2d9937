// Resolving of layers, tile by tile.
#include "model/maps/compositor.h"

#include "model/maps/texel_ops.h"
#include "sim/base/parallel.h"

#include <algorithm>
#include <numeric>

namespace hairpaint::model {

namespace {

sim::TexelRect tileRectOf(const MapStack& stack, int tileIndex)
{
    constexpr int kTile = sim::TiledRaster::kTileSize;
    const int across = stack.size / kTile;
    const int x = tileIndex % across * kTile;
    const int y = tileIndex / across * kTile;
    return {x, y, x + kTile, y + kTile};
}

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
                         uniform ? 0 : static_cast<std::size_t>(spec.layerChannels()), step.opacity, map,
                         sim::kTileTexels);
}

/// The layers that show in a tile.
struct Steps
{
    std::vector<LayerStep> all;
    bool hideStart = false; ///< The first one covers all below it.
};

Steps stepsOf(const MapStack& stack, const MapSpec& spec, int tileIndex)
{
    Steps steps;
    for (const Layer& layer : stack.layers) {
        const sim::RasterTile& tile = *layer.raster.tile(tileIndex);
        const LayerStep step{&tile, layer.blend, unit16(layer.opacity)};
        if (!layer.visible || step.opacity == 0)
            continue;
        if (tile.isUniform()) {
            const std::uint16_t coverage = tile.uniform[static_cast<std::size_t>(spec.valueChannels)];
            if (coverage == 0)
                continue;
            if (mul16(coverage, step.opacity) == 65535 && layer.blend == BlendMode::Normal) {
                steps.all.clear();
                steps.hideStart = true;
            }
        }
        steps.all.push_back(step);
    }
    return steps;
}

/// A start's value for one texel of a map of `size`.
sim::Texel startTexel(const MapSpec& spec, const sim::TiledRaster& start, int size, int x, int y)
{
    if (start.size() == size)
        return start.texel(x, y);
    const glm::vec2 uv((static_cast<float>(x) + 0.5F) / static_cast<float>(size),
                       1.0F - (static_cast<float>(y) + 0.5F) / static_cast<float>(size));
    if (!spec.bilinear())
        return start.sampleNearest(uv);
    const glm::vec4 value = start.sampleBilinear(uv);
    return {unit16(value.x), unit16(value.y), unit16(value.z), unit16(value.w)};
}

sim::RasterTilePtr startTile(const MapStack& stack, const MapSpec& spec, const sim::TiledRaster* start, int tileIndex)
{
    if (start != nullptr && start->size() == stack.size)
        return start->tile(tileIndex);
    sim::RasterTile tile{.uniform = spec.defaultValue, .pixels = {}};
    if (start == nullptr)
        return std::make_shared<const sim::RasterTile>(std::move(tile));
    const auto channels = static_cast<std::size_t>(spec.valueChannels);
    const sim::TexelRect rect = tileRectOf(stack, tileIndex);
    tile.pixels.reserve(sim::kTileTexels * channels);
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x) {
            const sim::Texel texel = startTexel(spec, *start, stack.size, x, y);
            tile.pixels.insert(tile.pixels.end(), texel.begin(), texel.begin() + spec.valueChannels);
        }
    return std::make_shared<const sim::RasterTile>(sim::folded(std::move(tile)));
}

/// Whether a tile of a map of `size` may start from other texels.
bool startDiffers(const MapStack& stack, const sim::MapRaster& before, const sim::MapRaster& after, int tileIndex)
{
    if (before == after)
        return false;
    if (before == nullptr || after == nullptr || before->size() != after->size())
        return true;
    if (after->size() == stack.size)
        return before->tile(tileIndex) != after->tile(tileIndex);
    // The tiles that hold what is sampled, and the texels around it.
    const sim::TexelRect rect = tileRectOf(stack, tileIndex);
    const auto tileAt = [&](int texel, int beside) {
        const int there = static_cast<int>(std::int64_t{texel} * after->size() / stack.size) + beside;
        return std::clamp(there, 0, after->size() - 1) / sim::TiledRaster::kTileSize;
    };
    for (int row = tileAt(rect.y0, -1); row <= tileAt(rect.y1, 1); ++row)
        for (int column = tileAt(rect.x0, -1); column <= tileAt(rect.x1, 1); ++column) {
            const int index = row * after->tilesAcross() + column;
            if (before->tile(index) != after->tile(index))
                return true;
        }
    return false;
}

sim::RasterTilePtr resolveTile(const MapStack& stack, const sim::TiledRaster* start, int tileIndex)
{
    const MapSpec& spec = mapSpec(stack.kind);
    const Steps steps = stepsOf(stack, spec, tileIndex);
    const sim::RasterTilePtr below = startTile(stack, spec, steps.hideStart ? nullptr : start, tileIndex);
    if (steps.all.empty())
        return below;
    sim::RasterTile result = *below;
    auto step = steps.all.begin();
    if (result.isUniform()) {
        for (; step != steps.all.end() && step->tile->isUniform(); ++step)
            stepTexel(spec, *step, result.uniform, step->tile->uniform);
        if (step == steps.all.end())
            return std::make_shared<const sim::RasterTile>(std::move(result));
        result.pixels = sim::expanded(result, spec.valueChannels);
    }
    for (; step != steps.all.end(); ++step)
        stepTile(spec, *step, result.pixels.data());
    return std::make_shared<const sim::RasterTile>(sim::folded(std::move(result)));
}

/// In parallel: a whole map at once when a project opens, or at each tick of a layer's opacity.
std::vector<sim::RasterTilePtr> tilesResolved(const MapStack& stack, const sim::TiledRaster* start,
                                              std::span<const int> indices)
{
    constexpr std::size_t kTilesAtOnce = 8;
    std::vector<sim::RasterTilePtr> tiles(indices.size());
    sim::parallelFor(indices.size(), kTilesAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            tiles[i] = resolveTile(stack, start, indices[i]);
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

std::vector<int> allTilesOf(const MapStack& stack)
{
    const int across = stack.size / sim::TiledRaster::kTileSize;
    std::vector<int> all(static_cast<std::size_t>(across) * static_cast<std::size_t>(across));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// Those that a layer has covered: elsewhere a map is what it starts from.
std::vector<int> coveredTilesOf(const MapStack& stack)
{
    const auto coverage = static_cast<std::size_t>(mapSpec(stack.kind).valueChannels);
    std::vector<bool> isCovered(allTilesOf(stack).size());
    for (const Layer& layer : stack.layers) {
        if (!layer.visible)
            continue;
        const sim::RasterTile* blank = nullptr; // The one that many indices of an empty layer have.
        for (std::size_t index = 0; index < isCovered.size(); ++index) {
            const sim::RasterTile* tile = layer.raster.tile(static_cast<int>(index)).get();
            if (tile == blank)
                continue;
            if (tile->isUniform() && tile->uniform[coverage] == 0)
                blank = tile;
            else
                isCovered[index] = true;
        }
    }
    std::vector<int> covered = allTilesOf(stack);
    std::erase_if(covered, [&](int index) { return !isCovered[static_cast<std::size_t>(index)]; });
    return covered;
}

/// How many tiles of layers there are at these indices that are not one value.
std::size_t blendedAt(const MapStack& stack, std::span<const int> indices)
{
    std::size_t count = 0;
    for (const Layer& layer : stack.layers)
        if (layer.visible)
            for (const int index : indices)
                count += layer.raster.tile(index)->isUniform() ? 0 : 1;
    return count;
}

} // namespace

sim::MapRaster startOf(const MapSpec& spec, const Head* head, const std::function<sim::MapRaster(MapKind)>& resolved)
{
    if (spec.follows)
        return resolved(*spec.follows);
    return spec.ofHead != nullptr && head != nullptr ? spec.ofHead(*head) : nullptr;
}

sim::Texel resolveTexel(const MapStack& stack, int x, int y, const sim::MapRaster& start)
{
    const MapSpec& spec = mapSpec(stack.kind);
    sim::Texel result = start == nullptr ? spec.defaultValue : startTexel(spec, *start, stack.size, x, y);
    for (const Layer& layer : stack.layers)
        if (layer.visible)
            stepTexel(spec, {nullptr, layer.blend, unit16(layer.opacity)}, result, layer.raster.texel(x, y));
    return result;
}

sim::TiledRaster resolveStack(const MapStack& stack, const sim::MapRaster& start)
{
    const MapSpec& spec = mapSpec(stack.kind);
    sim::TiledRaster result(stack.size, spec.valueChannels, spec.defaultValue);
    const std::vector<int> indices = start != nullptr ? allTilesOf(stack) : coveredTilesOf(stack);
    std::vector<sim::RasterTilePtr> tiles = tilesResolved(stack, start.get(), indices);
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (start != nullptr || !sameTexels(*tiles[i], *result.tile(indices[i])))
            result.setTile(indices[i], std::move(tiles[i]));
    return result;
}

std::size_t tilesToBlend(const MapStack& stack)
{
    return blendedAt(stack, allTilesOf(stack));
}

ResolvedMap::ResolvedMap(const MapStack& stack, sim::MapRaster start)
    : m_seen(stack), m_start(std::move(start)),
      m_result(std::make_shared<const sim::TiledRaster>(resolveStack(stack, m_start)))
{
    shareStart();
}

std::vector<int> ResolvedMap::staleTiles(const MapStack& stack, const sim::MapRaster& start) const
{
    const bool structureKept = sameButTiles(m_seen, stack);
    const auto differs = [&](int index) {
        for (std::size_t layer = 0; layer < stack.layers.size(); ++layer)
            if (stack.layers[layer].raster.tile(index) != m_seen.layers[layer].raster.tile(index))
                return true;
        return startDiffers(stack, m_start, start, index);
    };
    std::vector<int> tiles = allTilesOf(stack);
    if (structureKept)
        std::erase_if(tiles, [&](int index) { return !differs(index); });
    return tiles;
}

std::size_t ResolvedMap::tilesToBlend(const MapStack& stack, const sim::MapRaster& start) const
{
    return blendedAt(stack, staleTiles(stack, start));
}

bool ResolvedMap::update(const MapStack& stack, const sim::MapRaster& start)
{
    if (stack.size != m_seen.size) {
        *this = ResolvedMap(stack, start);
        return true;
    }
    const std::vector<int> tiles = staleTiles(stack, start);
    m_start = start;
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
        return update(stack, m_start);
    for (const int index : tiles)
        seen->raster.setTile(index, now->raster.tile(index));
    return resolveTiles(tiles);
}

bool ResolvedMap::resolveTiles(std::span<const int> tiles)
{
    std::shared_ptr<sim::TiledRaster> next;
    std::vector<sim::RasterTilePtr> made = tilesResolved(m_seen, m_start.get(), tiles);
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
    shareStart();
    return true;
}

void ResolvedMap::shareStart()
{
    if (m_start == nullptr || m_start->size() != m_result->size())
        return;
    for (int index = 0; index < m_result->tileCount(); ++index)
        if (m_result->tile(index) != m_start->tile(index))
            return;
    m_result = m_start;
}

} // namespace hairpaint::model
