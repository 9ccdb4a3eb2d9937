// From the editor's state to the overlay.
#include "view/head_area/shown_directions.h"

#include "view/head_area/head_overlay.h"

#include <utility>

namespace hairpaint::view {

ShownDirections::ShownDirections(EditorState& state, HeadOverlay& overlay, std::function<Sight()> sight)
    : m_state(state), m_overlay(overlay), m_sight(std::move(sight))
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, &ShownDirections::refresh);
    connect(&state.target(), &EditTarget::changed, this, &ShownDirections::refreshSoon);
    connect(&state.document(), &model::Document::changed, this, &ShownDirections::onDocumentChanged);
    const auto unfade = [this] { m_overlay.setDirectionsFaded(false); };
    connect(&state.target(), &EditTarget::changed, this, unfade);
    connect(&state.tools(), &ToolBox::activeChanged, this, unfade);
    connect(&state.options(), &ViewOptions::changed, this, unfade);
}

void ShownDirections::onDocumentChanged(const model::Change& change)
{
    using Aspect = model::Change::Aspect;
    if (change.aspect == Aspect::Texels && m_state.tools().layingHair())
        m_overlay.setDirectionsFaded(true);
    if (change.aspect != Aspect::Environment && change.aspect != Aspect::Settings)
        refreshSoon();
}

void ShownDirections::setLookedAt(std::optional<model::MapKind> map)
{
    m_lookedAt = map;
    refreshSoon();
}

void ShownDirections::refreshSoon()
{
    m_soon.start();
}

void ShownDirections::refresh()
{
    m_soon.stop();
    const model::Document& document = m_state.document();
    DirectionField field;
    const bool wanted = m_state.options().directionsShown() && m_state.target().map() == model::MapKind::Direction;
    if (wanted || m_lookedAt == model::MapKind::Direction)
        field = {.direction = document.resolved(m_state.target().group(), model::MapKind::Direction),
                 .density = document.resolved(m_state.target().group(), model::MapKind::Density)};
    const std::shared_ptr<const model::Head>& head = document.project().head;
    const Sight sight = m_sight();
    m_overlay.setDirections(
        m_hairs.seen(head ? head->skin : nullptr, field, sight.camera, sight.pose, QSizeF(m_overlay.size())));
}

} // namespace hairpaint::view
