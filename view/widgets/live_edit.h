// The one way in which panels change the document while something moves: previews, then a single command.
#pragma once

#include "model/commands/commands.h"

#include <functional>

namespace hairpaint::view {

/// Shows `edit` without committing it.
void previewEdit(model::Document& document, const model::Change& change,
                 const std::function<void(model::Project&)>& edit);
/// Takes the preview back and pushes what `make` gives (null: nothing changed). `make` sees the committed content.
void commitEdit(model::Document& document, const std::function<model::CommandPtr()>& make);

} // namespace hairpaint::view
