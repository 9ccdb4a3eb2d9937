// Watches where the pointer enters.
#include "app/window/menus/pointed_area.h"

#include <QEvent>
#include <QWidget>

namespace hairpaint::app {

PointedArea::PointedArea(QWidget& head, QWidget& paint) : QObject(&head), m_head(head), m_paint(paint)
{
    head.installEventFilter(this);
    paint.installEventFilter(this);
}

bool PointedArea::isHead() const
{
    if (!m_head.isVisible() || !m_paint.isVisible())
        return m_head.isVisible();
    return m_wasHead;
}

bool PointedArea::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Enter)
        m_wasHead = watched == &m_head;
    return QObject::eventFilter(watched, event);
}

} // namespace hairpaint::app
