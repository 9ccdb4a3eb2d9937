// One undo step each.
#include "view/head_area/worn_edit.h"

#include "model/document/gather_command.h"
#include "model/document/scene_commands.h"
#include "view/editing/editor_state.h"

#include <QCoreApplication>

#include <algorithm>

namespace hairpaint::view {

void addWornAt(EditorState& editor, model::WornKind kind, const sim::SurfacePoint& point)
{
    const model::WornSpec& spec = model::wornSpec(kind);
    model::Document& document = editor.document();
    model::CommandPtr command =
        spec.patchStep == nullptr
            ? addWornCommand(document, makeWorn(spec, point, editor.target().group()))
            : gatherCommand(document, editor.target().group(), spec, point, editor.tools().selection().rectangles());
    if (command == nullptr) {
        if (spec.patchStep != nullptr && editor.tools().mayPaint({model::MapKind::Accessory}))
            Q_EMIT editor.refused(model::wornText(
                QT_TRANSLATE_NOOP("Worn", "No hair is left to gather here: paint density, or take another tie off")));
        return;
    }
    document.push(std::move(command));
    const std::vector<model::Worn>& all = document.project().worn;
    if (!spec.drawn())
        editor.options().setCollidersShown(true);
    // The newest of its kind is the last one.
    editor.options().setChosenWorn(std::ranges::find(all.rbegin(), all.rend(), kind, &model::Worn::kind)->id);
}

void addTwinTailsAt(EditorState& editor, const sim::SurfacePoint& point)
{
    // A table that lasts; what gathers hair into a tail can do so on both sides.
    const model::WornSpec& spec =
        *std::ranges::find(model::wornSpecs(), std::optional(sim::TieForm::Tail), &model::WornSpec::tie);
    model::Document& document = editor.document();
    model::CommandPtr command =
        gatherTwinsCommand(document, editor.target().group(), spec, point, editor.tools().selection().rectangles());
    if (command == nullptr) {
        if (editor.tools().mayPaint({model::MapKind::Accessory}))
            Q_EMIT editor.refused(model::wornText(QT_TRANSLATE_NOOP(
                "Worn", "No hair grows on both sides here that two tails could take: paint density on both")));
        return;
    }
    document.push(std::move(command));
    const std::vector<model::Worn>& all = document.project().worn;
    editor.options().setChosenWorn(std::ranges::find(all.rbegin(), all.rend(), spec.kind, &model::Worn::kind)->id);
}

void removeChosenWorn(EditorState& editor)
{
    model::Document& document = editor.document();
    const model::Id chosen = editor.options().chosenWorn();
    if (chosen == 0)
        return;
    editor.options().setChosenWorn(0);
    document.push(removeWornCommand(document, chosen));
}

} // namespace hairpaint::view
