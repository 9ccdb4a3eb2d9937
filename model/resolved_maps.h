// Every map of a project with its layers applied.
#pragma once

#include "model/compositor.h"
#include "model/project.h"

#include <map>
#include <span>
#include <utility>

namespace hairpaint::model {

/// Kept up to date step by step: what is told to differ is resolved again, and of that only tiles that do. Making one
/// is work for a thread of its own where maps are large; it throws std::bad_alloc. Not safe for two threads at once.
class ResolvedMaps
{
public:
    ResolvedMaps() = default;
    explicit ResolvedMaps(const Project& project) { update(project); }

    /// Null where the project has no such group.
    [[nodiscard]] sim::MapRaster map(Id group, MapKind map) const;

    void update(const Project& project);
    /// One map, and those that follow it.
    void update(const Project& project, const HairGroup& group, MapKind map);
    /// The same, where only these tiles of one layer can differ.
    void updateTiles(const Project& project, const LayerAddress& address, std::span<const int> tiles);

private:
    void updateOne(const Project& project, Id group, const MapStack& stack);
    void updateFollowers(const Project& project, const HairGroup& group, MapKind map);

    std::map<std::pair<Id, MapKind>, ResolvedMap> m_maps;
};

} // namespace hairpaint::model
