// The preview of a running edit session, as the document holds it.
#pragma once

#include "model/document/command_ptr.h"
#include "model/document/edit_command.h"
#include "model/patches/project_patches.h"

#include <map>
#include <optional>

namespace hairpaint::model {

/// The committed content, and the previewed parts and tiles that replace some of it.
struct RunningEdit
{
    std::uint64_t session = 0;
    EditOwner owner;
    Project shown;
    std::vector<ShownPart> parts;
    std::map<LayerAddress, std::map<int, sim::RasterTilePtr>> tiles;
    /// The patches of `shown`; none until the edit touches an accessory map.
    std::optional<ProjectPatches> patches = {};
    std::vector<Worn> plainWorn = {}; ///< What is worn in `shown` before it follows the patches.
    Id plainNextId = 1;               ///< Project::nextId before what is worn follows the patches.
    std::vector<Worn> toldWorn = {};  ///< What was worn when followPatches() last ran.

    [[nodiscard]] bool showsSomething() const { return !parts.empty() || !tiles.empty(); }
    /// Replaces the previewed part for the same part of the content by `part`.
    void showPart(const Project& committed, ShownPart part);
    /// The change to emit; none if the layer does not exist.
    std::optional<Change> showTiles(const LayerAddress& address, const LayerTiles& tiles);
    /// Makes what is worn follow the patches that are shown; returns whether it differs from what was shown last.
    /// `before`: the patches of the committed content.
    [[nodiscard]] bool followPatches(const ProjectPatches& before);
    /// All changes that this edit has announced.
    [[nodiscard]] std::vector<Change> changes() const;
    /// A command that makes the previewed bytes the committed content. Null if nothing differs.
    [[nodiscard]] CommandPtr command(Document& document) const;
};

/// Whether the change `told` covers `change`.
[[nodiscard]] bool covers(const Change& told, const Change& change);

} // namespace hairpaint::model
