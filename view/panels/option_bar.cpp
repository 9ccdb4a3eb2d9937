// The settings of the active tool.
#include "view/panels/option_bar.h"

#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/look/value_text.h"
#include "view/widgets/action_button.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/map_badge.h"
#include "view/widgets/revealed_text.h"
#include "view/widgets/tool_setting_slider.h"
#include "view/widgets/value_pair.h"
#include "view/widgets/value_palette.h"

#include <QButtonGroup>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <utility>
#include <variant>

namespace hairpaint::view {

using model::MapSpec;
using model::ToolOption;
using model::ToolSettings;

namespace {

constexpr int kSliderWidth = 160; ///< Width of a slider where there is room, px.
constexpr int kValueWidth = 240;

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

/// The widget of one row: a slider, a switch, or a box with a button for each kind.
struct OptionBar::Option
{
    const ToolOption* row = nullptr;
    QWidget* widget = nullptr;
    BarSlider* slider = nullptr;
    std::vector<QToolButton*> buttons = {};
};

OptionBar::~OptionBar() = default;

OptionBar::OptionBar(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    setObjectName(QStringLiteral("optionBar"));
    setAttribute(Qt::WA_StyledBackground);
    setFixedHeight(metrics::kOptionBar);
    setAccessibleName(tr("Tool options"));
    m_row = new QHBoxLayout(this);
    m_row->setContentsMargins(metrics::kGap, 0, metrics::kGap, 1);
    m_row->setSpacing(metrics::kGap - 2);
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
    buildOptions();
    m_selectionBox = box(this);
    m_row->addWidget(m_selectionBox);
    m_row->addStretch(1);

    connect(&state.tools(), &ToolBox::activeChanged, this, &OptionBar::showOptions);
    connect(&state.tools(), &ToolBox::settingsChanged, this, &OptionBar::follow);
    connect(&state.target(), &EditTarget::changed, this, &OptionBar::follow);
    connect(&state.options(), &ViewOptions::changed, this, &OptionBar::follow);
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
    m_badge = new MapBadge(m_state.target().map(), m_valueBox);
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
        const model::MapKind map = m_state.target().map();
        settings.value(map).scalar = static_cast<float>(mapValue(m_state.target().settings(), map, shown));
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

void OptionBar::buildOptions()
{
    for (const auto& tool : m_state.tools().all()) {
        for (const ToolOption* row : tool->options()) {
            if (std::holds_alternative<model::ToolValue>(row->kind) ||
                std::ranges::find(m_options, row, &Option::row) != m_options.end())
                continue;
            Option& option = m_options.emplace_back(Option{.row = row});
            if (const auto* number = std::get_if<model::ToolNumber>(&row->kind))
                build(option, *number);
            else if (const auto* one = std::get_if<model::ToolSwitch>(&row->kind))
                build(option, *one);
            else if (const auto* choice = std::get_if<model::ToolChoice>(&row->kind))
                build(option, *choice);
        }
    }
}

void OptionBar::build(Option& option, const model::ToolNumber& number)
{
    auto* slider = new BarSlider(option.row->labelText(), this);
    slider->setRange(number.least, number.greatest, number.decimals);
    slider->setExponent(number.exponent);
    slider->setUnit(number.unitText());
    slider->setDefaultValue(number.standard);
    slider->setPreferredWidth(kSliderWidth);
    if (*option.row->hint != '\0')
        slider->setHint(option.row->hintText());
    bindToolSettings(*slider, m_state,
                     [row = option.row, perSi = number.shownPerSi()](ToolSettings& settings, double shown) {
                         putOption(settings, *row, shown / perSi);
                     });
    option.widget = option.slider = slider;
}

void OptionBar::build(Option& option, const model::ToolSwitch& one)
{
    QToolButton* button = toggle(QLatin1StringView(one.icon), option.row->labelText(), this);
    button->setProperty("switch", true);
    button->setIcon(switchIcon(QLatin1StringView(one.icon)));
    connect(button, &QToolButton::clicked, this, [this, row = option.row](bool on) { change(*row, on ? 1.0 : 0.0); });
    option.widget = button;
    option.buttons.push_back(button);
}

void OptionBar::build(Option& option, const model::ToolChoice& choice)
{
    option.widget = box(this);
    option.widget->layout()->setSpacing(0); // One choice.
    auto* group = new QButtonGroup(option.widget);
    for (const model::ToolChoice::Item& entry : choice.entries) {
        QToolButton* button = toggle(QLatin1StringView(entry.icon), entry.titleText(), option.widget);
        const auto index = static_cast<double>(option.buttons.size());
        connect(button, &QToolButton::clicked, this, [this, row = option.row, index] { change(*row, index); });
        group->addButton(button);
        option.widget->layout()->addWidget(button);
        option.buttons.push_back(button);
    }
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

void OptionBar::change(const ToolOption& option, double value)
{
    ToolSettings settings = m_state.tools().settings();
    putOption(settings, option, value);
    m_state.tools().setSettings(settings);
}

void OptionBar::showOptions()
{
    const model::Tool& tool = m_state.tools().active();
    m_toolIcon->setPixmap(
        iconPixmap(QLatin1String(tool.name()), metrics::kIcon, Theme::current().text, devicePixelRatioF()));
    m_toolName->setText(tool.title());
    m_revealed->setVisible(erases(m_state));
    m_selectionBox->setVisible(tool.traits().selects);
    // In the tool's own order, from behind the value on.
    for (const Option& option : m_options)
        m_row->removeWidget(option.widget);
    int at = m_row->indexOf(m_revealed) + 1;
    bool hasValue = false;
    QWidget* last = m_valueButton;
    const auto follows = [&last](QWidget* next) { setTabOrder(std::exchange(last, next), next); };
    for (const ToolOption* row : tool.options()) {
        hasValue = hasValue || std::holds_alternative<model::ToolValue>(row->kind);
        if (const auto option = std::ranges::find(m_options, row, &Option::row); option != m_options.end()) {
            m_row->insertWidget(at++, option->widget);
            if (option->slider != nullptr)
                follows(option->slider);
            for (QToolButton* button : option->buttons)
                follows(button);
        }
    }
    m_valueBox->setVisible(hasValue);
    follow();
}

void OptionBar::follow()
{
    followValue();
    const ToolSettings settings = m_state.tools().settings();
    const model::ToolTraits& tool = m_state.tools().active().traits();
    const model::ToolOptions rows = tool.options;
    for (const Option& option : m_options) {
        const ToolOption& row = *option.row;
        option.widget->setVisible(std::ranges::find(rows, &row) != rows.end() &&
                                  (row.isShown == nullptr || row.isShown(settings)));
        // There is nothing to choose for what always works on the skin.
        const bool isOfHair = &row == &model::kTouchOption;
        option.widget->setEnabled((row.isUsed == nullptr || row.isUsed(settings)) &&
                                  (!isOfHair || tool.worksOnHair == nullptr || tool.worksOnHair(settings)));
        const double value = optionOf(settings, row);
        if (const auto* number = std::get_if<model::ToolNumber>(&row.kind))
            option.slider->setValue(value * number->shownPerSi());
        else if (std::holds_alternative<model::ToolSwitch>(row.kind))
            option.buttons.front()->setChecked(value != 0.0);
        else
            for (std::size_t i = 0; i < option.buttons.size(); ++i)
                option.buttons[i]->setChecked(static_cast<double>(i) == value);
    }
}

void OptionBar::followValue()
{
    const MapSpec& spec = model::mapSpec(m_state.target().map());
    const sim::GroupSettings& group = m_state.target().settings();
    const model::PaintValue value = m_state.tools().settings().value(spec.kind);
    const std::pair stood(m_state.target().group(), spec.kind);
    if (std::exchange(m_stands, stood) != stood)
        m_scalar->release(); // From here on it shows another map's value.
    m_badge->setMap(spec.kind);
    const bool scalar = spec.scale != nullptr;
    m_scalar->setVisible(scalar);
    if (scalar) {
        const ValueUnit unit = valueUnit(group, spec.kind);
        m_scalar->setLabel(spec.titleText());
        m_scalar->setExponent(spec.scale->sliderExponent);
        m_scalar->setRange(unit.minimum, unit.maximum, unit.decimals);
        m_scalar->setUnit(unit.unit);
        m_scalar->setGradient(scaleGradient(spec, m_state.options().nightPaper()));
        m_scalar->setValue(shownValue(group, spec.kind, static_cast<double>(value.scalar)));
    }
    m_valueButton->setToolButtonStyle(scalar ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
    m_valueButton->setText(scalar ? QString() : valueText(group, spec, value));
    m_valueButton->setAccessibleName(tr("Palette, %1").arg(valueText(group, spec, value)));
    m_revealed->setText(revealedText(m_state));
}

void OptionBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_selectionBox != nullptr)
        showOptions();
}

void OptionBar::showPalette()
{
    ValuePalette::openUnder(*m_valueButton, m_state);
}

} // namespace hairpaint::view
