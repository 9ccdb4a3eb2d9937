// What bounds one run of hairpaint-import from outside, and ends it with all that it started: a process group on Unix,
// of processes with resource limits each, a job object on Windows.
#pragma once

#include <memory>

class QProcess;

namespace hairpaint::model {

/// Made before the process starts, on the thread that starts it; lives until it has ended. On Windows the process ends
/// with this at the latest.
class HelperConfinement
{
public:
    HelperConfinement(QProcess& process, int timeoutMs);
    HelperConfinement(const HelperConfinement&) = delete;
    HelperConfinement& operator=(const HelperConfinement&) = delete;

    /// The process runs and has been sent nothing yet.
    void started();
    void kill();

private:
    QProcess& m_process;
    std::shared_ptr<void> m_job; ///< A handle, on Windows alone.
};

} // namespace hairpaint::model
