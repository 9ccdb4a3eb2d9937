// Enter, Esc and leaving a number that is typed.
#include "view/widgets/number_edit.h"

#include "view/widgets/field_hint.h"

#include <QKeyEvent>

#include <utility>

namespace hairpaint::view {

NumberEdit::NumberEdit(const QString& text, NumberField field, QWidget* host)
    : QLineEdit(text, host), m_field(std::move(field)), m_opened(text)
{
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setFrame(false);
    setProperty("inBar", true);
    selectAll();
    connect(this, &QLineEdit::textEdited, this, [this] {
        markRefused(*this, false);
        FieldHint::hideAt(*parentWidget());
        setAccessibleDescription({});
    });
}

void NumberEdit::enter()
{
    if (text() == m_opened) {
        leave(false);
        return;
    }
    const tl::expected<double, QString> value = readNumber(text(), m_field);
    if (value) {
        leave(true);
        return;
    }
    markRefused(*this, true);
    setAccessibleDescription(value.error());
    FieldHint::showAt(*parentWidget(), value.error(), FieldHint::Tone::Problem);
}

void NumberEdit::leave(bool keep)
{
    if (std::exchange(m_isOver, true))
        return;
    FieldHint::hideAt(*parentWidget());
    QString problem;
    if (keep && text() != m_opened) {
        const tl::expected<double, QString> value = readNumber(text(), m_field);
        if (value)
            Q_EMIT entered(*value);
        else
            problem = value.error();
    }
    Q_EMIT left(problem);
}

bool NumberEdit::event(QEvent* event)
{
    // Enter and Esc are the field's, whatever else the window uses them for.
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter) {
            event->accept();
            return true;
        }
    }
    return QLineEdit::event(event);
}

void NumberEdit::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        enter();
        event->accept();
        break;
    case Qt::Key_Escape:
        leave(false);
        event->accept();
        break;
    default:
        QLineEdit::keyPressEvent(event);
    }
}

void NumberEdit::focusOutEvent(QFocusEvent* event)
{
    QLineEdit::focusOutEvent(event);
    // Its own context menu and another program's window are no other field.
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason)
        leave(true);
}

} // namespace hairpaint::view
