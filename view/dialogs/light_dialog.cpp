// The key light, the ambient light and the background, shown live.
#include "view/dialogs/light_dialog.h"

#include "model/commands/commands.h"
#include "view/theme.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/direction_ball.h"
#include "view/widgets/swatch.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hairpaint::view {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kPercent = 100.0;

/// Linear light as the screen shows it.
double encoded(double linear)
{
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double linear(double shown)
{
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

QColor shownColour(const model::LightSettings& light)
{
    const auto channel = [](float value) {
        return static_cast<float>(encoded(std::clamp(static_cast<double>(value), 0.0, 1.0)));
    };
    return QColor::fromRgbF(channel(light.red), channel(light.green), channel(light.blue));
}

} // namespace

LightDialog::LightDialog(EditorState& state, QWidget* parent) : QDialog(parent), m_state(state)
{
    setWindowTitle(tr("Light"));
    setModal(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kPadding, metrics::kPadding, metrics::kPadding, metrics::kPadding);
    layout->setSpacing(metrics::kGap);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kPadding);
    m_ball = new DirectionBall(DirectionBall::Meaning::From, this);
    row->addWidget(m_ball, 0, Qt::AlignTop);
    m_column = new QVBoxLayout;
    m_column->setSpacing(metrics::kGap);
    buildSliders();
    buildColours();
    m_column->addStretch(1);
    row->addLayout(m_column, 1);
    layout->addLayout(row);
    layout->setSizeConstraint(QLayout::SetFixedSize);

    const Edit turned = [this](model::LightSettings& light) {
        light.azimuthRad = static_cast<float>(DirectionBall::azimuthRad(m_ball->direction()));
        light.elevationRad = static_cast<float>(DirectionBall::elevationRad(m_ball->direction()));
    };
    connect(m_ball, &DirectionBall::changed, this, [this, turned](glm::vec3 direction) {
        m_azimuth->setValue(DirectionBall::azimuthRad(direction) * kDegrees);
        m_elevation->setValue(DirectionBall::elevationRad(direction) * kDegrees);
        preview(turned);
    });
    connect(m_ball, &DirectionBall::finished, this, [this, turned] { commit(turned); });
    connect(m_ball, &DirectionBall::cancelled, this, &LightDialog::revert);
    connect(&state.document(), &model::Document::changed, this, [this](const model::Change& change) {
        if (change.aspect == model::Change::Aspect::Environment || change.aspect == model::Change::Aspect::Everything)
            follow();
    });
    follow();
}

void LightDialog::buildSliders()
{
    const model::LightSettings standard;
    const QString degree = QStringLiteral("°");
    const QString percent = QStringLiteral("%");
    const auto percentOf = [](float value) { return static_cast<double>(value) * kPercent; };
    m_azimuth =
        addSlider(tr("Comes from, around"), -180.0, 180.0, degree, static_cast<double>(standard.azimuthRad) * kDegrees);
    m_elevation =
        addSlider(tr("Comes from, above"), -90.0, 90.0, degree, static_cast<double>(standard.elevationRad) * kDegrees);
    m_intensity = addSlider(tr("Intensity"), 0.0, 400.0, percent, percentOf(standard.intensity));
    m_intensity->setExponent(2.0);
    m_ambient = addSlider(tr("Ambient"), 0.0, kPercent, percent, percentOf(standard.ambient));
    m_red = addSlider(tr("Red"), 0.0, kPercent, percent, percentOf(standard.red));
    m_green = addSlider(tr("Green"), 0.0, kPercent, percent, percentOf(standard.green));
    m_blue = addSlider(tr("Blue"), 0.0, kPercent, percent, percentOf(standard.blue));

    const auto shownFraction = [](const BarSlider* slider) { return static_cast<float>(slider->value() / kPercent); };
    bind(*m_azimuth,
         [this](model::LightSettings& light) { light.azimuthRad = static_cast<float>(m_azimuth->value() / kDegrees); });
    bind(*m_elevation, [this](model::LightSettings& light) {
        light.elevationRad = static_cast<float>(m_elevation->value() / kDegrees);
    });
    bind(*m_intensity, [=, this](model::LightSettings& light) { light.intensity = shownFraction(m_intensity); });
    bind(*m_ambient, [=, this](model::LightSettings& light) { light.ambient = shownFraction(m_ambient); });
    bind(*m_red, [=, this](model::LightSettings& light) { light.red = shownFraction(m_red); });
    bind(*m_green, [=, this](model::LightSettings& light) { light.green = shownFraction(m_green); });
    bind(*m_blue, [=, this](model::LightSettings& light) { light.blue = shownFraction(m_blue); });
}

