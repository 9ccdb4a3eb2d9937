// The preview of a running edit session, as the document holds it.
#pragma once

#include "model/document/command_ptr.h"
#include "model/document/edit_command.h"
#include "model/patches/project_patches.h"

#include <map>
#include <optional>

namespace hairpaint::model {

/// Committed content with its parts edited and its tiles put in.
struct RunningEdit
{
    std::uint64_t session = 0;
    EditOwner owner;
    Project shown;
    std::vector<ShownPart> parts;
    std::map<LayerAddress, std::map<int, sim::RasterTilePtr>> tiles;
    std::optional<ProjectPatches> patches = {}; ///< Of what is shown, once it touched an accessory map.
    std::vector<Worn> plainWorn = {};           ///< Then: what is worn before it follows its patches,
    Id plainNextId = 1;                         ///< and the next id;
    std::vector<Worn> toldWorn = {};            ///< what was last shown as worn.

    [[nodiscard]] bool showsSomething() const { return !parts.empty() || !tiles.empty(); }
    /// Replaces the previewed part for the same part of the content by `part`.
    void showPart(const Project& committed, ShownPart part);
    /// The change to emit; none if the layer does not exist.
    std::optional<Change> showTiles(const LayerAddress& address, const LayerTiles& tiles);
    /// What is worn follows the patches that are shown; whether it differs from what was shown last. `before`: of the
    /// committed content.
    [[nodiscard]] bool followPatches(const ProjectPatches& before);
    /// Everything that was told of it.
    [[nodiscard]] std::vector<Change> changes() const;
    /// A command that makes the previewed bytes the committed content. Null if nothing differs.
    [[nodiscard]] CommandPtr command(Document& document) const;
};

/// Whether the change `told` covers `change`.
[[nodiscard]] bool covers(const Change& told, const Change& change);

} // namespace hairpaint::model
