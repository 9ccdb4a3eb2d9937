// The speed of drawing: see the header.
#include "app/window/frame_meter.h"

#include "view/head_area/head_view.h"
#include "view/panels/status_readout.h"

#include <algorithm>
#include <chrono>

namespace hairpaint::app {

namespace {

constexpr std::chrono::milliseconds kLongestBetweenFrames(500);

} // namespace

FrameMeter::FrameMeter(const view::HeadView& head, Session& session, view::StatusReadout& status)
    : QObject(&status), m_head(head), m_session(session), m_status(status)
{
    connect(&head, &view::HeadView::frameDrawn, this, &FrameMeter::onFrameDrawn);
    m_stopped.setSingleShot(true);
    m_stopped.setInterval(2 * kLongestBetweenFrames);
    connect(&m_stopped, &QTimer::timeout, this, [this] {
        m_frameRate = 0.0;
        m_status.setFramesPerSecond(m_frameRate);
    });
}

void FrameMeter::onFrameDrawn(const rendering::FrameStatistics& statistics)
{
    // A pause is no slow frame: the picture was still.
    if (m_sinceFrame.isValid() && m_sinceFrame.elapsed() < kLongestBetweenFrames.count()) {
        const double seconds = static_cast<double>(m_sinceFrame.nsecsElapsed()) * 1e-9;
        const double rate = 1.0 / std::max(seconds, 1e-3);
        m_frameRate = m_frameRate > 0.0 ? m_frameRate * 0.9 + rate * 0.1 : rate;
        m_status.setFramesPerSecond(m_frameRate);
        m_stopped.start();
    }
    m_sinceFrame.start();
    m_session.setDrawnDetail(statistics.detail);
    const auto& frame = m_session.frame();
    // A fine picture takes its time, and one of hair that rests takes less than one of hair that moves.
    if (frame && !frame->asleep && !m_session.paused() && !statistics.inSteps)
        m_session.setDrawTime(statistics.milliseconds);
    const auto drawn = static_cast<qint64>(statistics.drawnHairs);
    if (!frame) {
        m_status.setHairs(drawn, 0);
        return;
    }
    const auto all = static_cast<qint64>(frame->hairCount);
    m_status.setHairs(m_head.cardsShown() ? all : drawn, all, frame->limit);
}

} // namespace hairpaint::app
