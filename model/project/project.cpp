// Look-ups in a project, and the making of groups and layers.
#include "model/project/project.h"

#include "model/project/group_schema.h"
#include "model/values/names.h"

#include <algorithm>

namespace hairpaint::model {

MapStack& SharedStack::write()
{
    if (m_stack.use_count() > 1)
        m_stack = std::make_shared<MapStack>(*m_stack);
    return *m_stack;
}

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
    // Looked for first, so that a layer that is not there leaves the map shared.
    const Layer* found = std::as_const(*this).layer(groupId, kind, layerId);
    if (found == nullptr)
        return nullptr;
    HairGroup& owner = *group(groupId);
    const auto index = found - std::as_const(owner).map(kind).layers.data();
    return &owner.map(kind).layers[static_cast<std::size_t>(index)];
}

const Worn* Project::wornThing(Id id) const
{
    const auto found = std::ranges::find(worn, id, &Worn::id);
    return found == worn.end() ? nullptr : &*found;
}

Worn* Project::wornThing(Id id)
{
    const auto found = std::ranges::find(worn, id, &Worn::id);
    return found == worn.end() ? nullptr : &*found;
}

void Project::setShapesOfHead(std::span<const sim::Ellipsoid> shapes)
{
    if (std::ranges::equal(shapesOfHead(worn), shapes))
        return;
    std::erase_if(worn, [](const Worn& one) { return wornSpec(one.kind).ofHead; });
    for (const sim::Ellipsoid& shape : shapes)
        insertWorn(worn, {.id = takeId(), .kind = WornKind::Ellipsoid, .shape = shape});
}

sim::Texel emptyTexel(const MapSpec& spec)
{
    sim::Texel empty = spec.defaultValue;
    empty[static_cast<std::size_t>(spec.valueChannels)] = 0;
    return empty;
}

sim::TiledRaster emptyRaster(const MapSpec& spec, int size)
{
    return {size, spec.layerChannels(), emptyTexel(spec)};
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
    group.settings = newGroupSettings(project.scalpFraction());
    for (const MapSpec& spec : mapSpecs()) {
        MapStack stack{.kind = spec.kind, .size = mapSize, .layers = {}};
        stack.layers.push_back(makeLayer(project, spec, mapSize, layerName(1)));
        group.maps.emplace_back(std::move(stack));
    }
    return group;
}

} // namespace hairpaint::model
