// Layers added, removed, moved and changed.
#include "model/document/layer_commands.h"

#include "model/document/command_texts.h"
#include "model/document/edit_command.h"
#include "model/maps/image_resample.h"
#include "model/values/names.h"

#include <algorithm>
#include <span>

namespace hairpaint::model {

namespace {

CommandPtr layersCommand(Document& document, Id groupId, MapKind map, const QString& text,
                         std::function<void(Project&, std::vector<Layer>&)> edit)
{
    const Change change{.aspect = Change::Aspect::LayerList, .group = groupId, .map = map};
    return editCommand(document, change, text, [groupId, map, edit = std::move(edit)](Project& project) {
        if (HairGroup* group = project.group(groupId))
            edit(project, group->map(map).layers);
    });
}

std::vector<Layer>::iterator findLayer(std::vector<Layer>& layers, Id id)
{
    return std::ranges::find(layers, id, &Layer::id);
}

void insertAt(std::vector<Layer>& layers, Layer layer, int position)
{
    layers.insert(layers.begin() + std::clamp(position, 0, static_cast<int>(layers.size())), std::move(layer));
}

QString nameOf(const Document& document, const LayerAddress& address)
{
    const Layer* layer = document.committed().layer(address.group, address.map, address.layer);
    return layer != nullptr ? shownName(layer->name) : QString();
}

/// None where `progress` stopped it.
std::optional<MapStack> resized(const MapStack& stack, int size, const Progress& progress)
{
    const MapSpec& spec = mapSpec(stack.kind);
    sim::Texel empty = spec.defaultValue;
    empty[static_cast<std::size_t>(spec.valueChannels)] = 0;
    MapStack result = stack;
    result.size = size;
    double done = 0.0;
    for (Layer& layer : result.layers) {
        if (progress && !progress(done++ / static_cast<double>(result.layers.size())))
            return std::nullopt;
        const sim::TiledRaster& from = layer.raster;
        if (const std::optional<sim::Texel> value = from.uniformValue()) {
            layer.raster = sim::TiledRaster(size, spec.layerChannels(), *value);
            continue;
        }
        const auto readRow = [&from](int y, std::span<sim::Texel> texels) {
            for (std::size_t x = 0; x < texels.size(); ++x)
                texels[x] = from.texel(static_cast<int>(x), y);
        };
        layer.raster = spec.bilinear()
                           ? resampleBilinear(from.size(), from.size(), readRow, size, spec.layerChannels(), empty)
                           : resampleNearest(from.size(), from.size(), readRow, size, spec.layerChannels());
    }
    return result;
}

} // namespace

CommandPtr addLayerCommand(Document& document, Id group, MapKind map, const QString& name)
{
    const QString text = Commands::tr("Add layer to %1").arg(mapSpec(map).titleText());
    return layersCommand(document, group, map, text, [=](Project& project, std::vector<Layer>& layers) {
        const int size = project.group(group)->map(map).size;
        layers.push_back(makeLayer(project, mapSpec(map), size, name));
    });
}

CommandPtr insertLayerCommand(Document& document, Id group, MapKind map, Layer layer, int position, const QString& text)
{
    document.endEdit();
    const HairGroup* found = document.committed().group(group);
    if (found == nullptr || found->map(map).size != layer.raster.size())
        return nullptr; // A map's layers are all of its size.
    return layersCommand(document, group, map, text,
                         [layer = std::move(layer), position](Project& project, std::vector<Layer>& layers) {
                             Layer copy = layer;
                             copy.id = project.takeId();
                             insertAt(layers, std::move(copy), position);
                         });
}

CommandPtr removeLayerCommand(Document& document, const LayerAddress& address)
{
    const QString text = Commands::tr("Remove layer \"%1\"").arg(nameOf(document, address));
    return layersCommand(document, address.group, address.map, text, [address](Project&, std::vector<Layer>& layers) {
        std::erase_if(layers, [address](const Layer& layer) { return layer.id == address.layer; });
    });
}

CommandPtr moveLayerCommand(Document& document, const LayerAddress& address, int newPosition)
{
    const QString text = Commands::tr("Move layer \"%1\"").arg(nameOf(document, address));
    return layersCommand(document, address.group, address.map, text,
                         [address, newPosition](Project&, std::vector<Layer>& layers) {
                             const auto found = findLayer(layers, address.layer);
                             if (found == layers.end())
                                 return;
                             Layer layer = std::move(*found);
                             layers.erase(found);
                             insertAt(layers, std::move(layer), newPosition);
                         });
}

CommandPtr resizeMapCommand(Document& document, Id groupId, MapKind map, int size, const RunLong& run)
{
    document.endEdit();
    const HairGroup* group = document.committed().group(groupId);
    if (group == nullptr || group->map(map).size == size)
        return nullptr;
    // Refused before the work is done where even unpainted layers would be too much.
    Project large = document.committed();
    MapStack& grown = large.group(groupId)->map(map);
    grown.size = size;
    if (!document.mayBecome(large))
        return nullptr;
    const QString text = Commands::tr("Resize %1 to %2 × %2").arg(mapSpec(map).titleText()).arg(size);
    const SharedStack before = group->maps[static_cast<std::size_t>(map)];
    std::optional<MapStack> after;
    if (!run(text, [&](const Progress& progress) { after = resized(*before, size, progress); }))
        return nullptr;
    document.endEdit();
    const HairGroup* still = document.committed().group(groupId); // Much may have happened meanwhile.
    if (!after || still == nullptr || !still->maps[static_cast<std::size_t>(map)].sharesWith(before))
        return nullptr;
    return editCommand(document, {.aspect = Change::Aspect::LayerList, .group = groupId, .map = map}, text,
                       [groupId, map, after = SharedStack(std::move(*after))](Project& project) {
                           if (HairGroup* one = project.group(groupId))
                               one->maps[static_cast<std::size_t>(map)] = after;
                       });
}

LayerProperties propertiesOf(const Layer& layer)
{
    return {layer.name, layer.visible, layer.opacity, layer.blend, layer.locked};
}

CommandPtr setLayerPropertiesCommand(Document& document, const LayerAddress& address, const LayerProperties& properties,
                                     const QString& text)
{
    document.endEdit();
    const Layer* layer = document.committed().layer(address.group, address.map, address.layer);
    if (layer == nullptr || propertiesOf(*layer) == properties)
        return nullptr;
    return layersCommand(document, address.group, address.map, text,
                         [address, properties](Project&, std::vector<Layer>& layers) {
                             const auto found = findLayer(layers, address.layer);
                             if (found == layers.end())
                                 return;
                             found->name = properties.name;
                             found->visible = properties.visible;
                             found->opacity = properties.opacity;
                             found->blend = properties.blend;
                             found->locked = properties.locked;
                         });
}

} // namespace hairpaint::model
