// The key light and the ambient light, shown live.
#pragma once

#include "view/editor_state.h"

#include <QDialog>

#include <functional>

class QVBoxLayout;

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
    using Edit = std::function<void(model::LightSettings&)>;
    [[nodiscard]] BarSlider* addSlider(const QString& label, double minimum, double maximum, const QString& unit,
                                       double standard);
    void bind(BarSlider& slider, const Edit& edit);
    void buildSliders();
    void buildColours();
    void follow();
    void preview(const Edit& edit);
    void commit(const Edit& edit);
    [[nodiscard]] model::LightSettings edited(const Edit& edit) const;
    void revert();
    void chooseColour();
    void chooseBackground();

    EditorState& m_state;
    model::EditSession m_edit; ///< Of the light.
    model::EditSession m_backgroundEdit;
    QVBoxLayout* m_column = nullptr;
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
};

} // namespace hairpaint::view
