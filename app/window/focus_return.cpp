// Keys go to the dialog and back: see the header.
#include "app/window/focus_return.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QWindow>

namespace hairpaint::app {

FocusReturn::FocusReturn(QObject* parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool FocusReturn::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Show)
        if (auto* opened = qobject_cast<QDialog*>(watched);
            opened != nullptr && opened->isModal() && QGuiApplication::focusWindow() != nullptr)
            opened->activateWindow();
    const auto* dialog = event->type() == QEvent::Hide ? qobject_cast<QDialog*>(watched) : nullptr;
    // Qt has made it inactive by now, but has not heard yet where the keys go.
    const bool wasActive =
        dialog != nullptr && dialog->isWindow() && QGuiApplication::focusWindow() == dialog->windowHandle();
    if (wasActive && dialog->parentWidget() != nullptr)
        dialog->parentWidget()->window()->activateWindow();
    return QObject::eventFilter(watched, event);
}

} // namespace hairpaint::app
