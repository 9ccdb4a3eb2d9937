// The hair groups, what is worn, and the active group's settings.
#pragma once

#include "model/project/project.h"
#include "model/values/error.h"
#include "view/editing/editor_state.h"

#include <QMenu>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>

class QToolButton;
class QVBoxLayout;

namespace hairpaint::model {
struct HairKind;
} // namespace hairpaint::model

namespace hairpaint::view {

class LayerList;

/// Lists the groups, of which one is active; adds, removes, hides, moves and renames them.
class HairPanel : public QWidget
{
    Q_OBJECT
public:
    explicit HairPanel(EditorState& state, QWidget* parent = nullptr);

    /// Shows a list of what can grow; the one chosen is added.
    void askWhatGrows();
    /// A group as it grows on a head; none where that is not known; an error where it was stopped.
    using Grown = std::optional<model::HairGroup>;
    using Grow = std::function<model::Result<Grown>(const model::HairKind& kind,
                                                    const std::shared_ptr<const model::Head>& head)>;
    /// Sets how groups are grown, which takes a moment: not on this thread. Without it groups are added bare.
    void setGrow(Grow grow) { m_grow = std::move(grow); }
    /// Adds a group of that kind, ready to be painted: its Density is the map that is painted then. Brows, lashes and
    /// beards are there where they grow, as far as that is known on the head.
    void addGroup(const model::HairKind& kind);
    void removeGroup();

private:
    void buildGroups(QVBoxLayout& layout);
    void rebuildGroups();
    [[nodiscard]] const model::HairGroup* group() const;

    EditorState& m_state;
    Grow m_grow;
    /// The last one shown. It stays: what is chosen grows, and shows how far it is, while the menu's own event is under
    /// way.
    std::unique_ptr<QMenu> m_menu;
    LayerList* m_groups = nullptr;
    QToolButton* m_add = nullptr;
    QToolButton* m_remove = nullptr;
    bool m_filling = false;
};

} // namespace hairpaint::view
