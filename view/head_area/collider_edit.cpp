// One undo step each.
#include "view/head_area/collider_edit.h"

#include "model/document/commands.h"
#include "view/editing/editor_state.h"

#include <QCoreApplication>

namespace hairpaint::view {

void addColliderAt(EditorState& editor, const sim::SurfacePoint& place)
{
    constexpr float kRadiusM = 0.03F;
    model::Document& document = editor.document();
    std::vector<sim::Ellipsoid> all = document.project().ellipsoids;
    if (all.size() >= model::kMostEllipsoids)
        return;
    all.push_back({.centreHd = place.positionHd - 0.5F * kRadiusM * place.normalHd, .semiAxesM = glm::vec3(kRadiusM)});
    const std::size_t added = all.size() - 1;
    document.push(
        setEllipsoidsCommand(document, std::move(all), QCoreApplication::translate("ColliderEdit", "Add collider")));
    editor.options().setCollidersShown(true);
    editor.options().setChosenCollider(added);
}

void removeChosenCollider(EditorState& editor)
{
    const std::optional<std::size_t> chosen = editor.options().chosenCollider();
    if (!chosen)
        return;
    model::Document& document = editor.document();
    std::vector<sim::Ellipsoid> all = document.project().ellipsoids;
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(*chosen));
    editor.options().setChosenCollider(std::nullopt);
    document.push(
        setEllipsoidsCommand(document, std::move(all), QCoreApplication::translate("ColliderEdit", "Remove collider")));
}

} // namespace hairpaint::view
