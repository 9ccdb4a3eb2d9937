// Copies of what is painted on go to a job with the newest hair.
#include "app/window/hold_hair.h"

#include "model/tools/combing/hold.h"
#include "model/tools/live_edit.h"
#include "model/values/sentences.h"

#include <algorithm>

namespace hairpaint::app {

using model::MapKind;

QString HoldHair::notHeldText()
{
    return tr("The hair is not held: cancelled");
}

void HoldHair::hold()
{
    view::EditorState& editor = m_session.editor();
    editor.tools().commitStroke();
    if (!editor.tools().mayPaint({MapKind::Direction, MapKind::Gel}))
        return;
    const std::shared_ptr<const sim::StrandFrame> hair = m_exchange.currentHair(notHeldText());
    if (hair == nullptr)
        return;
    auto result = held(hair);
    if (!result)
        return;
    if (!*result)
        return editor.tell(result->error().message);
    model::Document& document = m_session.document();
    document.push(model::paintCommand(document, std::move(**result), model::holdStepText()));
}

std::optional<model::Result<std::vector<model::LayerEdit>>>
HoldHair::held(const std::shared_ptr<const sim::StrandFrame>& hair)
{
    using Edits = std::vector<model::LayerEdit>;
    view::EditorState& editor = m_session.editor();
    model::Document& document = m_session.document();
    const auto target = [&](MapKind map) {
        const model::LayerAddress address{
            .group = editor.target().group(), .map = map, .layer = editor.target().layer(map)};
        const model::Layer* layer = document.committed().layer(address.group, address.map, address.layer);
        return model::HoldRequest::Target{.address = address,
                                          .layer = layer->raster,
                                          .clips =
                                              model::selectedTexels(editor.tools().selection(), layer->raster.size())};
    };
    const model::HoldRequest request{.direction = target(MapKind::Direction),
                                     .gel = target(MapKind::Gel),
                                     .shownGel = document.resolvedNow(editor.target().group(), MapKind::Gel),
                                     .leastGel = editor.tools().settings().holdGel};
    const std::shared_ptr<const model::Head> head = document.project().head;
    return m_jobs.await<Edits>(
        {.text = tr("Holding the hair"), .whenCancelled = notHeldText()},
        [&hair, &head, &request](const model::Progress& progress) -> model::Result<Edits> {
            const auto group = std::ranges::find_if(hair->groups, [&request](const sim::GroupFrame& one) {
                return one.groom != nullptr && one.groom->groupId == request.direction.address.group;
            });
            std::vector<model::LyingHair> hairs;
            std::vector<model::LyingHair> further;
            if (group != hair->groups.end()) {
                hairs = model::lyingHairs(*group, hair->pose, hair->asleep);
                if (!hair->asleep) // At rest no direction changes.
                    further = model::hairsFurtherOn(*group, hair->pose, head->distances.get());
            }
            if (hairs.empty())
                return model::failure(tr("There is no hair to hold in this group."));
            std::optional<Edits> edits = model::holdHair(model::LyingField(hairs, further), request, progress);
            if (!edits)
                return model::cancelled({});
            if (std::ranges::all_of(*edits, [](const model::LayerEdit& edit) { return edit.after.empty(); }))
                return model::failure(
                    tr("Nothing to hold: this hair hangs by its weight, or its gel holds it already."));
            return std::move(*edits);
        });
}

} // namespace hairpaint::app
