// The handles of the active group's haircut, beside the styles.
#pragma once

#include "view/editing/editor_state.h"
#include "view/panels/known_handles.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <optional>

class QComboBox;
class QLabel;

namespace hairpaint::view {

class BarSlider;

/// Sliders for length, fringe and fade, a box for the part; only those that the hair has. Moving one shows it at once;
/// let go, it is one step of undo. What it does starts from the hair as it was when its style was put on, or painted
/// last, so that a slider brings back what it took. GUI thread.
class HandlePanel : public QWidget
{
    Q_OBJECT
public:
    explicit HandlePanel(EditorState& state, QWidget* parent);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void addSlider(model::HandleKind kind, const QString& unit, double shownPerValue, int decimals);
    void addPart();
    void follow();
    void show(model::HandleKind kind, double value);
    void commit();
    void drop();

    EditorState& m_state;
    KnownHandles m_known;
    std::optional<KnownHandles::State> m_base;   ///< State of the active group as it is committed.
    std::optional<KnownHandles::State> m_edited; ///< State of the active group as the edit shows it.
    model::EditSession m_edit;
    std::array<BarSlider*, model::kHandleCount> m_sliders{};
    QLabel* m_nothing = nullptr;
    QWidget* m_partRow = nullptr;
    QComboBox* m_part = nullptr;
    QTimer m_later{this}; ///< Several changes are looked at once.
};

} // namespace hairpaint::view
