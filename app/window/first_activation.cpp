// By event or by timer: see the header.
#include "app/window/first_activation.h"

#include <QEvent>
#include <QWidget>

namespace hairpaint::app {

namespace {

constexpr int kMostWaitMs = 1500;

} // namespace

FirstActivation::FirstActivation(QWidget& window, std::function<void()> begin)
{
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, [this, &window, begin = std::move(begin)] {
        window.removeEventFilter(this);
        begin();
    });
    window.installEventFilter(this);
    m_timer.start(window.isActiveWindow() ? 0 : kMostWaitMs);
}

bool FirstActivation::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::WindowActivate && m_timer.isActive())
        m_timer.start(0);
    return QObject::eventFilter(watched, event);
}

} // namespace hairpaint::app
