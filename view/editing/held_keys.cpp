// Remembers which watched keys are down.
#include "view/editing/held_keys.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

#include <utility>

namespace hairpaint::view {

HeldKeys::HeldKeys(QSet<int> watched, QObject* parent) : QObject(parent), m_watched(std::move(watched))
{
    qApp->installEventFilter(this);
}

bool HeldKeys::eventFilter(QObject* watched, QEvent* event)
{
    const QEvent::Type type = event->type();
    if (type == QEvent::KeyPress || type == QEvent::KeyRelease || type == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (m_watched.contains(key->key()) && !key->isAutoRepeat()) {
            const QWidget* focus = QApplication::focusWidget();
            const bool writing = focus != nullptr && focus->testAttribute(Qt::WA_InputMethodEnabled);
            const bool held = type != QEvent::KeyRelease && !writing;
            if (held != m_held.contains(key->key())) {
                if (held)
                    m_held.insert(key->key());
                else
                    m_held.remove(key->key());
                Q_EMIT changed();
            }
        }
    } else if (type == QEvent::ApplicationStateChange || type == QEvent::ApplicationDeactivate) {
        if (!m_held.isEmpty()) {
            m_held.clear();
            Q_EMIT changed();
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace hairpaint::view
