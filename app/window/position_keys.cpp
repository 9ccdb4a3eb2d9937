// From a key's position to its action, or to the map that is looked at.
#include "app/window/position_keys.h"

#include "app/session/session.h"
#include "app/window/action_set.h"
#include "app/window/workspace.h"
#include "view/head_area/head_view.h"
#include "view/paint_area/map_legend.h"

#include <QAction>
#include <QKeyEvent>

namespace hairpaint::app {

bool PositionKeys::press(const QKeyEvent& event)
{
    if (event.modifiers() == Qt::AltModifier) {
        const int digit = digitOf(physicalKey(event));
        if (digit >= 1 && digit <= model::kMapKindCount) {
            if (!event.isAutoRepeat())
                lookAt(static_cast<model::MapKind>(digit - 1));
            return true;
        }
    }
    QAction* action = event.modifiers() == Qt::NoModifier ? actionAt(physicalKey(event)) : nullptr;
    if (action == nullptr)
        return false;
    action->trigger();
    return true;
}

void PositionKeys::release(const QKeyEvent& event)
{
    if (!event.isAutoRepeat() && (event.key() == Qt::Key_Alt || digitOf(physicalKey(event)) > 0))
        lookAt(std::nullopt);
}

void PositionKeys::lookAt(std::optional<model::MapKind> map)
{
    m_session.lookAt(map);
    m_workspace.headView().setLookedAt(map);
    const model::HairGroup* group = m_session.document().project().group(m_session.editor().target().group());
    if (map && group != nullptr)
        m_workspace.legend().showMap(model::mapSpec(*map), group->settings);
    else
        m_workspace.legend().hide();
}

QAction* PositionKeys::actionAt(PhysicalKey key) const
{
    QByteArray id;
    const int digit = digitOf(key);
    if (key == PhysicalKey::BracketLeft)
        id = "tool.smaller";
    else if (key == PhysicalKey::BracketRight)
        id = "tool.larger";
    else if (digit >= 1 && digit <= model::kMapKindCount)
        id = QByteArray("map.") + model::mapSpec(static_cast<model::MapKind>(digit - 1)).id;
    QAction* action = m_actions.find(QLatin1StringView(id));
    return action != nullptr && action->shortcut() == QKeySequence(usualKey(key)) ? action : nullptr;
}

} // namespace hairpaint::app
