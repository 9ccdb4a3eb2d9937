// The key light and the ambient light, shown live.
#pragma once

#include "view/editor_state.h"

#include <QDialog>

namespace hairpaint::view {

class BarSlider;
class DirectionBall;
class Swatch;

/// Not modal. Each change is previewed while it moves and one undo step when let go.
class LightDialog : public QDialog
{
    Q_OBJECT
public:
    explicit LightDialog(EditorState& state, QWidget* parent = nullptr);

private:
    void follow();
    void preview();
    void commit();
    void revert();
    void chooseColour();
    void chooseBackground();
    [[nodiscard]] model::LightSettings shown() const;

    EditorState& m_state;
    DirectionBall* m_ball = nullptr;
    BarSlider* m_azimuth = nullptr;
    BarSlider* m_elevation = nullptr;
    BarSlider* m_intensity = nullptr;
    BarSlider* m_ambient = nullptr;
    BarSlider* m_red = nullptr;
    BarSlider* m_green = nullptr;
    BarSlider* m_blue = nullptr;
    Swatch* m_colour = nullptr;
    Swatch* m_background = nullptr;
    bool m_filling = false;
};

} // namespace hairpaint::view
