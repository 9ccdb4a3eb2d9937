// How fast the 3D area draws: for the status line, and for the simulation, which makes no more than can be drawn.
#pragma once

#include "app/session/session.h"
#include "view/rendering/backend.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace hairpaint::view {
class HeadView;
class StatusReadout;
} // namespace hairpaint::view

namespace hairpaint::app {

/// Belongs to the status line; the session outlives both. GUI thread.
class FrameMeter : public QObject
{
    Q_OBJECT
public:
    FrameMeter(const view::HeadView& head, Session& session, view::StatusReadout& status);

private:
    void onFrameDrawn(const rendering::FrameStatistics& statistics);

    const view::HeadView& m_head;
    Session& m_session;
    view::StatusReadout& m_status;
    double m_frameRate = 0.0; ///< Smoothed, frames per second.
    QElapsedTimer m_sinceFrame;
    QTimer m_stopped; ///< Runs out when nothing was drawn for a moment: a rate of then would mislead.
};

} // namespace hairpaint::app
