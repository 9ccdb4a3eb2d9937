// The moving air, shown live.
#include "view/dialogs/wind_dialog.h"

#include "model/commands/commands.h"
#include "view/theme.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/direction_ball.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include <numbers>

namespace hairpaint::view {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kPercent = 100.0;

} // namespace

WindDialog::WindDialog(EditorState& state, QWidget* parent) : QDialog(parent), m_state(state)
{
    setWindowTitle(tr("Wind"));
    setModal(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kPadding, metrics::kPadding, metrics::kPadding, metrics::kPadding);
    layout->setSpacing(metrics::kGap);
    m_enabled = new QCheckBox(tr("Wind &blows"), this);
    layout->addWidget(m_enabled, 0, Qt::AlignLeft);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kPadding);
    m_ball = new DirectionBall(DirectionBall::Meaning::Toward, this);
    row->addWidget(m_ball, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout;
    column->setSpacing(metrics::kGap);
    const sim::Wind standard;
    m_strength = makeSlider(tr("Strength"), 0.0, 30.0, 1, tr("m/s"));
    m_strength->setExponent(2.0);
    m_strength->setDefaultValue(0.0);
    m_azimuth = makeSlider(tr("Blows to, around"), -180.0, 180.0, 0, QStringLiteral("°"));
    m_azimuth->setHint(tr("0° blows toward the viewer in front, 90° to the right"));
    m_elevation = makeSlider(tr("Blows to, upward"), -90.0, 90.0, 0, QStringLiteral("°"));
    m_elevation->setDefaultValue(0.0);
    m_gustiness = makeSlider(tr("Gusts"), 0.0, kPercent, 0, QStringLiteral("%"));
    m_gustiness->setDefaultValue(static_cast<double>(standard.gustiness) * kPercent);
    m_gustiness->setHint(tr("Share of the strength that comes and goes over seconds"));
    m_turbulence = makeSlider(tr("Turbulence"), 0.0, kPercent, 0, QStringLiteral("%"));
    m_turbulence->setDefaultValue(static_cast<double>(standard.turbulence) * kPercent);
    m_turbulence->setHint(tr("Share of the strength that differs from place to place"));
    for (BarSlider* slider : {m_strength, m_azimuth, m_elevation, m_gustiness, m_turbulence})
        column->addWidget(slider);
    column->addStretch(1);
    row->addLayout(column, 1);
    layout->addLayout(row);
    layout->setSizeConstraint(QLayout::SetFixedSize);

    const Edit turned = [this](sim::Wind& wind) { wind.velocity = m_ball->direction() * glm::length(wind.velocity); };
    const auto turnBall = [this] {
        m_ball->setDirection(DirectionBall::fromAngles(m_azimuth->value() / kDegrees, m_elevation->value() / kDegrees));
    };
    connect(m_azimuth, &BarSlider::valueChanged, this, turnBall);
    connect(m_elevation, &BarSlider::valueChanged, this, turnBall);
    bind(*m_azimuth, turned);
    bind(*m_elevation, turned);
    bind(*m_strength,
         [this](sim::Wind& wind) { wind.velocity = m_ball->direction() * static_cast<float>(m_strength->value()); });
    bind(*m_gustiness,
         [this](sim::Wind& wind) { wind.gustiness = static_cast<float>(m_gustiness->value() / kPercent); });
    bind(*m_turbulence,
         [this](sim::Wind& wind) { wind.turbulence = static_cast<float>(m_turbulence->value() / kPercent); });
    connect(m_ball, &DirectionBall::changed, this, [this, turned](glm::vec3 direction) {
        m_azimuth->setValue(DirectionBall::azimuthRad(direction) * kDegrees);
        m_elevation->setValue(DirectionBall::elevationRad(direction) * kDegrees);
        preview(turned);
    });
    connect(m_ball, &DirectionBall::finished, this, [this, turned] { commit(turned); });
    connect(m_ball, &DirectionBall::cancelled, this, &WindDialog::revert);
    connect(m_enabled, &QCheckBox::clicked, this,
            [this](bool on) { commit([on](sim::Wind& wind) { wind.enabled = on; }); });
    connect(&state.document(), &model::Document::changed, this, [this](const model::Change& change) {
        if (change.aspect == model::Change::Aspect::Environment || change.aspect == model::Change::Aspect::Everything)
            follow();
    });
    follow();
}

BarSlider* WindDialog::makeSlider(const QString& label, double minimum, double maximum, int decimals,
                                  const QString& unit)
{
    auto* slider = new BarSlider(label, this);
    slider->setRange(minimum, maximum, decimals);
    slider->setUnit(unit);
    slider->setMinimumWidth(216);
    return slider;
}

void WindDialog::bind(BarSlider& slider, const Edit& edit)
{
    connect(&slider, &BarSlider::valueChanged, this, [this, edit] { preview(edit); });
    connect(&slider, &BarSlider::editingFinished, this, [this, edit] { commit(edit); });
    connect(&slider, &BarSlider::editingCancelled, this, &WindDialog::revert);
}

bool WindDialog::editing() const
{
    return m_ball->editing() || m_azimuth->editing() || m_elevation->editing() || m_strength->editing() ||
           m_gustiness->editing() || m_turbulence->editing();
}

void WindDialog::follow()
{
    if (editing())
        return;
    const sim::Wind& wind = m_state.document().project().wind;
    const float strength = glm::length(wind.velocity);
    m_enabled->setChecked(wind.enabled);
    m_strength->setValue(static_cast<double>(strength));
    // Still air keeps the direction that was shown last.
    if (strength > 0.0F) {
        const glm::vec3 direction = wind.velocity / strength;
        m_ball->setDirection(direction);
        m_azimuth->setValue(DirectionBall::azimuthRad(direction) * kDegrees);
        m_elevation->setValue(DirectionBall::elevationRad(direction) * kDegrees);
    }
    m_gustiness->setValue(static_cast<double>(wind.gustiness) * kPercent);
    m_turbulence->setValue(static_cast<double>(wind.turbulence) * kPercent);
}

void WindDialog::preview(const Edit& edit)
{
    if (!m_edit.active())
        m_state.document().endEdit(); // It may be of the same.
    // Only what was touched changes: the numbers shown are rounded.
    m_state.document().show(m_edit, {.text = model::windStepText()}, {.aspect = model::Change::Aspect::Environment},
                            [wind = edited(edit)](model::Project& project) { project.wind = wind; });
}

void WindDialog::commit(const Edit& edit)
{
    preview(edit);
    m_edit.commit();
}

sim::Wind WindDialog::edited(const Edit& edit) const
{
    sim::Wind wind = m_state.document().committed().wind;
    edit(wind);
    return wind;
}

void WindDialog::revert()
{
    m_edit.drop();
    follow();
}

} // namespace hairpaint::view
