// Projects flattened to presets.
#include "model/styles/preset.h"

#include "model/maps/compositor.h"
#include "model/maps/tile_paint.h"
#include "model/project/worn_on_ties.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace hairpaint::model {

namespace {

/// The resolved map as one fully covering layer's raster.
sim::TiledRaster coveredRaster(const sim::TiledRaster& resolved)
{
    const int channels = resolved.channels();
    sim::TiledRaster layer(resolved.size(), channels + 1);
    for (int index = 0; index < resolved.tileCount(); ++index) {
        const sim::RasterTile& source = *resolved.tile(index);
        auto covered = std::make_shared<sim::RasterTile>();
        if (source.isUniform()) {
            covered->uniform = source.uniform;
            covered->uniform[static_cast<std::size_t>(channels)] = 65535;
        }
        covered->pixels.resize(source.pixels.size() / static_cast<std::size_t>(channels) *
                               static_cast<std::size_t>(channels + 1));
        auto from = source.pixels.begin();
        for (auto to = covered->pixels.begin(); to != covered->pixels.end(); from += channels, to += channels + 1) {
            std::copy_n(from, channels, to);
            *(to + channels) = 65535;
        }
        layer.setTile(index, std::move(covered));
    }
    return layer;
}

/// The layers that show as one, which shows what they do over any start.
sim::TiledRaster flattened(const MapStack& stack, const MapSpec& spec)
{
    const auto values = static_cast<std::size_t>(spec.valueChannels);
    sim::TiledRaster flat = emptyRaster(spec, stack.size);
    for (const Layer& layer : stack.layers)
        for (int index = 0; layer.visible && index < flat.tileCount(); ++index) {
            const sim::RasterTile& tile = *layer.raster.tile(index);
            if (tile.isUniform() && tile.uniform[values] == 0)
                continue;
            const std::vector<std::uint16_t> texels = sim::expanded(tile, spec.layerChannels());
            MaskTile mask{};
            std::vector<std::uint16_t> laid(sim::kTileTexels * values);
            for (std::size_t texel = 0; texel < sim::kTileTexels; ++texel) {
                const std::uint16_t* from = texels.data() + texel * (values + 1);
                std::copy_n(from, values, laid.data() + texel * values);
                mask[texel] = from[values];
            }
            flat.setTile(index, paintTile(spec, flat.tile(index), mask,
                                          {.values = laid.data(), .opacity = unit16(layer.opacity)}));
        }
    return flat;
}

} // namespace

bool isPainted(const MapStack& stack)
{
    const auto coverage = static_cast<std::size_t>(mapSpec(stack.kind).valueChannels);
    return std::ranges::any_of(stack.layers, [coverage](const Layer& layer) {
        for (int index = 0; layer.visible && index < layer.raster.tileCount(); ++index) {
            const sim::RasterTile& tile = *layer.raster.tile(index);
            if (!tile.isUniform() || tile.uniform[coverage] != 0)
                return true;
        }
        return false;
    });
}

Preset presetFrom(const Project& project, const QString& name)
{
    Preset preset;
    preset.name = name;
    preset.head = project.head;
    Id nextId = 1;
    for (const HairGroup& group : project.groups) {
        HairGroup flat;
        flat.id = nextId++;
        flat.name = group.name;
        flat.visible = group.visible;
        flat.settings = group.settings;
        std::array<sim::MapRaster, sim::kMapSlotCount> resolved;
        for (const MapStack& stack : group.maps) {
            const MapSpec& spec = mapSpec(stack.kind);
            sim::MapRaster& map = resolved[sim::indexOf(stack.kind)];
            map = std::make_shared<const sim::TiledRaster>(resolveStack(
                stack, startOf(spec, project.head.get(), [&](MapKind kind) { return resolved[sim::indexOf(kind)]; })));
            Layer layer{.id = nextId++,
                        .name = name,
                        .raster = spec.ofHead != nullptr ? flattened(stack, spec)
                                  : isPainted(stack)     ? coveredRaster(*map)
                                                         : emptyRaster(spec, stack.size)};
            flat.maps.emplace_back(MapStack{.kind = stack.kind, .size = stack.size, .layers = {std::move(layer)}});
        }
        preset.groups.push_back(std::move(flat));
    }
    std::map<Id, Id> ids;
    for (std::size_t i = 0; i < project.groups.size(); ++i)
        for (Worn one : project.worn) {
            if (one.group != project.groups[i].id)
                continue;
            one.group = preset.groups[i].id;
            const Id id = nextId++;
            ids.emplace(std::exchange(one.id, id), id);
            insertWorn(preset.worn, one);
        }
    renameTies(preset.worn, ids);
    return preset;
}

} // namespace hairpaint::model
