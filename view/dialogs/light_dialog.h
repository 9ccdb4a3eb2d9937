// Presets, the lights and how hair scatters them, shown live.
#pragma once

#include "view/dialogs/live_dialog.h"

#include <functional>
#include <span>
#include <vector>

class QComboBox;
class QLabel;

namespace hairpaint::view {

class Swatch;

class LightDialog final : public LiveValueDialog<model::LightSettings, &model::Project::light>
{
    Q_OBJECT
public:
    explicit LightDialog(EditorState& state, QWidget* parent = nullptr);

private:
    /// Adds a slider for a field of 0..`greatest`, shown in per cent.
    BarSlider* addFraction(const QString& label, float model::LightSettings::*field, double greatest = 1.0);
    QComboBox* addChoice(const QString& name, std::span<const model::NamedValue> values,
                         const std::function<void(model::LightSettings&, int)>& set);
    void buildPresets();
    void buildSliders();
    void buildChoices();
    /// A colour's name and button in one row; `beside`: left of the button.
    Swatch* addSwatch(const QString& name, QLabel* beside = nullptr);
    void buildColour();
    void buildBackground();
    void follow() override;
    void revert() override;
    void chooseColour();
    void chooseBackground();

    model::EditSession m_backgroundEdit;
    std::vector<std::pair<BarSlider*, float model::LightSettings::*>> m_fractions;
    BarSlider* m_azimuth = nullptr;
    BarSlider* m_elevation = nullptr;
    BarSlider* m_temperature = nullptr;
    QComboBox* m_surroundings = nullptr;
    QComboBox* m_scattering = nullptr;
    Swatch* m_colour = nullptr;
    QLabel* m_channels = nullptr; ///< Percentages of red, green and blue in it.
    Swatch* m_background = nullptr;
};

} // namespace hairpaint::view
