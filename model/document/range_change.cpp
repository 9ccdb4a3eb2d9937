// Texels from one range to another, layer by layer from the bottom.
#include "model/document/range_change.h"

#include "model/maps/compositor.h"
#include "model/project/group_schema.h"
#include "sim/base/parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace hairpaint::model {

namespace {

using sim::GroupSettings;
using sim::RasterTile;
using sim::RasterTilePtr;

constexpr int kMostValue = 65535;
constexpr std::uint8_t kBeyond = 1;
constexpr std::uint8_t kBelow = 2;

double rangeAmount(const MapSpec& spec, const GroupSettings& settings, double fraction)
{
    return spec.scale->amount(settings, fraction);
}

/// Whether the texels of a map mean other amounts. Not where either range is a single amount.
bool rescalesMap(const MapSpec& spec, const GroupSettings& before, const GroupSettings& after)
{
    if (spec.scale == nullptr)
        return false;
    const double range = rangeAmount(spec, before, 1.0) - rangeAmount(spec, before, 0.0);
    if (range <= 0.0 || rangeAmount(spec, after, 1.0) <= rangeAmount(spec, after, 0.0))
        return false;
    return std::ranges::any_of(std::array{0.0, 0.5, 1.0}, [&](double fraction) {
        return std::abs(rangeAmount(spec, after, fraction) - rangeAmount(spec, before, fraction)) > range * 1e-9;
    });
}

/// What each of the 65,536 values becomes.
struct RangeTable
{
    std::vector<std::uint16_t> values;
    std::vector<std::uint8_t> outside; ///< kBeyond or kBelow the new range, or 0.

    RangeTable(const MapSpec& spec, const GroupSettings& before, const GroupSettings& after)
        : values(kMostValue + 1), outside(kMostValue + 1)
    {
        const double least = rangeAmount(spec, after, 0.0);
        const double greatest = rangeAmount(spec, after, 1.0);
        const double step = (greatest - least) / kMostValue; // What rounding may take.
        for (int value = 0; value <= kMostValue; ++value) {
            const double amount = rangeAmount(spec, before, static_cast<double>(value) / kMostValue);
            const auto index = static_cast<std::size_t>(value);
            values[index] = static_cast<std::uint16_t>(std::lround(spec.scale->fraction(after, amount) * kMostValue));
            outside[index] = amount > greatest + step ? kBeyond : amount < least - step && value > 0 ? kBelow : 0;
        }
    }
};

using BlendFormula = decltype(BlendRule::formula);

/// Modes in which rescaled layers give the rescaled map by themselves: they take either value as it is.
bool isPlainMode(BlendMode mode)
{
    return mode == BlendMode::Normal || mode == BlendMode::Darken || mode == BlendMode::Lighten;
}

/// The layer's value that makes `wanted` out of `below`; `value` itself where none comes nearer.
std::uint16_t solvedValue(BlendMode mode, std::uint16_t below, std::uint16_t wanted, std::uint16_t value)
{
    const BlendFormula formula = blendRule(mode).formula;
    const auto miss = [&](int candidate) {
        return std::abs(static_cast<int>(formula(below, static_cast<std::uint16_t>(candidate))) - wanted);
    };
    if (miss(value) == 0)
        return value;
    int found = 0;
    if (mode == BlendMode::Difference) { // The one that turns: both sides of `below`.
        const int above = std::min(below + wanted, kMostValue);
        const int under = std::max(below - wanted, 0);
        const bool wasAbove = value >= below;
        found = miss(above) < miss(under) || (miss(above) == miss(under) && wasAbove) ? above : under;
    } else {
        const bool rises = formula(below, kMostValue) >= formula(below, 0);
        int low = 0;
        int high = kMostValue;
        while (low < high) {
            const int middle = (low + high) / 2;
            const std::uint16_t made = formula(below, static_cast<std::uint16_t>(middle));
            if (rises ? made >= wanted : made <= wanted)
                high = middle;
            else
                low = middle + 1;
        }
        found = low > 0 && miss(low - 1) < miss(low) ? low - 1 : low;
    }
    return miss(found) < miss(value) ? static_cast<std::uint16_t>(found) : value;
}

/// One tile of all layers of a scalar map.
class TileRescale
{
public:
    TileRescale(const MapStack& stack, const MapSpec& spec, const RangeTable& table, std::uint16_t startAfter)
        : m_stack(stack), m_table(table), m_start(spec.defaultValue[0]), m_startAfter(startAfter),
          m_composes(!std::ranges::all_of(stack.layers, isPlainMode, &Layer::blend))
    {}

