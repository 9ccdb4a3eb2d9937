// A frame of the accent's colour.
#include "view/widgets/focus_ring.h"

#include "view/look/theme.h"

#include <QEvent>
#include <QFocusEvent>
#include <QPainter>

namespace hairpaint::view {

namespace {

constexpr int kRingWidth = 2;

bool isByKey(Qt::FocusReason reason)
{
    return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason;
}

} // namespace

FocusRing::FocusRing(QWidget* area) : QWidget(area)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    area->installEventFilter(this);
    hide();
}

void FocusRing::cover()
{
    const QRect all = parentWidget()->rect();
    setGeometry(all);
    // Only its edge is composed anew with each frame of the area.
    setMask(QRegion(all) - QRegion(all.adjusted(kRingWidth, kRingWidth, -kRingWidth, -kRingWidth)));
}

bool FocusRing::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::FocusIn:
        if (isByKey(static_cast<QFocusEvent*>(event)->reason())) {
            cover();
            show();
            raise();
        }
        break;
    case QEvent::FocusOut:
    case QEvent::MouseButtonPress:
        hide();
        break;
    case QEvent::Resize:
        if (isVisible())
            cover();
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

void FocusRing::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.fillRect(rect(), Theme::current().accent);
}

} // namespace hairpaint::view
