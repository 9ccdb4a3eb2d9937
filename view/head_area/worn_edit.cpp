// One undo step each.
#include "view/head_area/worn_edit.h"

#include "model/document/gather_command.h"
#include "model/document/scene_commands.h"
#include "model/patches/project_patches.h"
#include "model/project/worn_on_ties.h"
#include "sim/groom/groom.h"
#include "view/editing/editor_state.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace hairpaint::view {

namespace {

/// Pushes it, and chooses what it added: the newest of its kind is the last one.
void pushAndChoose(EditorState& editor, model::CommandPtr command, model::WornKind kind)
{
    editor.document().push(std::move(command));
    const std::vector<model::Worn>& all = editor.document().project().worn;
    editor.options().setChosenWorn(std::ranges::find(all.rbegin(), all.rend(), kind, &model::Worn::kind)->id);
}

model::Worn wornAt(const model::Project& project, const model::WornSpec& spec, const sim::SurfacePoint& point,
                   model::Id group)
{
    model::Worn worn = makeWorn(spec, point, group);
    if (const model::Worn* tie = tieBeside(project.worn, spec, point.positionHd))
        sitOn(worn, *tie);
    return worn;
}

/// The brush offers what was put on last.
void offer(EditorState& editor, const model::WornSpec& spec)
{
    model::ToolSettings settings = editor.tools().settings();
    settings.value(model::MapKind::Accessory).index = paletteIndexOf(spec);
    editor.tools().setSettings(settings);
}

/// Whether some of the hair that the chosen tie gathers would lie in a cornrow without it.
bool takesRows(EditorState& editor)
{
    constexpr int kSamples = 256; // Along each side of the map.
    model::Document& document = editor.document();
    const model::Worn* tie = document.project().wornThing(editor.options().chosenWorn());
    const model::ProjectPatches::Group* patches = tie != nullptr ? document.patches().group(tie->group) : nullptr;
    const sim::MapRaster rows = patches != nullptr ? document.resolvedNow(tie->group, model::MapKind::Braid) : nullptr;
    if (rows == nullptr || (rows->uniformValue() && (*rows->uniformValue())[0] == 0))
        return false;
    for (int y = 0; y < kSamples; ++y)
        for (int x = 0; x < kSamples; ++x) {
            const glm::vec2 uv = (glm::vec2(x, y) + 0.5F) / static_cast<float>(kSamples);
            if (sim::braidKindOf(rows->sampleNearest(uv)[0]) != sim::BraidKind::Cornrow)
                continue;
            const std::optional<std::size_t> patch = patches->labels.at(uv);
            if (patch && patches->things[*patch] == tie->id)
                return true;
        }
    return false;
}

/// After a tie was put on.
void tellOfTie(EditorState& editor, const model::WornSpec& spec)
{
    offer(editor, spec);
    if (takesRows(editor))
        editor.tell(model::wornText(QT_TRANSLATE_NOOP(
            "Worn",
            "This tie takes the hair out of the cornrows under it: select the other hair before you put one on")));
}

} // namespace

void addWornAt(EditorState& editor, model::WornKind kind, const sim::SurfacePoint& point)
{
    const model::WornSpec& spec = model::wornSpec(kind);
    model::Document& document = editor.document();
    model::CommandPtr command =
        spec.patchStep == nullptr
            ? addWornCommand(document, wornAt(document.project(), spec, point, editor.target().group()))
            : gatherCommand(document, editor.target().group(), spec, point, editor.tools().selection().rectangles());
    if (command == nullptr) {
        if (spec.patchStep != nullptr && editor.tools().mayPaint({model::MapKind::Accessory}))
            Q_EMIT editor.refused(model::wornText(
                QT_TRANSLATE_NOOP("Worn", "No hair is left to gather here: paint density, or take another tie off")));
        return;
    }
    if (!spec.drawn())
        editor.options().setCollidersShown(true);
    pushAndChoose(editor, std::move(command), kind);
    if (spec.patchStep != nullptr)
        tellOfTie(editor, spec);
}

void addWornThing(EditorState& editor, const model::Worn& worn)
{
    if (model::CommandPtr command = addWornCommand(editor.document(), worn))
        pushAndChoose(editor, std::move(command), worn.kind);
}

void mirrorChosenWorn(EditorState& editor)
{
    const model::Project& project = editor.document().project();
    const model::Worn* chosen = project.wornThing(editor.options().chosenWorn());
    if (chosen != nullptr && !chosen->patch && project.head != nullptr && project.head->skin != nullptr) {
        model::Worn other = mirroredWorn(*chosen, *project.head->skin);
        // The tail on the other side takes it, if there is one.
        if (chosen->tie != 0)
            if (const model::Worn* tie = tieBeside(project.worn, wornSpec(other.kind), other.shape.centreHd))
                other.tie = tie->id;
        addWornThing(editor, other);
    }
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
    pushAndChoose(editor, std::move(command), spec.kind);
    tellOfTie(editor, spec);
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
