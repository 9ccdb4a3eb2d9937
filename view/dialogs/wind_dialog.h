// The moving air, shown live.
#pragma once

#include "view/editor_state.h"

#include <QDialog>

#include <functional>

class QCheckBox;

namespace hairpaint::view {

class BarSlider;
class DirectionBall;

/// Not modal. Each change is previewed while it moves and one undo step when let go.
class WindDialog : public QDialog
{
    Q_OBJECT
public:
    explicit WindDialog(EditorState& state, QWidget* parent = nullptr);

private:
    using Edit = std::function<void(sim::Wind&)>;
    [[nodiscard]] BarSlider* makeSlider(const QString& label, double minimum, double maximum, int decimals,
                                        const QString& unit);
    void bind(BarSlider& slider, const Edit& edit);
    [[nodiscard]] bool editing() const;
    void follow();
    void preview(const Edit& edit);
    void commit(const Edit& edit);
    [[nodiscard]] sim::Wind edited(const Edit& edit) const;
    void revert();

    EditorState& m_state;
    model::EditSession m_edit;
    QCheckBox* m_enabled = nullptr;
    DirectionBall* m_ball = nullptr;
    BarSlider* m_azimuth = nullptr;
    BarSlider* m_elevation = nullptr;
    BarSlider* m_strength = nullptr;
    BarSlider* m_gustiness = nullptr;
    BarSlider* m_turbulence = nullptr;
};

} // namespace hairpaint::view