    /// Those that stay keep their pointer. `outside`: takes kBeyond and kBelow up.
    std::vector<RasterTilePtr> run(int index, int& outside) const
    {
        std::vector<RasterTilePtr> tiles;
        std::vector<std::uint16_t> below(m_composes ? sim::kTileTexels : 0, m_start);
        std::vector<std::uint16_t> after(below.size(), m_startAfter);
        for (const Layer& layer : m_stack.layers) {
            const RasterTilePtr& tile = layer.raster.tile(index);
            const bool isUniform = tile->isUniform();
            if (isUniform && tile->uniform[1] == 0)
                tiles.push_back(tile);
            else if (isUniform && !m_composes)
                tiles.push_back(std::make_shared<const RasterTile>(uniformOf(*tile, outside)));
            else
                tiles.push_back(rescaled(layer, *tile, below, after, outside));
        }
        return tiles;
    }

private:
    void note(std::uint16_t value, int& outside) const { outside |= m_table.outside[value]; }

    RasterTile uniformOf(const RasterTile& tile, int& outside) const
    {
        RasterTile result = tile;
        note(tile.uniform[0], outside);
        result.uniform[0] = m_table.values[tile.uniform[0]];
        return result;
    }

    RasterTilePtr rescaled(const Layer& layer, const RasterTile& tile, std::vector<std::uint16_t>& below,
                           std::vector<std::uint16_t>& after, int& outside) const
    {
        constexpr int kChannels = 2;
        RasterTile result{.uniform = {}, .pixels = sim::expanded(tile, kChannels)};
        const std::uint16_t opacity = unit16(layer.opacity);
        const BlendFormula formula = blendRule(layer.blend).formula;
        for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel) {
            std::uint16_t& value = result.pixels[texel * kChannels];
            const std::uint16_t coverage = result.pixels[texel * kChannels + 1];
            if (coverage == 0)
                continue;
            const std::uint16_t before = value;
            if (!m_composes) {
                note(before, outside);
                value = m_table.values[before];
                continue;
            }
            const std::uint16_t shown = formula(below[texel], before);
            note(isPlainMode(layer.blend) ? before : shown, outside);
            value = isPlainMode(layer.blend) ? m_table.values[before]
                                             : solvedValue(layer.blend, after[texel], m_table.values[shown], before);
            if (!layer.visible)
                continue;
            const std::uint16_t fraction = mul16(coverage, opacity);
            below[texel] = lerp16(below[texel], shown, fraction);
            after[texel] = lerp16(after[texel], formula(after[texel], value), fraction);
        }
        return std::make_shared<const RasterTile>(sim::folded(std::move(result)));
    }

    const MapStack& m_stack;
    const RangeTable& m_table;
    std::uint16_t m_start, m_startAfter; ///< What the layers lie on, by the old range and by the new one.
    bool m_composes;                     ///< Some layer's mode asks what lies below.
};

/// `outside` as in TileRescale::run().
MapStack rescaledStack(const MapStack& stack, const MapSpec& spec, const RangeTable& table, std::uint16_t startAfter,
                       int& outside)
{
    constexpr std::size_t kTilesAtOnce = 8;
    MapStack result = stack;
    if (stack.layers.empty())
        return result;
    const auto count = static_cast<std::size_t>(stack.layers.front().raster.tileCount());
    std::vector<std::vector<RasterTilePtr>> tiles(count);
    std::atomic<int> all = 0;
    const TileRescale rescale(stack, spec, table, startAfter);
    sim::parallelFor(count, kTilesAtOnce, [&](std::size_t begin, std::size_t end) {
        int here = 0;
        for (std::size_t index = begin; index < end; ++index)
            tiles[index] = rescale.run(static_cast<int>(index), here);
        all |= here;
    });
    for (std::size_t index = 0; index < count; ++index)
        for (std::size_t layer = 0; layer < result.layers.size(); ++layer)
            if (tiles[index][layer] != stack.layers[layer].raster.tile(static_cast<int>(index)))
                result.layers[layer].raster.setTile(static_cast<int>(index), std::move(tiles[index][layer]));
    outside = all;
    return result;
}

/// Whether every texel of a tile has this coverage.
bool hasCoverage(const RasterTile& tile, std::uint16_t coverage)
{
    if (tile.isUniform())
        return tile.uniform[1] == coverage;
    for (std::size_t i = 1; i < tile.pixels.size(); i += 2)
        if (tile.pixels[i] != coverage)
            return false;
    return true;
}

