// Brows and lashes as a switch, and hair that grows in a job.
#pragma once

#include "app/background/jobs.h"
#include "app/session/session.h"
#include "model/styles/hair_kinds.h"

#include <memory>
#include <optional>

class QWidget;

namespace hairpaint::app {

/// GUI thread. All that it is made with must outlive it; what goes wrong is said over `window`.
class FaceHairSwitch
{
public:
    FaceHairSwitch(Session& session, Jobs& jobs, QWidget& window) : m_session(session), m_jobs(jobs), m_window(window)
    {}

    [[nodiscard]] bool shown() const; ///< Whether the document has any, and it is visible.
    /// Adds them where there are none yet; shows or hides those that are there. One undo step.
    void toggle();

private:
    [[nodiscard]] bool exists() const;

    Session& m_session;
    Jobs& m_jobs;
    QWidget& m_window;
};

/// A group of that kind as it grows on the head, as a job: see model::grownHair(). GUI thread.
[[nodiscard]] model::Result<std::optional<model::HairGroup>> growHair(Jobs& jobs, const model::HairKind& kind,
                                                                      const std::shared_ptr<const model::Head>& head);

} // namespace hairpaint::app
