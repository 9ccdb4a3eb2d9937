// Worn things added to and removed from the document.
#pragma once

#include "model/project/worn.h"
#include "sim/skin/skin.h"

namespace hairpaint::view {

class EditorState;

/// On the skin there; it is chosen, and seen: of a kind that is never drawn, by its outline. Nothing where a project
/// holds no more.
void addWornAt(EditorState& editor, model::WornKind kind, const sim::SurfacePoint& point);
/// A thing that was made; it is chosen. Nothing where a project holds no more.
void addWornThing(EditorState& editor, const model::Worn& worn);
/// A copy of the chosen one on the other side of the head; the copy is chosen. Nothing where none is chosen, or it is
/// painted, or a project holds no more.
void mirrorChosenWorn(EditorState& editor);
/// A tail there and one on the other side of the head, parted along the middle; one is chosen.
void addTwinTailsAt(EditorState& editor, const sim::SurfacePoint& point);
/// Nothing where none is chosen.
void removeChosenWorn(EditorState& editor);

} // namespace hairpaint::view
