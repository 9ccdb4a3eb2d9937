// A row over the foot of the strip.
#include "view/panels/style_question.h"

#include "view/look/theme.h"

#include <QAccessible>
#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

namespace hairpaint::view {

StyleQuestion::StyleQuestion(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("styleQuestion"));
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(metrics::kPadding, metrics::kGrid, metrics::kPadding, metrics::kGrid);
    row->setSpacing(metrics::kGap);
    m_text = new QLabel(this);
    m_text->setWordWrap(true);
    row->addWidget(m_text, 1);
    m_keep = new QPushButton(tr("&Keep mine"), this);
    m_replace = new QPushButton(tr("&Replace mine"), this);
    auto* cancel = new QPushButton(tr("Cancel"), this);
    m_keep->setToolTip(tr("Esc. The rest of the style is put on"));
    m_replace->setToolTip(tr("The style's own takes its place; undo brings it back"));
    cancel->setToolTip(tr("All hair stays as it was"));
    m_buttons = {m_keep, m_replace, cancel};
    for (QPushButton* button : m_buttons) {
        row->addWidget(button);
        button->installEventFilter(this);
    }
    connect(m_keep, &QPushButton::clicked, this, &StyleQuestion::keepChosen);
    connect(m_replace, &QPushButton::clicked, this, &StyleQuestion::replaceChosen);
    connect(cancel, &QPushButton::clicked, this, &StyleQuestion::cancelChosen);
    hide();
}

void StyleQuestion::ask(const QString& style, const QStringList& groups)
{
    const QString names = QLocale().createSeparatedList(groups);
    m_text->setText(tr("'%1' brings its own %2. Replace yours?").arg(style, names));
    setAccessibleName(m_text->text());
    if (!isVisible())
        m_focusBefore = QApplication::focusWidget();
    const int height = sizeHint().height();
    setGeometry(0, parentWidget()->height() - height, parentWidget()->width(), height);
    show();
    raise();
    m_keep->setFocus();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void StyleQuestion::close()
{
    if (isHidden())
        return;
    const bool hadFocus = isAncestorOf(QApplication::focusWidget());
    hide();
    if (hadFocus && m_focusBefore != nullptr)
        m_focusBefore->setFocus();
    m_focusBefore.clear();
}

void StyleQuestion::step(int by)
{
    const qsizetype at = m_buttons.indexOf(qobject_cast<QPushButton*>(focusWidget())) + by + m_buttons.size();
    m_buttons.at(at % m_buttons.size())->setFocus(Qt::TabFocusReason);
}

bool StyleQuestion::eventFilter(QObject* watched, QEvent* event)
{
    const bool isPress = event->type() == QEvent::KeyPress;
    if (!isPress && event->type() != QEvent::ShortcutOverride)
        return QWidget::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Escape:
        if (isPress)
            Q_EMIT keepChosen();
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (isPress)
            static_cast<QPushButton*>(watched)->click();
        break;
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (isPress)
            step(static_cast<QKeyEvent*>(event)->key() == Qt::Key_Right ? 1 : -1);
        break;
    default:
        return QWidget::eventFilter(watched, event);
    }
    event->accept();
    return true;
}

} // namespace hairpaint::view
