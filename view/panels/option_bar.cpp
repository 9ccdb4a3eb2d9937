// The settings of the active tool.
#include "view/panels/option_bar.h"

#include "view/theme.h"
#include "view/widgets/action_button.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/icons.h"
#include "view/widgets/map_badge.h"
#include "view/widgets/revealed_text.h"
#include "view/widgets/tool_setting_slider.h"
#include "view/widgets/value_pair.h"
#include "view/widgets/value_palette.h"
#include "view/widgets/value_text.h"

#include <QButtonGroup>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

using model::GradientKind;
using model::MapSpec;
using model::ShapeKind;
using model::ToolOption;
using model::ToolSettings;

namespace {

constexpr double kCm = 100.0;
constexpr double kMm = 1000.0;
constexpr double kPercent = 100.0;
constexpr int kSliderWidth = 160; ///< Where there is room.
constexpr int kValueWidth = 240;

BarSlider* percentSlider(const QString& label, QWidget* parent)
{
    auto* slider = new BarSlider(label, parent);
    slider->setRange(0.0, kPercent);
    slider->setUnit(QStringLiteral("%"));
    slider->setPreferredWidth(kSliderWidth);
    return slider;
}

QToolButton* toggle(const QString& iconName, const QString& name, QWidget* parent)
{
    QToolButton* button = makeActionButton(iconName, name, parent);
    button->setCheckable(true);
    return button;
}

QWidget* box(QWidget* parent)
{
    auto* widget = new QWidget(parent);
    auto* layout = new QHBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::kGrid);
    return widget;
}

} // namespace

OptionBar::OptionBar(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    setObjectName(QStringLiteral("optionBar"));
    setAttribute(Qt::WA_StyledBackground);
    setFixedHeight(metrics::kOptionBar);
    setAccessibleName(tr("Tool options"));
    m_row = new QHBoxLayout(this);
    m_row->setContentsMargins(metrics::kPadding, 0, metrics::kPadding, 1);
    m_row->setSpacing(metrics::kGap);
    m_toolIcon = new QLabel(this);
    m_toolName = new QLabel(this);
    m_toolName->setMinimumWidth(56);
    m_row->addWidget(m_toolIcon);
    m_row->addWidget(m_toolName);
    auto* line = new QFrame(this);
    line->setObjectName(QStringLiteral("separator"));
    line->setFixedSize(1, metrics::kIcon);
    m_row->addWidget(line);
    m_revealed = new QLabel(this);
    m_revealed->setObjectName(QStringLiteral("revealed"));
    buildValue();
    m_row->addWidget(m_revealed);
    buildKinds();
    buildBrush();
    buildParting();
    m_selectionBox = box(this);
    m_row->addWidget(m_selectionBox);
    m_row->addStretch(1);

    connect(&state, &EditorState::activeToolChanged, this, &OptionBar::showOptions);
    connect(&state, &EditorState::toolSettingsChanged, this, &OptionBar::follow);
    connect(&state, &EditorState::targetChanged, this, &OptionBar::follow);
    connect(&state, &EditorState::viewOptionsChanged, this, &OptionBar::follow);
    connect(&state.document(), &model::Document::changed, this, [this](const model::Change& change) {
        using Aspect = model::Change::Aspect;
        if (change.aspect == Aspect::Settings || change.aspect == Aspect::LayerList ||
            change.aspect == Aspect::Everything)
            follow();
    });
    showOptions();
}

void OptionBar::buildValue()
{
    m_valueBox = box(this);
    m_badge = new MapBadge(m_state.activeMap(), m_valueBox);
    m_scalar = new BarSlider(tr("Value"), m_valueBox);
    m_scalar->setPreferredWidth(kValueWidth);
    m_valueButton = new QToolButton(m_valueBox);
    m_valueButton->setObjectName(QStringLiteral("valueButton"));
    m_valueButton->setIcon(icon(QStringLiteral("chevron-down")));
    m_valueButton->setIconSize(QSize(16, 16));
    // The arrow stands behind the text.
    m_valueButton->setLayoutDirection(Qt::RightToLeft);
    m_valueButton->setFixedHeight(metrics::kRow);
    m_valueButton->setFocusPolicy(Qt::TabFocus);
    m_valueButton->setToolTip(tr("Choose the value from the palette"));
    bindToolSettings(*m_scalar, m_state, [this](ToolSettings& settings, double shown) {
        const model::MapKind map = m_state.activeMap();
        settings.value(map).scalar = static_cast<float>(mapValue(m_state.activeSettings(), map, shown));
    });
    connect(m_valueButton, &QToolButton::clicked, this, &OptionBar::showPalette);
    m_valueBox->layout()->addWidget(m_badge);
    m_valueBox->layout()->addWidget(m_scalar);
    auto* pair = new ValuePair(m_state, m_valueBox);
    connect(pair, &ValuePair::pickWanted, this,
            [this, pair](bool second) { ValuePalette::openUnder(*pair, m_state, second); });
    m_valueBox->layout()->addWidget(pair);
    m_valueBox->layout()->addWidget(m_valueButton);
    m_row->addWidget(m_valueBox);
}

