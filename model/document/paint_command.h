// Painting as other commands make it a part of theirs.
#pragma once

#include "model/document/commands.h"

#include <vector>

namespace hairpaint::model {

/// paintCommand() without what is worn as patches of it.
[[nodiscard]] CommandPtr plainPaintCommand(Document& document, std::vector<LayerEdit> layers, const QString& text);
/// The tiles put into their layers, where these are there.
void layIn(Project& project, const std::vector<LayerEdit>& layers);

} // namespace hairpaint::model
