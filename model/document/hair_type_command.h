// A hair type chosen for a group, as a step of undo.
#pragma once

#include "model/document/command_ptr.h"
#include "model/document/document.h"
#include "model/project/hair_types.h"

namespace hairpaint::model {

/// The group's settings become those of `type`. Where the type curls and the curl map shows next to none anywhere, the
/// map is filled in the same step, so that whoever chooses a type sees it at once: in its topmost layer where that
/// shows all that is painted on it, else in a new one named after the type. Null where nothing differs.
[[nodiscard]] CommandPtr setHairTypeCommand(Document& document, Id group, const HairType& type, const QString& text);

} // namespace hairpaint::model
