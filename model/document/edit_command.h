// The undo command behind every change but painting: it runs an edit once and keeps what the edit changed.
#pragma once

#include "model/document/paint_command.h"

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

/// The same step, which also makes what is worn follow the patches of accessory maps: `after` is the content that the
/// command gives. Null stays null.
[[nodiscard]] CommandPtr withPatches(Document& document, CommandPtr command, Project after, const QString& text);
/// Whether that part of the content holds accessory maps, or what they lie on.
[[nodiscard]] bool needsPatches(const Change& change);

/// One step out of parts edited one after the other and tiles laid in afterwards. Null where nothing differs or the
/// content would become too large.
[[nodiscard]] CommandPtr shownEditCommand(Document& document, const std::vector<ShownPart>& parts,
                                          std::vector<LayerEdit> layers, const QString& text);

} // namespace hairpaint::model
