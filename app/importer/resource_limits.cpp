// Memory that is written to on Linux, address space on other POSIX systems, a job object on Windows.
#include "app/importer/resource_limits.h"

#include <cstdint>

#if defined(_WIN32)
#include <windows.h>
#elif defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace hairpaint::importer {

namespace {

[[maybe_unused]] constexpr std::uint64_t kMostMemoryBytes = 1'800'000'000;
[[maybe_unused]] constexpr std::uint64_t kMegabyte = 1'000'000;

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

std::uint32_t mostMegabytes()
{
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    if (!QueryInformationJobObject(nullptr, JobObjectExtendedLimitInformation, &limits, sizeof(limits), nullptr))
        return 0;
    return static_cast<std::uint32_t>(limits.ProcessMemoryLimit / kMegabyte);
}

#elif (defined(__unix__) || defined(__APPLE__)) && !defined(HAIRPAINT_ASAN)

namespace {

#ifdef __linux__
// What is written to; libraries alone map most of a gigabyte that is never in memory.
constexpr auto kMemory = RLIMIT_DATA;
#else
constexpr auto kMemory = RLIMIT_AS;
#endif

template<typename Resource>
void lower(Resource resource, std::uint64_t most)
{
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0)
        return;
    if (limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur > most)
        limit.rlim_cur = most;
    setrlimit(resource, &limit);
}

} // namespace

void limitResources()
{
    lower(kMemory, kMostMemoryBytes);
}

std::uint32_t mostMegabytes()
{
    rlimit limit{};
    if (getrlimit(kMemory, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return 0;
    return static_cast<std::uint32_t>(limit.rlim_cur / kMegabyte);
}

#else

// Address sanitizers reserve terabytes, so there is nothing to limit.
void limitResources() {}

std::uint32_t mostMegabytes()
{
    return 0;
}

#endif

} // namespace hairpaint::importer
