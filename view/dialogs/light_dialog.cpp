// The lights and the background, shown live.
#include "view/dialogs/light_dialog.h"

#include "model/document/scene_commands.h"
#include "view/look/theme.h"
#include "view/widgets/swatch.h"

#include <QColorDialog>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

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

LightDialog::LightDialog(EditorState& state, QWidget* parent)
    : LiveValueDialog(state, tr("Light"), model::lightStepText(), new DirectionBall(DirectionBall::Meaning::From),
                      parent)
{
    buildPresets();
    buildSliders();
    buildChoices();
    buildBackground();
    column().addStretch(1);
    follow();
}

void LightDialog::buildSliders()
{
    const model::LightSettings standard;
    const QString degree = QStringLiteral("°");
    m_azimuth = addSlider(tr("Comes from, around"), -180.0, 180.0, 0, degree);
    m_azimuth->setDefaultValue(static_cast<double>(standard.azimuthRad) * kDegrees);
    m_elevation = addSlider(tr("Comes from, above"), -90.0, 90.0, 0, degree);
    m_elevation->setDefaultValue(static_cast<double>(standard.elevationRad) * kDegrees);
    bind(m_azimuth,
         [this](model::LightSettings& light) { light.azimuthRad = static_cast<float>(m_azimuth->value() / kDegrees); });
    bind(m_elevation, [this](model::LightSettings& light) {
        light.elevationRad = static_cast<float>(m_elevation->value() / kDegrees);
    });
    bindBall(m_azimuth, m_elevation, [this](model::LightSettings& light) {
        light.azimuthRad = static_cast<float>(DirectionBall::azimuthRad(ball().direction()));
        light.elevationRad = static_cast<float>(DirectionBall::elevationRad(ball().direction()));
    });
    addFraction(tr("Intensity"), &model::LightSettings::intensity, 4.0)->setExponent(2.0);
    m_temperature = addSlider(tr("Colour temperature"), static_cast<double>(model::kLeastTemperatureK),
                              static_cast<double>(model::kGreatestTemperatureK), 0, QStringLiteral("K"));
    m_temperature->setExponent(2.0);
    m_temperature->setDefaultValue(static_cast<double>(standard.temperatureK));
    bind(m_temperature,
         [this](model::LightSettings& light) { light.temperatureK = static_cast<float>(m_temperature->value()); });
    buildColour();
    addFraction(tr("Fill, beside the camera"), &model::LightSettings::fill, 2.0)->setExponent(2.0);
    addFraction(tr("Rim, behind the head"), &model::LightSettings::rim, 4.0)->setExponent(2.0);
    addFraction(tr("Ambient"), &model::LightSettings::ambient);
}

BarSlider* LightDialog::addFraction(const QString& label, float model::LightSettings::*field, double greatest)
{
    BarSlider* slider = addSlider(label, 0.0, greatest * kPercent, 0, QStringLiteral("%"));
    slider->setDefaultValue(static_cast<double>(model::LightSettings{}.*field) * kPercent);
    bind(slider, [slider, field](model::LightSettings& light) {
        light.*field = static_cast<float>(slider->value() / kPercent);
    });
    m_fractions.emplace_back(slider, field);
    return slider;
}

void LightDialog::buildPresets()
{
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(metrics::kGap);
    for (const model::LightPreset& preset : model::lightPresets()) {
        auto* button = new QPushButton(preset.titleText(), this);
        button->setAutoDefault(false);
        buttons->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, &preset] {
            commit([&preset](model::LightSettings& light) { light = preset.appliedTo(light); });
        });
    }
    rows().insertLayout(0, buttons);
}

