// A process group of its own, and limits that the child sets itself before it becomes the helper.
#include "model/files/helper_confinement.h"

#include <QProcess>

#ifdef Q_OS_UNIX

#include <csignal>
#ifdef Q_OS_LINUX
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

namespace hairpaint::model {

namespace {

/// More than the greatest request and its encoded answer need together.
[[maybe_unused]] constexpr quint64 kMostMemoryBytes = 1'900'000'000;
[[maybe_unused]] constexpr quint64 kMappedBytes = 1'500'000'000;

#if defined(HAIRPAINT_ASAN)
constexpr bool kLimitMemory = false; // address sanitizers reserve terabytes
#else
constexpr bool kLimitMemory = true;
#endif

/// Runs in the child between fork and exec: only async-signal-safe calls.
void confineChild(int timeoutMs)
{
    setpgid(0, 0);
#ifdef Q_OS_LINUX
    prctl(PR_SET_PDEATHSIG, SIGKILL); // Nobody is left to read what it says.
#endif
    const rlimit none{.rlim_cur = 0, .rlim_max = 0};
    setrlimit(RLIMIT_CORE, &none);
    const rlim_t seconds = static_cast<rlim_t>(timeoutMs / 1000) + 2;
    // Two cores may be at work.
    const rlimit processor{.rlim_cur = 2 * seconds, .rlim_max = 2 * seconds + 1};
    setrlimit(RLIMIT_CPU, &processor);
    if (kLimitMemory) {
#ifdef Q_OS_LINUX
        // What it writes to; libraries alone map most of a gigabyte that is never in memory.
        const rlimit written{.rlim_cur = kMostMemoryBytes, .rlim_max = kMostMemoryBytes};
        setrlimit(RLIMIT_DATA, &written);
        const rlimit memory{.rlim_cur = kMostMemoryBytes + kMappedBytes, .rlim_max = kMostMemoryBytes + kMappedBytes};
#else
        const rlimit memory{.rlim_cur = kMostMemoryBytes, .rlim_max = kMostMemoryBytes};
#endif
        setrlimit(RLIMIT_AS, &memory);
    }
}

} // namespace

HelperConfinement::HelperConfinement(QProcess& process, int timeoutMs) : m_process(process)
{
    process.setChildProcessModifier([timeoutMs] { confineChild(timeoutMs); });
}

void HelperConfinement::started() {}

void HelperConfinement::kill()
{
    if (const qint64 id = m_process.processId(); id > 0)
        ::kill(static_cast<pid_t>(-id), SIGKILL);
    m_process.kill();
}

} // namespace hairpaint::model

#endif
