// The column of tools.
#include "view/panels/tool_bar.h"

#include "view/theme.h"
#include "view/widgets/icons.h"
#include "view/widgets/value_pair.h"
#include "view/widgets/value_palette.h"

#include <QAction>
#include <QButtonGroup>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hairpaint::view {

namespace {

QToolButton* makeTarget(QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setIconSize(QSize(metrics::kIcon, metrics::kIcon));
    button->setFixedSize(metrics::kTarget, metrics::kTarget);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

void describe(QToolButton& button, const QString& title, const QKeySequence& key)
{
    button.setAccessibleName(title);
    button.setToolTip(key.isEmpty() ? title
                                    : QStringLiteral("%1 (%2)").arg(title, key.toString(QKeySequence::NativeText)));
}

} // namespace

ToolBar::ToolBar(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    setObjectName(QStringLiteral("toolBar"));
    setAttribute(Qt::WA_StyledBackground);
    setFixedWidth(metrics::kToolBar);
    setAccessibleName(tr("Tools"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kGrid, metrics::kGrid, metrics::kGrid, metrics::kGap);
    layout->setSpacing(2);
    auto* group = new QButtonGroup(this);
    for (const auto& tool : state.tools()) {
        QToolButton* button = makeTarget(this);
        button->setCheckable(true);
        button->setIcon(icon(QLatin1String(model::toolName(tool->id()))));
        describe(*button, tool->title(), tool->defaultKey());
        connect(button, &QToolButton::clicked, this, [this, id = tool->id()] { m_state.setActiveTool(id); });
        group->addButton(button);
        layout->addWidget(button);
        m_buttons.push_back(button);
    }
    layout->addSpacing(metrics::kGap);
    auto* values = new ValuePair(state, this);
    connect(values, &ValuePair::pickWanted, this,
            [this, values](bool second) { ValuePalette::openUnder(*values, m_state, second); });
    layout->addWidget(values, 0, Qt::AlignHCenter);
    layout->addStretch(1);
    m_foot = new QVBoxLayout;
    m_foot->setSpacing(2);
    layout->addLayout(m_foot);
    connect(&state, &EditorState::activeToolChanged, this, &ToolBar::follow);
    follow();
}

void ToolBar::setAction(model::ToolId tool, const QAction& action)
{
    const auto found = std::ranges::find(m_state.tools(), tool, [](const auto& one) { return one->id(); });
    Q_ASSERT(found != m_state.tools().end());
    QToolButton* button = m_buttons[static_cast<std::size_t>(found - m_state.tools().begin())];
    const auto follow = [button, title = (*found)->title(), &action] { describe(*button, title, action.shortcut()); };
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
    m_foot->addWidget(button);
}

void ToolBar::follow()
{
    const model::Tool* active = &m_state.activeTool();
    for (std::size_t i = 0; i < m_buttons.size(); ++i)
        m_buttons[i]->setChecked(m_state.tools()[i].get() == active);
}

} // namespace hairpaint::view