QComboBox* LightDialog::addChoice(const QString& name, std::span<const model::NamedValue> values,
                                  const std::function<void(model::LightSettings&, int)>& set)
{
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(name, this);
    label->setProperty("role", QStringLiteral("label"));
    auto* box = new QComboBox(this);
    box->setAccessibleName(name);
    label->setBuddy(box);
    for (const model::NamedValue& value : values)
        box->addItem(value.titleText());
    row->addWidget(label);
    row->addStretch(1);
    row->addWidget(box);
    column().addLayout(row);
    connect(box, &QComboBox::activated, this,
            [this, set](int index) { commit([set, index](model::LightSettings& light) { set(light, index); }); });
    return box;
}

void LightDialog::buildChoices()
{
    m_surroundings =
        addChoice(tr("Surroundings"), model::surroundingsNames(), [](model::LightSettings& light, int index) {
            light.surroundings = static_cast<model::Surroundings>(index);
        });
    m_scattering =
        addChoice(tr("Hair scatters light by"), model::scatteringNames(), [](model::LightSettings& light, int index) {
            light.scattering = static_cast<model::Scattering>(index);
        });
}

Swatch* LightDialog::addSwatch(const QString& name, QLabel* beside)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    auto* label = new QLabel(name, this);
    label->setProperty("role", QStringLiteral("label"));
    auto* swatch = new Swatch(Qt::white, name, this);
    swatch->setCheckable(false);
    label->setBuddy(swatch);
    row->addWidget(label);
    row->addStretch(1);
    if (beside != nullptr)
        row->addWidget(beside);
    row->addWidget(swatch);
    column().addLayout(row);
    return swatch;
}

void LightDialog::buildColour()
{
    m_channels = new QLabel(this);
    m_channels->setProperty("role", QStringLiteral("dim"));
    m_colour = addSwatch(tr("Light colour"), m_channels);
    m_colour->setToolTip(
        tr("What colours the light of that temperature, as a gel before the lamp does. Click to choose it, right-click "
           "for white; R, G and B of the weather keys (F7) raise its parts, with Shift they lower "
           "them."));
    m_colour->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_colour, &Swatch::clicked, this, &LightDialog::chooseColour);
    connect(m_colour, &QWidget::customContextMenuRequested, this,
            [this] { commit([](model::LightSettings& light) { light.red = light.green = light.blue = 1.0F; }); });
}

void LightDialog::buildBackground()
{
    m_background = addSwatch(tr("Background"));
    connect(m_background, &Swatch::clicked, this, &LightDialog::chooseBackground);
}

void LightDialog::follow()
{
    const model::LightSettings& light = shown();
    m_colour->setColour(shownColour(light));
    const auto percent = [](float fraction) { return static_cast<int>(std::lround(100.0F * fraction)); };
    m_channels->setText(
        tr("R %1  G %2  B %3 %").arg(percent(light.red)).arg(percent(light.green)).arg(percent(light.blue)));
    m_background->setColour(QColor::fromRgb(document().project().background));
    // Each control ignores what it is told while the user moves it.
    const auto azimuth = static_cast<double>(light.azimuthRad);
    const auto elevation = static_cast<double>(light.elevationRad);
    ball().setDirection(DirectionBall::fromAngles(azimuth, elevation));
    m_azimuth->setValue(azimuth * kDegrees);
    m_elevation->setValue(elevation * kDegrees);
    m_temperature->setValue(static_cast<double>(light.temperatureK));
    m_surroundings->setCurrentIndex(static_cast<int>(light.surroundings));
    m_scattering->setCurrentIndex(static_cast<int>(light.scattering));
    for (const auto& [slider, field] : m_fractions)
        slider->setValue(static_cast<double>(light.*field) * kPercent);
}

void LightDialog::revert()
{
    m_backgroundEdit.drop();
    LiveValueDialog::revert();
}

void LightDialog::chooseColour()
{
    auto* dialog = new QColorDialog(shownColour(document().project().light), this);
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
    auto* dialog = new QColorDialog(QColor::fromRgb(document().project().background), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Background"));
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    const auto show = [this](const QColor& colour) {
        document().show(m_backgroundEdit, {.text = model::backgroundStepText()},
                        {.aspect = model::Change::Aspect::Environment},
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
