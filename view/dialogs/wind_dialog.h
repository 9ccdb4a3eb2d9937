// The moving air, shown live.
#pragma once

#include "view/editor_state.h"

#include <QDialog>

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
    void follow();
    void preview();
    void commit();
    void revert();
    [[nodiscard]] sim::Wind shown() const;

    EditorState& m_state;
    QCheckBox* m_enabled = nullptr;
    DirectionBall* m_ball = nullptr;
    BarSlider* m_azimuth = nullptr;
    BarSlider* m_elevation = nullptr;
    BarSlider* m_strength = nullptr;
    BarSlider* m_gustiness = nullptr;
    BarSlider* m_turbulence = nullptr;
    bool m_filling = false;
};

} // namespace hairpaint::view