bool hasCoverage(const Layer& layer, std::uint16_t coverage)
{
    for (int index = 0; index < layer.raster.tileCount(); ++index)
        if (!hasCoverage(*layer.raster.tile(index), coverage))
            return false;
    return true;
}

bool hidesBelow(const Layer& layer)
{
    return layer.visible && layer.blend == BlendMode::Normal && unit16(layer.opacity) == kMostValue;
}

/// Whether hair grows somewhere in the group that may have the map's amount of unpainted skin.
bool showsStart(const HairGroup& group, const MapStack& stack)
{
    const bool grows = !std::ranges::all_of(group.map(MapKind::Density).layers,
                                            [](const Layer& layer) { return hasCoverage(layer, 0); });
    return grows && !std::ranges::any_of(stack.layers, [](const Layer& layer) {
               return hidesBelow(layer) && hasCoverage(layer, kMostValue);
           });
}

/// One value all over, under what is painted: in the lowest layer if that is still empty, else in a layer of its own.
void layUnder(MapStack& stack, const MapSpec& spec, std::uint16_t value)
{
    const sim::TiledRaster base(stack.size, spec.layerChannels(), {value, kMostValue});
    if (!stack.layers.empty() && hidesBelow(stack.layers.front()) && hasCoverage(stack.layers.front(), 0))
        stack.layers.front().raster = base;
    else
        stack.layers.insert(stack.layers.begin(), {.name = QStringLiteral("Base"), .raster = base});
}

} // namespace

bool setsRange(const GroupSetting& setting)
{
    GroupSettings least;
    GroupSettings greatest;
    const double standard = setting.read(least);
    constexpr double kNear = 0.05; // The shortest length stays below the greatest one.
    setting.write(least, std::lerp(standard, setting.least, kNear));
    setting.write(greatest, std::lerp(standard, setting.greatest, kNear));
    return std::ranges::any_of(mapSpecs(), [&](const MapSpec& spec) {
        return rescalesMap(spec, GroupSettings{}, least) || rescalesMap(spec, GroupSettings{}, greatest);
    });
}

void RangeChange::applyTo(Project& project) const
{
    HairGroup* one = project.group(group);
    if (one == nullptr)
        return;
    one->settings = settings;
    for (const MapSpec& spec : mapSpecs()) {
        if (spec.scale == nullptr)
            continue;
        SharedStack& map = one->maps[static_cast<std::size_t>(spec.kind)];
        map = maps[static_cast<std::size_t>(spec.kind)];
        if (!map->layers.empty() && map->layers.front().id == 0)
            map.write().layers.front().id = project.takeId();
    }
}

RangeChange withRange(const HairGroup& group, const GroupSettings& settings)
{
    RangeChange change{.group = group.id, .settings = settings, .maps = group.maps, .clamped = {}};
    for (const MapSpec& spec : mapSpecs()) {
        if (!rescalesMap(spec, group.settings, settings))
            continue;
        const RangeTable table(spec, group.settings, settings);
        SharedStack& map = change.maps[static_cast<std::size_t>(spec.kind)];
        const std::uint16_t start = spec.defaultValue[0];
        const bool keepsStart = table.values[start] != start && showsStart(group, *map);
        int outside = 0;
        MapStack stack = rescaledStack(*map, spec, table, keepsStart ? table.values[start] : start, outside);
        if (keepsStart) {
            layUnder(stack, spec, table.values[start]);
            outside |= table.outside[start];
        }
        map = std::move(stack);
        if (outside != 0)
            change.clamped.push_back(
                {.map = spec.kind, .beyond = (outside & kBeyond) != 0, .below = (outside & kBelow) != 0});
    }
    return change;
}

void rescaleTexels(const MapSpec& spec, const GroupSettings& before, const GroupSettings& after,
                   std::span<sim::Texel> texels)
{
    if (!rescalesMap(spec, before, after))
        return;
    const RangeTable table(spec, before, after);
    for (sim::Texel& texel : texels)
        texel[0] = table.values[texel[0]];
}

std::size_t texelsToRescale(const HairGroup& group, const GroupSettings& settings)
{
    std::size_t texels = 0;
    for (const MapSpec& spec : mapSpecs())
        if (rescalesMap(spec, group.settings, settings))
            texels += tilesToBlend(group.map(spec.kind)) * sim::kTileTexels;
    return texels;
}

} // namespace hairpaint::model
