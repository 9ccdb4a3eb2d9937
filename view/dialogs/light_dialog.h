// The key light and the ambient light, shown live.
#pragma once

#include "view/dialogs/live_dialog.h"

namespace hairpaint::view {

class Swatch;

class LightDialog final : public LiveValueDialog<model::LightSettings, &model::Project::light>
{
    Q_OBJECT
public:
    explicit LightDialog(EditorState& state, QWidget* parent = nullptr);

private:
    /// Of 0..`greatest`, shown in per cent.
    BarSlider* addFraction(const QString& label, float model::LightSettings::*field, double greatest = 1.0);
    void buildSliders();
    void buildColours();
    void follow() override;
    void revert() override;
    void chooseColour();
    void chooseBackground();

    model::EditSession m_backgroundEdit;
    std::vector<std::pair<BarSlider*, float model::LightSettings::*>> m_fractions;
    BarSlider* m_azimuth = nullptr;
    BarSlider* m_elevation = nullptr;
    Swatch* m_colour = nullptr;
    Swatch* m_background = nullptr;
};

} // namespace hairpaint::view
