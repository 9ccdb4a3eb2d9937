// Paces pictures by timers.
#include "view/head_area/frame_pacer.h"

#include <QTimerEvent>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kLeastMsBetweenDraws = 16;
constexpr int kSettleMs = 250;

} // namespace

void FramePacer::requestDraw()
{
    if (m_drawSoon.isActive())
        return;
    const qint64 passed = m_sinceDraw.isValid() ? m_sinceDraw.elapsed() : kLeastMsBetweenDraws;
    m_drawSoon.start(static_cast<int>(std::max<qint64>(0, kLeastMsBetweenDraws - passed)), Qt::PreciseTimer, this);
}

void FramePacer::wake()
{
    if (std::exchange(m_still, false))
        Q_EMIT stillEnded();
    m_settle.start(kSettleMs, this);
    requestDraw();
}

void FramePacer::timerEvent(QTimerEvent* event)
{
    if (event->timerId() == m_settle.timerId()) {
        m_settle.stop();
        m_still = true;
        Q_EMIT stillBegan();
    } else if (event->timerId() == m_drawSoon.timerId()) {
        m_drawSoon.stop();
        Q_EMIT drawDue();
    } else {
        QObject::timerEvent(event);
    }
}

} // namespace hairpaint::view
