// Ellipsoids added to and removed from the document.
#pragma once

#include "sim/skin/skin.h"

namespace hairpaint::view {

class EditorState;

/// Half in the head; it is chosen, and all of them are shown. Nothing where a project holds no more.
void addColliderAt(EditorState& editor, const sim::SurfacePoint& place);
/// Nothing where none is chosen.
void removeChosenCollider(EditorState& editor);

} // namespace hairpaint::view
