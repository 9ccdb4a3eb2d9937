// Mixing, map by map and number by number.
#include "model/styles/style_mix.h"

#include "model/maps/compositor.h"
#include "model/maps/texel_ops.h"
#include "model/project/group_schema.h"
#include "model/project/map_scale.h"
#include "model/styles/preset.h"
#include "sim/base/parallel.h"
#include "sim/groom/map_slot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hairpaint::model {

namespace {

constexpr double kHalfMixed = 0.5;
constexpr double kFull = 65535.0;

sim::GroupSettings mixedSettings(const sim::GroupSettings& from, const sim::GroupSettings& to, double fraction)
{
    sim::GroupSettings mixed = fraction < kHalfMixed ? from : to;
    for (const GroupSetting& row : groupSchema())
        if (!row.isSwitch() && row.choices.empty())
            row.write(mixed, std::lerp(row.read(from), row.read(to), fraction));
    return mixed;
}

using ResolvedSlots = std::array<sim::MapRaster, sim::kMapSlotCount>;

/// Maps follow others that stand before them.
void resolve(const MapStack& stack, const Head* head, ResolvedSlots& all)
{
    const MapSpec& spec = mapSpec(stack.kind);
    all[sim::indexOf(stack.kind)] = std::make_shared<const sim::TiledRaster>(
        resolveStack(stack, startOf(spec, head, [&all](MapKind kind) { return all[sim::indexOf(kind)]; })));
}

/// Mixes texels of one map.
class TexelMix
{
public:
    TexelMix(const MapSpec& spec, const sim::GroupSettings& from, const sim::GroupSettings& to,
             const sim::GroupSettings& mixed, double fraction)
        : m_spec(spec), m_ops(texelOps(spec)), m_mixed(mixed), m_fraction(fraction),
          m_fraction16(static_cast<std::uint16_t>(std::lround(fraction * kFull)))
    {
        if (spec.scale == nullptr || !m_ops.continuous)
            return;
        m_from.resize(65536);
        m_to.resize(65536);
        for (std::size_t value = 0; value < m_from.size(); ++value) {
            m_from[value] = spec.scale->amount(from, static_cast<double>(value) / kFull);
            m_to[value] = spec.scale->amount(to, static_cast<double>(value) / kFull);
        }
    }
    void operator()(const sim::Texel& from, const sim::Texel& to, std::uint16_t* values) const
    {
        if (m_from.empty()) {
            m_ops.mix(from, to, std::span(&m_fraction16, 1), values);
        } else {
            const double amount = std::lerp(m_from[from[0]], m_to[to[0]], m_fraction);
            *values = static_cast<std::uint16_t>(
                std::lround(std::clamp(m_spec.scale->fraction(m_mixed, amount), 0.0, 1.0) * kFull));
        }
    }

private:
    const MapSpec& m_spec;
    const TexelOps& m_ops;
    const sim::GroupSettings& m_mixed;
    double m_fraction;
    std::uint16_t m_fraction16;
    std::vector<double> m_from, m_to; ///< What each value of a scalar means in either group.
};

sim::Texel texelAt(const sim::TiledRaster& raster, int x, int y, int size)
{
    if (raster.size() == size)
        return raster.texel(x, y);
    const glm::vec4 value = raster.sampleBilinear({(static_cast<float>(x) + 0.5F) / static_cast<float>(size),
                                                   1.0F - (static_cast<float>(y) + 0.5F) / static_cast<float>(size)});
    sim::Texel texel{};
    for (int i = 0; i < 4; ++i)
        texel[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(std::lround(value[i] * 65535.0F));
    return texel;
}

/// A layer's raster that covers all.
sim::TiledRaster mixedRaster(const sim::TiledRaster& from, const sim::TiledRaster& to, const MapSpec& spec,
                             const TexelMix& mix)
{
    const auto channels = static_cast<std::size_t>(spec.layerChannels());
    sim::TiledRaster layer(to.size(), spec.layerChannels());
    std::vector<sim::RasterTilePtr> made(static_cast<std::size_t>(layer.tileCount()));
    sim::parallelFor(made.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const sim::TexelRect rect = layer.tileRect(static_cast<int>(i));
            sim::RasterTile tile{.uniform = {}, .pixels = std::vector<std::uint16_t>(sim::kTileTexels * channels)};
            std::uint16_t* texel = tile.pixels.data();
            for (int y = rect.y0; y < rect.y1; ++y)
                for (int x = rect.x0; x < rect.x1; ++x, texel += channels) {
                    mix(texelAt(from, x, y, to.size()), to.texel(x, y), texel);
                    texel[channels - 1] = 65535;
                }
            made[i] = std::make_shared<const sim::RasterTile>(sim::folded(std::move(tile)));
        }
    });
    for (std::size_t i = 0; i < made.size(); ++i)
        layer.setTile(static_cast<int>(i), std::move(made[i]));
    return layer;
}

} // namespace

HairGroup mixedGroup(const HairGroup& from, HairGroup to, double fraction, const Head* head)
{
    const sim::GroupSettings settings = mixedSettings(from.settings, to.settings, fraction);
    ResolvedSlots ofFrom;
    ResolvedSlots ofTo;
    for (const MapSpec& spec : mapSpecs()) {
        const auto index = static_cast<std::size_t>(spec.kind);
        const SharedStack& before = from.maps[index];
        SharedStack& stack = to.maps[index];
        resolve(before, head, ofFrom);
        resolve(stack, head, ofTo);
        if (stack.sharesWith(before))
            continue; // A part of a style leaves it alone.
        if (!texelOps(spec).continuous) {
            if (fraction < kHalfMixed)
                stack = before;
            continue;
        }
        if (!isPainted(before) && !isPainted(stack))
            continue;
        const TexelMix mix(spec, from.settings, to.settings, settings, fraction);
        const std::size_t slot = sim::indexOf(spec.kind);
        sim::TiledRaster raster = mixedRaster(*ofFrom[slot], *ofTo[slot], spec, mix);
        Layer layer{.id = stack->layers.front().id, .name = stack->layers.front().name, .raster = std::move(raster)};
        stack = MapStack{.kind = spec.kind, .size = stack->size, .layers = {std::move(layer)}};
    }
    to.settings = settings;
    if (fraction < kHalfMixed) {
        to.visible = from.visible;
        to.name = from.name;
    }
    return to;
}

} // namespace hairpaint::model
