// The undo command behind every change but painting: it runs an edit once and keeps what the edit changed.
#pragma once

#include "model/document/commands.h"

#include <functional>
#include <vector>

namespace hairpaint::model {

/// An edit and the part of the content that it may touch.
struct ShownPart
{
    Change change;
    std::function<void(Project&)> edit;
};

/// Keeps the part that `change` names (any aspect but Texels and Everything) as it was before and after. The history is
/// linear, so putting those back gives exactly the content of before and after. They share tiles with the content.
/// Null where the content would become too large (Document::mayBecome). `edit` may run more than once.
[[nodiscard]] CommandPtr editCommand(Document& document, const Change& change, const QString& text,
                                     std::function<void(Project&)> edit);

/// One step out of parts edited one after the other and tiles laid in afterwards. Null where nothing differs or the
/// content would become too large.
[[nodiscard]] CommandPtr shownEditCommand(Document& document, const std::vector<ShownPart>& parts,
                                          std::vector<LayerEdit> layers, const QString& text);

} // namespace hairpaint::model