void OptionBar::buildBrush()
{
    m_size = new BarSlider(tr("Size"), this);
    m_size->setRange(0.1, 30.0, 1);
    m_size->setExponent(2.5);
    m_size->setUnit(tr("cm"));
    m_size->setDefaultValue(static_cast<double>(ToolSettings{}.brushSizeM) * kCm);
    m_size->setPreferredWidth(kSliderWidth);
    m_hardness = percentSlider(tr("Hardness"), this);
    m_hardness->setDefaultValue(static_cast<double>(ToolSettings{}.hardness) * kPercent);
    m_opacity = percentSlider(tr("Opacity"), this);
    m_opacity->setDefaultValue(kPercent);
    m_tolerance = percentSlider(tr("Tolerance"), this);
    m_tolerance->setDefaultValue(static_cast<double>(ToolSettings{}.fillTolerance) * kPercent);
    bindToolSettings(*m_size, m_state,
                     [](ToolSettings& settings, double cm) { settings.brushSizeM = static_cast<float>(cm / kCm); });
    m_flatness = percentSlider(tr("Flatness"), this);
    m_flatness->setDefaultValue(static_cast<double>(ToolSettings{}.flatness) * kPercent);
    m_flatness->setToolTip(tr("How flat combed hair lies; pen pressure makes it less"));
    m_lift = percentSlider(tr("Lift"), this);
    m_lift->setRange(-kPercent, kPercent);
    m_lift->setDefaultValue(static_cast<double>(ToolSettings{}.lift) * kPercent);
    m_lift->setToolTip(tr("How far hair is raised from where it lies; below zero it is laid flatter"));
    m_grabGel = percentSlider(tr("Gel at least"), this);
    m_grabGel->setDefaultValue(static_cast<double>(ToolSettings{}.grabGel) * kPercent);
    m_grabGel->setToolTip(tr("The gel that keeps hair where it was pulled; long hair falls back without"));
    m_holdGel = percentSlider(tr("Gel at least"), this);
    m_holdGel->setDefaultValue(static_cast<double>(ToolSettings{}.holdGel) * kPercent);
    m_holdGel->setToolTip(tr("The gel that keeps held hair as it lies"));
    const auto bind = [this](BarSlider* slider, float ToolSettings::*field) {
        bindToolSettings(*slider, m_state, [field](ToolSettings& settings, double percent) {
            settings.*field = static_cast<float>(percent / kPercent);
        });
    };
    bind(m_hardness, &ToolSettings::hardness);
    bind(m_opacity, &ToolSettings::opacity);
    bind(m_tolerance, &ToolSettings::fillTolerance);
    bind(m_flatness, &ToolSettings::flatness);
    bind(m_lift, &ToolSettings::lift);
    bind(m_holdGel, &ToolSettings::holdGel);
    bind(m_grabGel, &ToolSettings::grabGel);

    m_pressureBox = box(this);
    m_pressureSize = toggle(QStringLiteral("pressure-size"), tr("Pen pressure changes the size"), m_pressureBox);
    m_pressureOpacity =
        toggle(QStringLiteral("pressure-opacity"), tr("Pen pressure changes the opacity"), m_pressureBox);
    for (const auto& [button, name] :
         {std::pair(m_pressureSize, "pressure-size"), std::pair(m_pressureOpacity, "pressure-opacity")}) {
        button->setProperty("switch", true);
        button->setIcon(switchIcon(QLatin1StringView(name)));
    }
    connect(m_pressureSize, &QToolButton::clicked, this,
            [this](bool on) { change([on](ToolSettings& settings) { settings.pressureSize = on; }); });
    connect(m_pressureOpacity, &QToolButton::clicked, this,
            [this](bool on) { change([on](ToolSettings& settings) { settings.pressureOpacity = on; }); });
    m_pressureBox->layout()->addWidget(m_pressureSize);
    m_pressureBox->layout()->addWidget(m_pressureOpacity);
    for (BarSlider* slider : {m_size, m_hardness, m_opacity, m_tolerance, m_flatness, m_lift, m_holdGel, m_grabGel})
        m_row->addWidget(slider);
    m_row->addWidget(m_pressureBox);
}

