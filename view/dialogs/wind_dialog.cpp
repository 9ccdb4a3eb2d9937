// The moving air, shown live.
#include "view/dialogs/wind_dialog.h"

#include "model/document/scene_commands.h"

#include <QCheckBox>
#include <QVBoxLayout>

namespace hairpaint::view {

WindDialog::WindDialog(EditorState& state, QWidget* parent)
    : LiveValueDialog(state, tr("Wind"), model::windStepText(), new DirectionBall(DirectionBall::Meaning::Toward),
                      parent)
{
    m_enabled = new QCheckBox(tr("Wind &blows"), this);
    rows().insertWidget(0, m_enabled, 0, Qt::AlignLeft);
    connect(m_enabled, &QCheckBox::clicked, this, [&document = state.document()](bool on) { document.setWindOn(on); });
    buildSliders();

    const Edit turned = [this](sim::Wind& wind) { wind.velocity = ball().direction() * glm::length(wind.velocity); };
    const auto turnBall = [this] {
        ball().setDirection(DirectionBall::fromAngles(m_azimuth->value() / kDegrees, m_elevation->value() / kDegrees));
    };
    for (BarSlider* angle : {m_azimuth, m_elevation}) {
        connect(angle, &BarSlider::valueChanged, this, turnBall);
        connect(angle, &BarSlider::editingCancelled, this, turnBall); // Still air does not tell it.
    }
    bind(m_azimuth, turned);
    bind(m_elevation, turned);
    bind(m_strength,
         [this](sim::Wind& wind) { wind.velocity = ball().direction() * static_cast<float>(m_strength->value()); });
    bind(m_gustiness,
         [this](sim::Wind& wind) { wind.gustiness = static_cast<float>(m_gustiness->value() / kPercent); });
    bind(m_turbulence,
         [this](sim::Wind& wind) { wind.turbulence = static_cast<float>(m_turbulence->value() / kPercent); });
    bindBall(m_azimuth, m_elevation, turned);
    follow();
}

void WindDialog::buildSliders()
{
    const sim::Wind standard;
    const QString degree = QStringLiteral("°");
    const QString percent = QStringLiteral("%");
    m_strength = addSlider(tr("Strength"), 0.0, 30.0, 1, tr("m/s"));
    m_strength->setExponent(2.0);
    m_strength->setDefaultValue(0.0);
    m_azimuth = addSlider(tr("Blows to, around"), -180.0, 180.0, 0, degree);
    m_azimuth->setHint(tr("0° blows toward the viewer in front, 90° to the right"));
    m_elevation = addSlider(tr("Blows to, upward"), -90.0, 90.0, 0, degree);
    m_elevation->setDefaultValue(0.0);
    m_gustiness = addSlider(tr("Gusts"), 0.0, kPercent, 0, percent);
    m_gustiness->setDefaultValue(static_cast<double>(standard.gustiness) * kPercent);
    m_gustiness->setHint(tr("Share of the strength that comes and goes over seconds"));
    m_turbulence = addSlider(tr("Turbulence"), 0.0, kPercent, 0, percent);
    m_turbulence->setDefaultValue(static_cast<double>(standard.turbulence) * kPercent);
    m_turbulence->setHint(tr("Share of the strength that differs from place to place"));
    column().addStretch(1);
}

bool WindDialog::editing() const
{
    return ball().editing() || m_azimuth->editing() || m_elevation->editing() || m_strength->editing() ||
           m_gustiness->editing() || m_turbulence->editing();
}

void WindDialog::follow()
{
    if (editing())
        return;
    const sim::Wind& wind = shown();
    const float strength = glm::length(wind.velocity);
    m_enabled->setChecked(wind.enabled);
    m_strength->setValue(static_cast<double>(strength));
    // Still air keeps the direction that was shown last.
    if (strength > 0.0F)
        showDirection(wind.velocity / strength, m_azimuth, m_elevation);
    m_gustiness->setValue(static_cast<double>(wind.gustiness) * kPercent);
    m_turbulence->setValue(static_cast<double>(wind.turbulence) * kPercent);
}

} // namespace hairpaint::view
