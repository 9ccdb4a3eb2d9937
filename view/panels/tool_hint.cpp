// Opens beside the button after Qt's own waiting time for tooltips.
#include "view/panels/tool_hint.h"

#include "view/look/theme.h"

#include <QEvent>
#include <QLabel>
#include <QScreen>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hairpaint::view {

ToolHint::ToolHint(QWidget* parent) : QFrame(parent, Qt::ToolTip), m_words(new QLabel(this)), m_demo(new ToolDemo(this))
{
    setObjectName(QStringLiteral("popup"));
    setAttribute(Qt::WA_ShowWithoutActivating);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    m_words->setTextFormat(Qt::RichText);
    m_words->setWordWrap(true);
    m_words->setFixedWidth(m_demo->sizeHint().width());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, metrics::kPadding);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    layout->addWidget(m_words);
    layout->addWidget(m_demo);
    hide();
}

void ToolHint::watch(QToolButton& button, const model::DemoStroke* demo)
{
    m_demos.insert(&button, demo);
    button.installEventFilter(this);
}

bool ToolHint::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::ToolTip:
        if (const auto* button = qobject_cast<QToolButton*>(watched)) {
            showFor(*button);
            return true;
        }
        break;
    case QEvent::Leave:
    case QEvent::Hide:
    case QEvent::MouseButtonPress:
    case QEvent::KeyPress:
    case QEvent::WindowDeactivate:
        hide();
        break;
    default:
        break;
    }
    return QFrame::eventFilter(watched, event);
}

void ToolHint::showFor(const QToolButton& button)
{
    const model::DemoStroke* demo = m_demos.value(&button);
    m_words->setText(button.toolTip());
    m_demo->setVisible(demo != nullptr);
    if (demo != nullptr)
        m_demo->setStroke(*demo);
    adjustSize();
    QPoint at = button.mapToGlobal(QPoint(button.width() + metrics::kGap, 0));
    if (const QScreen* screen = button.screen()) {
        const QRect room = screen->availableGeometry();
        at.setY(std::clamp(at.y(), room.top(), std::max(room.top(), room.bottom() - height())));
    }
    move(at);
    show();
}

} // namespace hairpaint::view
