// The palettes of scalar, index, colour and vector maps.
#include "view/widgets/value_palette.h"

#include "model/maps/texel_ops.h"
#include "view/look/theme.h"
#include "view/look/value_text.h"
#include "view/widgets/action_button.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/hair_colours.h"
#include "view/widgets/hex_field.h"
#include "view/widgets/map_badge.h"
#include "view/widgets/melanin_sliders.h"
#include "view/widgets/scale_steps.h"
#include "view/widgets/swatch.h"
#include "view/widgets/tool_setting_slider.h"
#include "view/widgets/value_pair.h"

#include <QColorDialog>
#include <QFrame>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace hairpaint::view {

using model::MapKind;
using model::MapSpec;
using model::PaintValue;

namespace {

constexpr int kColourColumns = 10;
constexpr double kPercents = 100.0;
constexpr double kDegrees = 180.0 / std::numbers::pi; ///< A radian.
constexpr double kWholeTurnDeg = 360.0;

/// 0..360, from the map's right against the clock.
double angleDeg(glm::vec2 direction)
{
    const double degrees = std::atan2(static_cast<double>(direction.y), static_cast<double>(direction.x)) * kDegrees;
    return degrees < 0.0 ? degrees + kWholeTurnDeg : degrees;
}

/// Exact along the axes.
glm::vec2 directionAt(double degrees, double flatness)
{
    const auto exact = [](double value) { return std::abs(value) < 1e-9 ? 0.0 : value; };
    return {static_cast<float>(flatness * exact(std::cos(degrees / kDegrees))),
            static_cast<float>(flatness * exact(std::sin(degrees / kDegrees)))};
}

/// Nobody could tell them apart.
bool alike(const MapSpec& spec, const PaintValue& a, const PaintValue& b)
{
    constexpr int kStep = 131; ///< Half a step of eight bits.
    const int tolerance = model::texelOps(spec).continuous ? kStep : 0;
    const sim::Texel one = model::texelOf(spec, a);
    const sim::Texel other = model::texelOf(spec, b);
    return std::ranges::equal(one, other, [tolerance](std::uint16_t x, std::uint16_t y) {
        return std::abs(static_cast<int>(x) - static_cast<int>(y)) <= tolerance;
    });
}

} // namespace

ValuePalette::ValuePalette(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    setFocusPolicy(Qt::ClickFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSizeConstraint(QLayout::SetMinAndMaxSize);
    connect(&state.target(), &EditTarget::changed, this, &ValuePalette::refresh);
    connect(&state.tools(), &ToolBox::settingsChanged, this, &ValuePalette::refresh);
    connect(&state.options(), &ViewOptions::changed, this, [this] {
        m_builtFor.clear();
        refresh();
    });
    connect(&state.document(), &model::Document::changed, this, [this](const model::Change& change) {
        if (change.aspect == model::Change::Aspect::Settings || change.aspect == model::Change::Aspect::Everything)
            refresh();
    });
    refresh();
}

void ValuePalette::rebuild()
{
    delete m_body;
    m_swatches.clear();
    m_slider = nullptr;
    m_angle = nullptr;
    m_flatness = nullptr;
    m_melanin = nullptr;
    m_hex = nullptr;
    m_body = new QWidget(this);
    auto* column = new QVBoxLayout(m_body);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::kGap);

    const MapSpec& spec = model::mapSpec(m_state.target().map());
    auto* head = new QHBoxLayout;
    head->setSpacing(metrics::kGap);
    head->addWidget(new MapBadge(spec.kind, m_body));
    m_title = new QLabel(m_body);
    head->addWidget(m_title, 1);
    auto* swap = makeActionButton(QStringLiteral("swap"), tr("Swap the two values (X)"), m_body);
    auto* reset = makeActionButton(QStringLiteral("reset"), tr("Reset the two values (D)"), m_body);
    auto* pair = new ValuePair(m_state, m_body);
    connect(pair, &ValuePair::pickWanted, this, &ValuePalette::setSecond);
    head->addWidget(pair);
    head->addWidget(swap);
    head->addWidget(reset);
    column->addLayout(head);
    connect(swap, &QToolButton::clicked, this, [this] { swapValues(m_state); });
    connect(reset, &QToolButton::clicked, this, [this] { resetValues(m_state); });

    switch (spec.texel) {
    case model::TexelKind::Scalar:
        buildScalar(*column);
        break;
    case model::TexelKind::Index:
        buildIndex(*column);
        break;
    case model::TexelKind::Colour:
        buildColour(*column);
        break;
    case model::TexelKind::Vector:
        buildVector(*column);
        break;
    }
    layout()->addWidget(m_body);
}

