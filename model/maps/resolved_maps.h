// Every map of a project with its layers applied.
#pragma once

#include "model/maps/compositor.h"
#include "model/project/project.h"

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace hairpaint::model {

/// Updated step by step: only tiles of the named maps that differ are resolved again. Making one is work for a thread
/// of its own where maps are large; it throws std::bad_alloc. Not safe for two threads at once.
class ResolvedMaps
{
public:
    using Address = std::pair<Id, MapKind>; ///< A group's id and a map of that group.
    using Addresses = std::vector<Address>;

    ResolvedMaps() = default;
    explicit ResolvedMaps(const Project& project) { update(project); }

    /// Null where the project has no such group.
    [[nodiscard]] sim::MapRaster map(Id group, MapKind map) const;
    /// The maps that differ from those of `before`.
    [[nodiscard]] Addresses differingFrom(const ResolvedMaps& before) const;
    /// The work of update(): the number of layers' tiles that are not of one value, where they are resolved again.
    [[nodiscard]] std::size_t tilesToBlend(const Project& project) const;
    [[nodiscard]] std::size_t tilesToBlend(const Project& project, const HairGroup& group, MapKind map) const;

    void update(const Project& project);
    /// Updates one map, and those that follow it.
    void update(const Project& project, const HairGroup& group, MapKind map);
    /// As update() of one map, where only these tiles of one layer can differ.
    void updateTiles(const Project& project, const LayerAddress& address, std::span<const int> tiles);

private:
    [[nodiscard]] sim::MapRaster startFor(const Project& project, Id group, MapKind map) const;
    [[nodiscard]] std::size_t tilesToBlendOf(const Project& project, Id group, const MapStack& stack) const;
    void updateOne(const Project& project, Id group, const MapStack& stack);
    void updateFollowers(const Project& project, const HairGroup& group, MapKind map);

    std::map<Address, ResolvedMap> m_maps;
};

} // namespace hairpaint::model
