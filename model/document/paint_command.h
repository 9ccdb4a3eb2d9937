// Painting, as a command of its own and as a part of others.
#pragma once

#include "model/document/command_ptr.h"
#include "model/document/document.h"

#include <vector>

namespace hairpaint::model {

/// Tiles of one layer and their new content.
struct LayerEdit
{
    LayerAddress address;
    LayerTiles after;
};
/// Swaps tiles. `text`: what undo says, "Brush on Length". Null where none differs.
[[nodiscard]] CommandPtr paintCommand(Document& document, std::vector<LayerEdit> layers, const QString& text);
[[nodiscard]] CommandPtr paintCommand(Document& document, const LayerAddress& address, LayerTiles after,
                                      const QString& text);

/// paintCommand() without what is worn as patches of it.
[[nodiscard]] CommandPtr plainPaintCommand(Document& document, std::vector<LayerEdit> layers, const QString& text);
/// The tiles put into their layers, where these are there.
void layIn(Project& project, const std::vector<LayerEdit>& layers);

} // namespace hairpaint::model