void ValuePalette::refresh()
{
    const MapSpec& spec = model::mapSpec(m_state.target().map());
    const QString wanted = QLatin1String(spec.id) + rangeText(m_state.target().settings(), spec);
    if (wanted != m_builtFor) {
        m_builtFor = wanted;
        rebuild();
    }
    m_title->setText(m_second ? tr("%1, second value").arg(spec.titleText()) : spec.titleText());
    const PaintValue value = edited(spec.kind);
    bool marked = false;
    for (const auto& [swatch, its] : m_swatches) {
        const bool same = alike(spec, its, value);
        swatch->setChecked(same && !marked);
        marked = marked || same;
    }
    if (m_slider != nullptr)
        m_slider->setValue(shownValue(m_state.target().settings(), spec.kind, static_cast<double>(value.scalar)));
    if (m_angle != nullptr) {
        // Upright hair has no angle: the slider keeps the last one.
        if (glm::length(value.direction) > 0.0F)
            m_angle->setValue(angleDeg(value.direction));
        m_flatness->setValue(kPercents * static_cast<double>(glm::length(value.direction)));
    }
    if (m_melanin != nullptr)
        m_melanin->showColour(value.colour);
    if (m_hex != nullptr)
        m_hex->showColour(value.colour);
}

void ValuePalette::setSecond(bool second)
{
    for (BarSlider* slider : findChildren<BarSlider*>())
        slider->release(); // They stand for the other value from here on.
    m_second = second;
    refresh();
}

PaintValue& ValuePalette::edited(model::ToolSettings& settings, MapKind map) const
{
    return m_second ? settings.secondValue(map) : settings.value(map);
}

PaintValue ValuePalette::edited(MapKind map) const
{
    model::ToolSettings settings = m_state.tools().settings();
    return edited(settings, map);
}

void ValuePalette::setValue(const PaintValue& value)
{
    model::ToolSettings tools = m_state.tools().settings();
    edited(tools, m_state.target().map()) = value;
    m_state.tools().setSettings(tools);
    refresh();
}

ValuePalette* ValuePalette::openUnder(QWidget& anchor, EditorState& state, bool second)
{
    auto* popup = new QFrame(&anchor, Qt::Popup);
    popup->setObjectName(QStringLiteral("popup"));
    popup->setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(popup);
    column->setContentsMargins(metrics::kPadding, metrics::kPadding, metrics::kPadding, metrics::kPadding);
    auto* palette = new ValuePalette(state, popup);
    palette->setSecond(second);
    column->addWidget(palette);
    connect(palette, &ValuePalette::picked, popup, &QWidget::close);
    popup->adjustSize();
    const QRect screen = anchor.screen()->availableGeometry();
    QPoint corner = anchor.mapToGlobal(QPoint(0, anchor.height() + metrics::kGrid));
    if (corner.y() + popup->height() > screen.bottom())
        corner = anchor.mapToGlobal(QPoint(anchor.width() + metrics::kGap, anchor.height() - popup->height()));
    corner.setX(std::clamp(corner.x(), screen.left(), std::max(screen.left(), screen.right() - popup->width())));
    popup->move(corner);
    popup->show();
    palette->setFocus();
    return palette;
}

Swatch* ValuePalette::addSwatch(const PaintValue& value, const QString& name)
{
    auto* swatch = new Swatch(
        valueColour(model::mapSpec(m_state.target().map()), value, m_state.options().nightPaper()), name, m_body);
    m_swatches.emplace_back(swatch, value);
    connect(swatch, &Swatch::clicked, this, [this, value] {
        setValue(value);
        Q_EMIT picked();
    });
    return swatch;
}

void ValuePalette::buildScalar(QVBoxLayout& layout)
{
    const MapSpec& spec = model::mapSpec(m_state.target().map());
    const ValueUnit unit = valueUnit(m_state.target().settings(), spec.kind);
    m_slider = new BarSlider(tr("Value"), m_body);
    m_slider->setRange(unit.minimum, unit.maximum, unit.decimals);
    m_slider->setUnit(unit.unit);
    m_slider->setExponent(spec.scale->sliderExponent);
    m_slider->setGradient(scaleGradient(spec, m_state.options().nightPaper()));
    m_slider->setMinimumWidth(260);
    bindToolSettings(*m_slider, m_state, [this, kind = spec.kind](model::ToolSettings& settings, double shown) {
        edited(settings, kind).scalar = static_cast<float>(mapValue(m_state.target().settings(), kind, shown));
    });
    layout.addWidget(m_slider);
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    for (const double step : roundSteps(m_state.target().settings(), spec.kind)) {
        PaintValue value;
        value.scalar = static_cast<float>(mapValue(m_state.target().settings(), spec.kind, step));
        Swatch* swatch = addSwatch(value, valueText(m_state.target().settings(), spec, value));
        swatch->setCaption(QLocale().toString(step, 'g', 4));
        row->addWidget(swatch);
    }
    row->addStretch(1);
    layout.addLayout(row);
}