void OptionBar::buildParting()
{
    const auto make = [this](const QString& label, const QString& unit, double perMetre, float ToolSettings::*field) {
        auto* slider = new BarSlider(label, this);
        slider->setUnit(unit);
        slider->setPreferredWidth(kSliderWidth);
        bindToolSettings(*slider, m_state, [field, perMetre](ToolSettings& settings, double shown) {
            settings.*field = static_cast<float>(shown / perMetre);
        });
        slider->setDefaultValue(static_cast<double>(ToolSettings{}.*field) * perMetre);
        m_row->addWidget(slider);
        return slider;
    };
    m_reach = make(tr("Reach"), tr("cm"), kCm, &ToolSettings::partReachM);
    m_reach->setRange(1.0, 20.0, 1);
    m_reach->setHint(tr("How far to either side the part lays hair"));
    m_gap = make(tr("Gap"), tr("mm"), kMm, &ToolSettings::partGapM);
    m_gap->setRange(0.0, 10.0, 1);
    m_gap->setExponent(2.0);
    m_gap->setHint(tr("How wide a line of skin shows; 0 leaves every hair"));
    m_zigzag = make(tr("Zigzag"), tr("mm"), kMm, &ToolSettings::partZigzagM);
    m_zigzag->setRange(0.0, 10.0, 1);
    m_zigzag->setHint(tr("How far the part runs to and fro; 0 leaves it straight"));
}

void OptionBar::buildKinds()
{
    const auto kinds = [this](QWidget*& parent, std::vector<QToolButton*>& buttons,
                              const std::vector<std::pair<QString, QString>>& names, auto set) {
        parent = box(this);
        auto* group = new QButtonGroup(parent);
        for (std::size_t i = 0; i < names.size(); ++i) {
            QToolButton* button = toggle(names[i].first, names[i].second, parent);
            connect(button, &QToolButton::clicked, this,
                    [this, i, set] { change([&](ToolSettings& settings) { set(settings, static_cast<int>(i)); }); });
            group->addButton(button);
            parent->layout()->addWidget(button);
            buttons.push_back(button);
        }
        m_row->addWidget(parent);
    };
    kinds(m_shapeBox, m_shapes,
          {{QStringLiteral("shape-rectangle"), tr("Rectangle")},
           {QStringLiteral("shape-ellipse"), tr("Ellipse")},
           {QStringLiteral("shape-polygon"), tr("Polygon")}},
          [](ToolSettings& settings, int kind) { settings.shape = static_cast<ShapeKind>(kind); });
    kinds(m_gradientBox, m_gradients,
          {{QStringLiteral("gradient-linear"), tr("Linear gradient")},
           {QStringLiteral("gradient-radial"), tr("Radial gradient")}},
          [](ToolSettings& settings, int kind) { settings.gradient = static_cast<GradientKind>(kind); });
    kinds(m_combBox, m_combs,
          {{QStringLiteral("comb"), tr("Comb along the stroke")},
           {QStringLiteral("comb-lift"), tr("Lift or lay, the way hair lies")},
           {QStringLiteral("comb-smooth"), tr("Smooth")},
           {QStringLiteral("comb-noise"), tr("Ruffle")},
           {QStringLiteral("comb-whorl"), tr("Whorl: a spiral around the pointer")},
           {QStringLiteral("comb-hold"), tr("Hold as it lies now, with gel")}},
          [](ToolSettings& settings, int kind) { settings.comb = static_cast<model::CombKind>(kind); });
}

void OptionBar::addSelectionAction(QAction* action)
{
    auto* button = new QToolButton(m_selectionBox);
    button->setProperty("boxed", true);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setDefaultAction(action);
    button->setFixedHeight(metrics::kSlider);
    button->setFocusPolicy(Qt::TabFocus);
    m_selectionBox->layout()->addWidget(button);
}

void OptionBar::change(const std::function<void(ToolSettings&)>& edit)
{
    ToolSettings settings = m_state.toolSettings();
    edit(settings);
    m_state.setToolSettings(settings);
}

void OptionBar::showOptions()
{
    const model::Tool& tool = m_state.activeTool();
    const std::vector<ToolOption> options = tool.options();
    const auto has = [&options](ToolOption option) { return std::ranges::find(options, option) != options.end(); };
    m_toolIcon->setPixmap(iconPixmap(QLatin1String(model::toolName(tool.id())), metrics::kIcon, Theme::current().text,
                                     devicePixelRatioF()));
    m_toolName->setText(tool.title());
    m_valueBox->setVisible(has(ToolOption::Value));
    m_size->setVisible(has(ToolOption::Size));
    m_hardness->setVisible(has(ToolOption::Hardness));
    m_opacity->setVisible(has(ToolOption::Opacity));
    m_pressureBox->setVisible(has(ToolOption::Pressure));
    m_shapeBox->setVisible(has(ToolOption::ShapeKind));
    m_gradientBox->setVisible(has(ToolOption::GradientKind));
    m_tolerance->setVisible(has(ToolOption::FillTolerance));
    m_combBox->setVisible(has(ToolOption::CombKind));
    m_reach->setVisible(has(ToolOption::PartReach));
    m_gap->setVisible(has(ToolOption::PartGap));
    m_zigzag->setVisible(has(ToolOption::Zigzag));
    m_revealed->setVisible(erases(m_state));
    m_selectionBox->setVisible(tool.id() == model::ToolId::Select);
    follow();
}

