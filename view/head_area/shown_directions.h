// The direction map as short hairs over the head: when they are shown, found anew and faded.
#pragma once

#include "view/editing/editor_state.h"
#include "view/head_area/direction_hairs.h"
#include "view/head_area/shot.h"

#include <QTimer>

#include <functional>
#include <optional>

namespace hairpaint::view {

class HeadOverlay;

/// Follows the editor; they show while the direction map is the active one, or is looked at, and fade while hair is
/// laid by hand and after, since then the hair is what is judged. GUI thread.
class ShownDirections : public QObject
{
    Q_OBJECT
public:
    /// `sight`: of the picture on the screen. All outlive it.
    ShownDirections(EditorState& state, HeadOverlay& overlay, std::function<Sight()> sight);

    void setLookedAt(std::optional<model::MapKind> map);
    void refresh();
    void refreshSoon(); ///< However much changes, they are found once.

private:
    void onDocumentChanged(const model::Change& change);

    EditorState& m_state;
    HeadOverlay& m_overlay;
    std::function<Sight()> m_sight;
    DirectionHairs m_hairs;
    QTimer m_soon;
    std::optional<model::MapKind> m_lookedAt;
};

} // namespace hairpaint::view
