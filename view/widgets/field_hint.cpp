// Where a field's sentence stands, and when it goes.
#include "view/widgets/field_hint.h"

#include "view/look/theme.h"

#include <QAccessible>
#include <QCoreApplication>
#include <QEvent>
#include <QScreen>
#include <QStyle>

#include <algorithm>

namespace hairpaint::view {

namespace {

constexpr int kNarrowestHint = 180; ///< Least width of a hint, under a short field, px.
constexpr int kWidestHint = 320;    ///< Greatest width of a hint, px.

void repolishHint(QWidget& widget)
{
    widget.style()->unpolish(&widget);
    widget.style()->polish(&widget);
}

} // namespace

FieldHint::FieldHint(QWidget& field) : QLabel(&field, Qt::ToolTip)
{
    setObjectName(QStringLiteral("fieldHint"));
    setAttribute(Qt::WA_ShowWithoutActivating);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setFont(themeFont(TextRole::Label));
}

FieldHint* FieldHint::of(const QWidget& field)
{
    return field.findChild<FieldHint*>(QString(), Qt::FindDirectChildrenOnly);
}

void FieldHint::showAt(QWidget& field, const QString& sentence, Tone tone)
{
    FieldHint* hint = of(field);
    if (hint == nullptr)
        hint = new FieldHint(field);
    hint->setText(sentence);
    hint->setProperty("problem", tone == Tone::Problem);
    repolishHint(*hint);
    hint->reposition();
    hint->show();
    // Not before the press or the key that made it appear is over.
    QMetaObject::invokeMethod(
        hint, [hint] { QCoreApplication::instance()->installEventFilter(hint); }, Qt::QueuedConnection);
    QAccessibleEvent spoken(hint, QAccessible::Alert);
    QAccessible::updateAccessibility(&spoken);
}

void FieldHint::hideAt(const QWidget& field)
{
    if (FieldHint* hint = of(field)) {
        QCoreApplication::instance()->removeEventFilter(hint);
        hint->hide();
    }
}

QString FieldHint::textAt(const QWidget& field)
{
    const FieldHint* hint = of(field);
    return hint != nullptr && hint->isVisible() ? hint->text() : QString();
}

void FieldHint::reposition()
{
    const QWidget& field = *parentWidget();
    setFixedWidth(std::clamp(field.width(), kNarrowestHint, kWidestHint));
    adjustSize();
    const QRect screen = field.screen()->availableGeometry();
    QPoint corner = field.mapToGlobal(QPoint(0, field.height() + 2));
    if (corner.y() + height() > screen.bottom())
        corner.setY(field.mapToGlobal(QPoint(0, -height() - 2)).y());
    corner.setX(std::clamp(corner.x(), screen.left(), std::max(screen.left(), screen.right() - width())));
    move(corner);
}

bool FieldHint::eventFilter(QObject* /*watched*/, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::KeyPress:
    case QEvent::Wheel:
    case QEvent::WindowDeactivate:
    case QEvent::ApplicationStateChange:
        hideAt(*parentWidget());
        break;
    default:
        break;
    }
    return false;
}

void markRefused(QWidget& edit, bool refused)
{
    if (edit.property("refused").toBool() == refused)
        return;
    edit.setProperty("refused", refused);
    repolishHint(edit);
}

} // namespace hairpaint::view