void OptionBar::follow()
{
    ToolSettings settings = m_state.toolSettings();
    const MapSpec& spec = model::mapSpec(m_state.activeMap());
    const sim::GroupSettings& group = m_state.activeSettings();
    const model::PaintValue& value = settings.value(spec.kind);
    const std::pair stood(m_state.activeGroup(), spec.kind);
    if (std::exchange(m_stands, stood) != stood)
        m_scalar->release(); // It stands for another map's value from here on.
    m_badge->setMap(spec.kind);
    const bool scalar = spec.scale != nullptr;
    m_scalar->setVisible(scalar);
    if (scalar) {
        const ValueUnit unit = valueUnit(group, spec.kind);
        m_scalar->setLabel(spec.titleText());
        m_scalar->setExponent(spec.scale->sliderExponent);
        m_scalar->setRange(unit.minimum, unit.maximum, unit.decimals);
        m_scalar->setUnit(unit.unit);
        m_scalar->setGradient(scaleGradient(spec, m_state.nightPaper()));
        m_scalar->setValue(shownValue(group, spec.kind, static_cast<double>(value.scalar)));
    }
    m_valueButton->setToolButtonStyle(scalar ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
    m_valueButton->setText(scalar ? QString() : valueText(group, spec, value));
    m_valueButton->setAccessibleName(tr("Palette, %1").arg(valueText(group, spec, value)));
    m_revealed->setText(revealedText(m_state));
    m_size->setValue(static_cast<double>(settings.brushSizeM) * kCm);
    m_hardness->setValue(static_cast<double>(settings.hardness) * kPercent);
    m_opacity->setValue(static_cast<double>(settings.opacity) * kPercent);
    m_tolerance->setValue(static_cast<double>(settings.fillTolerance) * kPercent);
    m_flatness->setValue(static_cast<double>(settings.flatness) * kPercent);
    m_reach->setValue(static_cast<double>(settings.partReachM) * kCm);
    m_gap->setValue(static_cast<double>(settings.partGapM) * kMm);
    m_zigzag->setValue(static_cast<double>(settings.partZigzagM) * kMm);
    m_holdGel->setValue(static_cast<double>(settings.holdGel) * kPercent);
    m_grabGel->setValue(static_cast<double>(settings.grabGel) * kPercent);
    m_lift->setValue(static_cast<double>(settings.lift) * kPercent);
    const std::vector<ToolOption> options = m_state.activeTool().options();
    const auto has = [&options](ToolOption option) { return std::ranges::find(options, option) != options.end(); };
    const auto combs = [&](model::CombKind kind) { return has(ToolOption::CombKind) && settings.comb == kind; };
    m_flatness->setVisible(has(ToolOption::Flatness) && !combs(model::CombKind::Hold) && !combs(model::CombKind::Lift));
    m_holdGel->setVisible(combs(model::CombKind::Hold));
    m_lift->setVisible(combs(model::CombKind::Lift));
    m_grabGel->setVisible(has(ToolOption::GrabGel));
    m_flatness->setEnabled(!has(ToolOption::CombKind) ||
                           (settings.comb != model::CombKind::Smooth && settings.comb != model::CombKind::Noise));
    m_pressureSize->setChecked(settings.pressureSize);
    m_pressureOpacity->setChecked(settings.pressureOpacity);
    for (std::size_t i = 0; i < m_shapes.size(); ++i)
        m_shapes[i]->setChecked(i == static_cast<std::size_t>(settings.shape));
    for (std::size_t i = 0; i < m_gradients.size(); ++i)
        m_gradients[i]->setChecked(i == static_cast<std::size_t>(settings.gradient));
    for (std::size_t i = 0; i < m_combs.size(); ++i)
        m_combs[i]->setChecked(i == static_cast<std::size_t>(settings.comb));
}

void OptionBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_gradientBox != nullptr && m_size != nullptr)
        showOptions();
}

void OptionBar::showPalette()
{
    ValuePalette::openUnder(*m_valueButton, m_state);
}

} // namespace hairpaint::view
