// Which maps are resolved again, and in which order.
#include "model/maps/resolved_maps.h"

namespace hairpaint::model {

sim::MapRaster ResolvedMaps::map(Id group, MapKind map) const
{
    const auto found = m_maps.find({group, map});
    return found == m_maps.end() ? nullptr : found->second.result();
}

ResolvedMaps::Addresses ResolvedMaps::differingFrom(const ResolvedMaps& before) const
{
    Addresses differing;
    for (const auto& [address, resolved] : m_maps)
        if (before.map(address.first, address.second) != resolved.result())
            differing.push_back(address);
    return differing;
}

std::size_t ResolvedMaps::tilesToBlend(const Project& project) const
{
    std::size_t tiles = 0;
    for (const HairGroup& group : project.groups)
        for (const MapStack& stack : group.maps)
            tiles += tilesToBlendOf(project, group.id, stack);
    return tiles;
}

std::size_t ResolvedMaps::tilesToBlend(const Project& project, const HairGroup& group, MapKind map) const
{
    std::size_t tiles = 0;
    for (const MapStack& stack : group.maps)
        if (stack.kind == map || mapSpec(stack.kind).follows == map)
            tiles += tilesToBlendOf(project, group.id, stack);
    return tiles;
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

sim::MapRaster ResolvedMaps::startFor(const Project& project, Id group, MapKind map) const
{
    return startOf(mapSpec(map), project.head.get(), [&](MapKind kind) { return this->map(group, kind); });
}

std::size_t ResolvedMaps::tilesToBlendOf(const Project& project, Id group, const MapStack& stack) const
{
    const auto found = m_maps.find({group, stack.kind});
    return found == m_maps.end() ? model::tilesToBlend(stack)
                                 : found->second.tilesToBlend(stack, startFor(project, group, stack.kind));
}

/// The maps that it follows must be up to date.
void ResolvedMaps::updateOne(const Project& project, Id group, const MapStack& stack)
{
    const sim::MapRaster start = startFor(project, group, stack.kind);
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