BarSlider* LightDialog::addSlider(const QString& label, double minimum, double maximum, const QString& unit,
                                  double standard)
{
    auto* slider = new BarSlider(label, this);
    slider->setRange(minimum, maximum, 0);
    slider->setUnit(unit);
    slider->setDefaultValue(standard);
    slider->setMinimumWidth(216);
    m_column->addWidget(slider);
    return slider;
}

void LightDialog::bind(BarSlider& slider, const Edit& edit)
{
    connect(&slider, &BarSlider::valueChanged, this, [this, edit] { preview(edit); });
    connect(&slider, &BarSlider::editingFinished, this, [this, edit] { commit(edit); });
    connect(&slider, &BarSlider::editingCancelled, this, &LightDialog::revert);
}

void LightDialog::buildColours()
{
    auto* colours = new QHBoxLayout;
    colours->setSpacing(metrics::kGap);
    const auto swatch = [&](const QString& name) {
        auto* made = new Swatch(Qt::white, name, this);
        made->setCheckable(false);
        colours->addWidget(made);
        auto* label = new QLabel(name, this);
        label->setProperty("role", QStringLiteral("label"));
        colours->addWidget(label);
        return made;
    };
    m_colour = swatch(tr("Light colour"));
    colours->addStretch(1);
    m_background = swatch(tr("Background"));
    m_column->addLayout(colours);
    connect(m_colour, &Swatch::clicked, this, &LightDialog::chooseColour);
    connect(m_background, &Swatch::clicked, this, &LightDialog::chooseBackground);
}

void LightDialog::follow()
{
    const model::LightSettings& light = m_state.document().project().light;
    m_colour->setColour(shownColour(light));
    m_background->setColour(QColor::fromRgb(m_state.document().project().background));
    const auto azimuth = static_cast<double>(light.azimuthRad);
    const auto elevation = static_cast<double>(light.elevationRad);
    // Each control ignores what it is told while the user moves it.
    m_ball->setDirection(DirectionBall::fromAngles(azimuth, elevation));
    m_azimuth->setValue(azimuth * kDegrees);
    m_elevation->setValue(elevation * kDegrees);
    m_intensity->setValue(static_cast<double>(light.intensity) * kPercent);
    m_ambient->setValue(static_cast<double>(light.ambient) * kPercent);
    m_red->setValue(static_cast<double>(light.red) * kPercent);
    m_green->setValue(static_cast<double>(light.green) * kPercent);
    m_blue->setValue(static_cast<double>(light.blue) * kPercent);
}

void LightDialog::preview(const Edit& edit)
{
    if (!m_edit.active())
        m_state.document().endEdit(); // It may be of the same.
    // Only what was touched changes: the numbers shown are rounded.
    m_state.document().show(m_edit, {.text = model::lightStepText()}, {.aspect = model::Change::Aspect::Environment},
                            [light = edited(edit)](model::Project& project) { project.light = light; });
}

void LightDialog::commit(const Edit& edit)
{
    preview(edit);
    m_edit.commit();
}

model::LightSettings LightDialog::edited(const Edit& edit) const
{
    model::LightSettings light = m_state.document().committed().light;
    edit(light);
    return light;
}

void LightDialog::revert()
{
    m_edit.drop();
    m_backgroundEdit.drop();
    follow();
}

void LightDialog::chooseColour()
{
    auto* dialog = new QColorDialog(shownColour(m_state.document().project().light), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Light colour"));
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    const auto coloured = [](const QColor& colour) -> Edit {
        return [colour](model::LightSettings& light) {
            const auto channel = [](float value) { return static_cast<float>(linear(static_cast<double>(value))); };
            light.red = channel(colour.redF());
            light.green = channel(colour.greenF());
            light.blue = channel(colour.blueF());
        };
    };
    connect(dialog, &QColorDialog::currentColorChanged, this,
            [this, coloured](const QColor& colour) { preview(coloured(colour)); });
    connect(dialog, &QColorDialog::rejected, this, &LightDialog::revert);
    connect(dialog, &QColorDialog::colorSelected, this,
            [this, coloured](const QColor& colour) { commit(coloured(colour)); });
    dialog->open();
}

void LightDialog::chooseBackground()
{
    auto* dialog = new QColorDialog(QColor::fromRgb(m_state.document().project().background), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Background"));
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    const auto show = [this](const QColor& colour) {
        m_state.document().show(
            m_backgroundEdit, {.text = model::backgroundStepText()}, {.aspect = model::Change::Aspect::Environment},
            [background = colour.rgb()](model::Project& project) { project.background = background; });
    };
    connect(dialog, &QColorDialog::currentColorChanged, this, show);
    connect(dialog, &QColorDialog::rejected, this, &LightDialog::revert);
    connect(dialog, &QColorDialog::colorSelected, this, [this, show](const QColor& colour) {
        show(colour);
        m_backgroundEdit.commit();
    });
    dialog->open();
}

} // namespace hairpaint::view
