// The patches of a project's accessory maps, and the worn things that they are.
#pragma once

#include "model/maps/compositor.h"
#include "model/project/project.h"
#include "sim/groom/patch_labels.h"

#include <map>
#include <memory>
#include <vector>

namespace hairpaint::model {

/// What follows from a project's maps and its list of worn things: which patch is which thing. One thread at a time;
/// copies share what they found.
class ProjectPatches
{
public:
    /// Follows the project's maps and worn things. The work is in proportion to the tiles that differ.
    void update(const Project& project);

    /// One channel: the number of the patch where it gathers hair, else 0. Null where none does, or there is no such
    /// group. Tiles in which nothing differs keep their pointers.
    [[nodiscard]] sim::MapRaster gathered(Id group) const;

    /// Makes the project's list of worn things follow the maps that this holds; returns whether it changed. A thing
    /// keeps the patch that its point is in, the oldest thing where patches met; else it gets the patch that covers
    /// most of what it had in `before`. New patches get new things, and things without a patch are removed. A thing's
    /// position follows its patch until it is moved by hand.
    bool follow(Project& project, const ProjectPatches* before);

    struct Group
    {
        ResolvedMap map;
        sim::PatchLabels labels = {};
        std::vector<Id> things = {};             ///< By patch: the id of its thing; 0: none.
        std::vector<std::uint16_t> numbers = {}; ///< By patch: its number where it gathers hair; else 0.
        sim::MapRaster gathered = {};
        /// By tile of `gathered`: the parts and numbers that it was made from.
        std::vector<std::pair<std::shared_ptr<const sim::PatchTile>, std::vector<std::uint16_t>>> made = {};
    };
    [[nodiscard]] const Group* group(Id id) const;

private:
    void updateLabels(const Project& project);
    void findThings(const Project& project);

    std::map<std::pair<const sim::Skin*, int>, std::shared_ptr<const sim::SkinIslands>> m_islands;
    std::map<Id, Group> m_groups;
};

/// The texels of the thing's patch, in each layer of its group's accessory map that shows there, without paint; empty
/// where it has none.
struct LayerPatchErasure
{
    LayerAddress address;
    std::vector<std::pair<int, sim::RasterTilePtr>> tiles;
};
[[nodiscard]] std::vector<LayerPatchErasure> patchErased(const Project& project, const ProjectPatches& patches,
                                                         const Worn& worn);

} // namespace hairpaint::model
