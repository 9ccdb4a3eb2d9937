// Look-ups in a project, and the making of groups and layers.
#include "model/project.h"

#include "model/names.h"

#include <algorithm>

namespace hairpaint::model {

const HairGroup* Project::group(Id id) const
{
    const auto found = std::ranges::find(groups, id, &HairGroup::id);
    return found == groups.end() ? nullptr : &*found;
}

HairGroup* Project::group(Id id)
{
    const auto found = std::ranges::find(groups, id, &HairGroup::id);
    return found == groups.end() ? nullptr : &*found;
}

const Layer* Project::layer(Id groupId, MapKind kind, Id layerId) const
{
    const HairGroup* owner = group(groupId);
    if (owner == nullptr)
        return nullptr;
    const std::vector<Layer>& layers = owner->map(kind).layers;
    const auto found = std::ranges::find(layers, layerId, &Layer::id);
    return found == layers.end() ? nullptr : &*found;
}

Layer* Project::layer(Id groupId, MapKind kind, Id layerId)
{
    return const_cast<Layer*>(std::as_const(*this).layer(groupId, kind, layerId));
}

sim::TiledRaster emptyRaster(const MapSpec& spec, int size)
{
    sim::Texel empty = spec.defaultValue;
    empty[static_cast<std::size_t>(spec.valueChannels)] = 0;
    return {size, spec.layerChannels(), empty};
}

Layer makeLayer(Project& project, const MapSpec& spec, int size, const QString& name)
{
    return Layer{.id = project.takeId(), .name = name, .raster = emptyRaster(spec, size)};
}

HairGroup makeGroup(Project& project, const QString& name, int mapSize)
{
    HairGroup group;
    group.id = project.takeId();
    group.name = name;
    for (const MapSpec& spec : mapSpecs()) {
        MapStack stack{.kind = spec.kind, .size = mapSize, .layers = {}};
        stack.layers.push_back(makeLayer(project, spec, mapSize, layerName(1)));
        group.maps.push_back(std::move(stack));
    }
    return group;
}

} // namespace hairpaint::model
