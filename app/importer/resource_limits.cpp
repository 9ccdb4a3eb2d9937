// Address space on POSIX systems, a job object on Windows.
#include "app/importer/resource_limits.h"

#include <cstdint>

#if defined(_WIN32)
#define NOMINMAX
#include <windows.h>
#elif defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace hairpaint::importer {

namespace {

[[maybe_unused]] constexpr std::uint64_t kMostMemoryBytes = 1'800'000'000;

} // namespace

#if defined(_WIN32)

void limitResources()
{
    const HANDLE job = CreateJobObjectW(nullptr, nullptr);
    if (job == nullptr)
        return;
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    limits.BasicLimitInformation.LimitFlags =
        JOB_OBJECT_LIMIT_PROCESS_MEMORY | JOB_OBJECT_LIMIT_ACTIVE_PROCESS | JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION;
    limits.BasicLimitInformation.ActiveProcessLimit = 1;
    limits.ProcessMemoryLimit = static_cast<SIZE_T>(kMostMemoryBytes);
    SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof(limits));
    AssignProcessToJobObject(job, GetCurrentProcess());
}

#elif (defined(__unix__) || defined(__APPLE__)) && !defined(__SANITIZE_ADDRESS__)

void limitResources()
{
    rlimit memory{};
    if (getrlimit(RLIMIT_AS, &memory) != 0)
        return;
    if (memory.rlim_cur == RLIM_INFINITY || memory.rlim_cur > kMostMemoryBytes)
        memory.rlim_cur = kMostMemoryBytes;
    setrlimit(RLIMIT_AS, &memory);
}

#else

// Address sanitizers reserve terabytes, so there is nothing to limit.
void limitResources() {}

#endif

} // namespace hairpaint::importer
