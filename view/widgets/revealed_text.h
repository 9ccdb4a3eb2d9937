// What erasing leaves where it erases.
#pragma once

#include "view/editing/editor_state.h"

namespace hairpaint::view {

/// Whether the active tool takes paint away.
[[nodiscard]] bool erases(const EditorState& state);

/// "reveals 15 cm, the default" on a map's lowest layer, or the map that it follows; else that the layers below show;
/// empty while the active tool erases nothing.
[[nodiscard]] QString revealedText(const EditorState& state);

} // namespace hairpaint::view
