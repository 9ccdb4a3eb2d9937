// Brows and lashes as a switch.
#pragma once

#include "app/background/jobs.h"
#include "app/session.h"

class QWidget;

namespace hairpaint::app {

/// GUI thread. All that it is made with must outlive it; what goes wrong is said over `window`.
class FaceHair
{
public:
    FaceHair(Session& session, Jobs& jobs, QWidget& window) : m_session(session), m_jobs(jobs), m_window(window) {}

    [[nodiscard]] bool shown() const; ///< Whether the document has any, and it is visible.
    /// Adds them where there are none yet; shows or hides those that are there. One undo step.
    void toggle();

private:
    [[nodiscard]] bool exists() const;

    Session& m_session;
    Jobs& m_jobs;
    QWidget& m_window;
};

} // namespace hairpaint::app
