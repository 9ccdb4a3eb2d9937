// The moving air, shown live.
#pragma once

#include "view/dialogs/live_dialog.h"

class QCheckBox;

namespace hairpaint::view {

class WindDialog final : public LiveValueDialog<sim::Wind, &model::Project::wind>
{
    Q_OBJECT
public:
    explicit WindDialog(EditorState& state, QWidget* parent = nullptr);

private:
    void buildSliders();
    [[nodiscard]] bool editing() const;
    void follow() override;

    QCheckBox* m_enabled = nullptr;
    BarSlider* m_azimuth = nullptr;
    BarSlider* m_elevation = nullptr;
    BarSlider* m_strength = nullptr;
    BarSlider* m_gustiness = nullptr;
    BarSlider* m_turbulence = nullptr;
};

} // namespace hairpaint::view