void ValuePalette::buildIndex(QVBoxLayout& layout)
{
    const MapSpec& spec = model::mapSpec(m_state.target().map());
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    for (std::size_t i = 0; i < spec.palette.size(); ++i) {
        PaintValue value;
        value.index = static_cast<int>(i);
        const QString name = spec.palette[i].titleText();
        Swatch* swatch = addSwatch(value, name);
        swatch->setCaption(name);
        row->addWidget(swatch);
    }
    row->addStretch(1);
    layout.addLayout(row);
}

void ValuePalette::buildVector(QVBoxLayout& layout)
{
    const auto slider = [&](const QString& label, double greatest, const QString& unit) {
        auto* made = new BarSlider(label, m_body);
        made->setRange(0.0, greatest);
        made->setUnit(unit);
        made->setMinimumWidth(260);
        layout.addWidget(made);
        bindToolSettings(*made, m_state, [this](model::ToolSettings& settings, double /*shown*/) {
            edited(settings, model::MapKind::Direction).direction =
                directionAt(m_angle->value(), m_flatness->value() / kPercents);
        });
        return made;
    };
    m_angle = slider(tr("Angle"), kWholeTurnDeg, QStringLiteral("°"));
    m_flatness = slider(tr("Flatness"), kPercents, QStringLiteral("%"));
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    constexpr double kFlat = 0.9;
    constexpr double kStepDeg = 45.0;
    const auto add = [&](const QString& caption, const QString& name, glm::vec2 direction) {
        PaintValue value;
        value.direction = direction;
        Swatch* swatch = addSwatch(value, name);
        swatch->setCaption(caption);
        row->addWidget(swatch);
    };
    const MapSpec& spec = model::mapSpec(m_state.target().map());
    add(QStringLiteral("·"), tr("Upright"), glm::vec2(0.0F));
    // Arrows against the clock from the map's right.
    for (int i = 0; const char16_t arrow : {u'→', u'↗', u'↑', u'↖', u'←', u'↙', u'↓', u'↘'}) {
        PaintValue value;
        value.direction = directionAt(kStepDeg * i++, kFlat);
        add(QChar(arrow), valueText(m_state.target().settings(), spec, value), value.direction);
    }
    row->addStretch(1);
    layout.addLayout(row);
}

void ValuePalette::buildColour(QVBoxLayout& layout)
{
    auto* grid = new QGridLayout;
    grid->setSpacing(2);
    int line = 0;
    for (const auto colours : {naturalHairColours(), redAndGreyHairColours(), fashionHairColours()}) {
        int column = 0;
        for (const HairColour& colour : colours) {
            PaintValue value;
            value.colour = QColor::fromRgb(colour.colour);
            grid->addWidget(addSwatch(value, hairColourName(colour)), line, column % kColourColumns);
            ++column;
        }
        ++line;
    }
    layout.addLayout(grid);
    const MapKind map = m_state.target().map();
    m_melanin = new MelaninSliders(
        m_state,
        [this, map](model::ToolSettings& settings, const QColor& colour) { edited(settings, map).colour = colour; },
        m_body);
    layout.addWidget(m_melanin);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    auto* label = new QLabel(tr("&Hex"), m_body);
    m_hex = new HexField(m_body);
    label->setBuddy(m_hex);
    connect(m_hex, &HexField::colourTyped, this, [this](const QColor& colour) {
        PaintValue value = edited(m_state.target().map());
        value.colour = colour;
        setValue(value);
    });
    auto* custom = new QPushButton(tr("Custom…"), m_body);
    connect(custom, &QPushButton::clicked, this, &ValuePalette::chooseColour);
    row->addWidget(label);
    row->addWidget(m_hex);
    row->addStretch(1);
    row->addWidget(custom);
    layout.addLayout(row);
}

void ValuePalette::chooseColour()
{
    // The popup, and this palette with it, is gone by the time that a colour is chosen.
    QWidget* host = window()->parentWidget() != nullptr ? window()->parentWidget()->window() : window();
    const MapKind map = m_state.target().map();
    auto* dialog = new QColorDialog(edited(map).colour, host);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Hair colour"));
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    connect(dialog, &QColorDialog::colorSelected, &m_state,
            [&state = m_state, second = m_second, map](const QColor& colour) {
                model::ToolSettings chosen = state.tools().settings();
                (second ? chosen.secondValue(map) : chosen.value(map)).colour = colour;
                state.tools().setSettings(chosen);
            });
    dialog->open();
    Q_EMIT picked();
}

void ValuePalette::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_X && event->modifiers() == Qt::NoModifier)
        swapValues(m_state);
    else if (event->key() == Qt::Key_D && event->modifiers() == Qt::NoModifier)
        resetValues(m_state);
    else
        QWidget::keyPressEvent(event);
}

} // namespace hairpaint::view
