// The column of tools.
#include "view/panels/tool_bar.h"

#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/panels/tool_hint.h"
#include "view/widgets/value_pair.h"
#include "view/widgets/value_palette.h"

#include <QAction>
#include <QButtonGroup>
#include <QGridLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kSpacing = 2;

QToolButton* makeTarget(QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setIconSize(QSize(metrics::kIcon, metrics::kIcon));
    button->setFixedSize(metrics::kTarget, metrics::kTarget);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

/// `sentences`: below the title, each on a line.
void describe(QToolButton& button, const QString& title, const QKeySequence& key, const QStringList& sentences = {})
{
    button.setAccessibleName(title);
    button.setAccessibleDescription(sentences.join(QLatin1Char(' ')));
    const QString named =
        key.isEmpty() ? title : QStringLiteral("%1 (%2)").arg(title, key.toString(QKeySequence::NativeText));
    if (sentences.isEmpty()) {
        button.setToolTip(named);
        return;
    }
    QString tip = QStringLiteral("<b>%1</b>").arg(named.toHtmlEscaped());
    for (const QString& sentence : sentences)
        tip += QStringLiteral("<br>") + sentence.toHtmlEscaped();
    button.setToolTip(tip);
}

} // namespace

ToolBar::ToolBar(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    setObjectName(QStringLiteral("toolBar"));
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Tools"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kGrid, metrics::kGrid, metrics::kGrid, metrics::kGap);
    layout->setSpacing(kSpacing);
    m_tools = new QGridLayout;
    m_tools->setSpacing(kSpacing);
    layout->addLayout(m_tools);
    auto* hint = new ToolHint(this);
    auto* group = new QButtonGroup(this);
    for (const auto& tool : state.tools().all()) {
        QToolButton* button = makeTarget(this);
        button->setCheckable(true);
        button->setIcon(icon(QLatin1String(tool->name())));
        describe(*button, tool->title(), tool->traits().key, {tool->purpose(), tool->hint()});
        connect(button, &QToolButton::clicked, this, [this, id = tool->id()] { m_state.tools().choose(id); });
        hint->watch(*button, tool->traits().demo);
        group->addButton(button);
        m_buttons.push_back(button);
    }
    layout->addSpacing(metrics::kGap);
    auto* values = new ValuePair(state, this);
    connect(values, &ValuePair::pickWanted, this,
            [this, values](bool second) { ValuePalette::openUnder(*values, m_state, second); });
    layout->addWidget(values, 0, Qt::AlignHCenter);
    layout->addStretch(1);
    m_foot = new QGridLayout;
    m_foot->setSpacing(kSpacing);
    layout->addLayout(m_foot);
    arrange(1);
    connect(&state.tools(), &ToolBox::activeChanged, this, &ToolBar::follow);
    follow();
}

void ToolBar::setAction(model::ToolId tool, const QAction& action)
{
    const auto found = std::ranges::find(m_state.tools().all(), tool, [](const auto& one) { return one->id(); });
    Q_ASSERT(found != m_state.tools().all().end());
    QToolButton* button = m_buttons[static_cast<std::size_t>(found - m_state.tools().all().begin())];
    const auto follow = [button, &tool = **found, &action] {
        describe(*button, tool.title(), action.shortcut(), {tool.purpose(), tool.hint()});
    };
    connect(&action, &QAction::changed, button, follow);
    follow();
}

void ToolBar::addFootAction(QAction* action)
{
    QToolButton* button = makeTarget(this);
    button->setProperty("switch", true);
    button->setDefaultAction(action);
    const auto follow = [button, action] { describe(*button, action->iconText(), action->shortcut()); };
    connect(action, &QAction::changed, button, follow);
    follow();
    m_footButtons.push_back(button);
    arrange(std::exchange(m_columns, 0));
}

int ToolBar::heightOf(int columns) const
{
    const auto rows = [columns](std::size_t buttons) { return (static_cast<int>(buttons) + columns - 1) / columns; };
    const QMargins margins = layout()->contentsMargins();
    return margins.top() + margins.bottom() +
           (rows(m_buttons.size()) + rows(m_footButtons.size())) * (metrics::kTarget + kSpacing) + 2 * metrics::kGap +
           findChild<ValuePair*>()->sizeHint().height();
}

void ToolBar::arrange(int columns)
{
    if (columns == m_columns)
        return;
    m_columns = columns;
    for (const auto& [grid, buttons] : {std::pair(m_tools, &m_buttons), std::pair(m_foot, &m_footButtons)})
        for (std::size_t i = 0; i < buttons->size(); ++i)
            grid->addWidget((*buttons)[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
    setFixedWidth(metrics::kToolBar + (columns - 1) * (metrics::kTarget + kSpacing));
}

QSize ToolBar::minimumSizeHint() const
{
    return {metrics::kToolBar, heightOf(2)};
}

void ToolBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange(height() < heightOf(1) ? 2 : 1);
}

void ToolBar::follow()
{
    const model::Tool* active = &m_state.tools().active();
    for (std::size_t i = 0; i < m_buttons.size(); ++i)
        m_buttons[i]->setChecked(m_state.tools().all()[i].get() == active);
}

} // namespace hairpaint::view
