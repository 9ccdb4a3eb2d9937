// Which maps are resolved again, and in which order.
#include "model/resolved_maps.h"

namespace hairpaint::model {

sim::MapRaster ResolvedMaps::map(Id group, MapKind map) const
{
    const auto found = m_maps.find({group, map});
    return found == m_maps.end() ? nullptr : found->second.result();
}

void ResolvedMaps::update(const Project& project)
{
    std::erase_if(m_maps, [&](const auto& entry) { return project.group(entry.first.first) == nullptr; });
    for (const HairGroup& group : project.groups)
        for (const MapStack& stack : group.maps)
            updateOne(project, group.id, stack);
}

void ResolvedMaps::update(const Project& project, const HairGroup& group, MapKind map)
{
    updateOne(project, group.id, group.map(map));
    updateFollowers(project, group, map);
}

void ResolvedMaps::updateTiles(const Project& project, const LayerAddress& address, std::span<const int> tiles)
{
    const HairGroup& group = *project.group(address.group);
    m_maps.find({address.group, address.map})->second.updateTiles(group.map(address.map), address.layer, tiles);
    updateFollowers(project, group, address.map);
}

/// The maps that it follows must be up to date.
void ResolvedMaps::updateOne(const Project& project, Id group, const MapStack& stack)
{
    const sim::MapRaster start =
        startOf(mapSpec(stack.kind), project.head.get(), [&](MapKind kind) { return map(group, kind); });
    const auto found = m_maps.find({group, stack.kind});
    if (found == m_maps.end())
        m_maps.emplace(std::pair(group, stack.kind), ResolvedMap(stack, start));
    else
        found->second.update(stack, start);
}

void ResolvedMaps::updateFollowers(const Project& project, const HairGroup& group, MapKind map)
{
    for (const MapStack& stack : group.maps)
        if (mapSpec(stack.kind).follows == map)
            updateOne(project, group.id, stack);
}

} // namespace hairpaint::model
