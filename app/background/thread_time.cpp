// A clock of the thread's own on Linux, its times on Windows.
#include "app/background/thread_time.h"

#if defined(_WIN32)
#include <windows.h>
#ifdef __MINGW32__
#include <pthread.h>
#endif
#elif defined(__linux__)
#include <ctime>
#include <pthread.h>
#endif

namespace hairpaint::app {

#if defined(_WIN32)

namespace {

HANDLE handleOf(std::thread& thread)
{
#ifdef __MINGW32__
    return static_cast<HANDLE>(pthread_gethandle(thread.native_handle())); // GCC's threads there are winpthreads'.
#else
    return static_cast<HANDLE>(thread.native_handle());
#endif
}

} // namespace

double processorMs(std::thread& thread)
{
    constexpr double kUnitsPerMs = 10'000.0;
    FILETIME created{};
    FILETIME ended{};
    FILETIME kernel{};
    FILETIME user{};
    if (!GetThreadTimes(handleOf(thread), &created, &ended, &kernel, &user))
        return 0.0;
    const auto units = [](const FILETIME& time) {
        return static_cast<double>(time.dwHighDateTime) * 4294967296.0 + static_cast<double>(time.dwLowDateTime);
    };
    return (units(kernel) + units(user)) / kUnitsPerMs;
}

#elif defined(__linux__)

double processorMs(std::thread& thread)
{
    clockid_t clock{};
    timespec time{};
    if (pthread_getcpuclockid(thread.native_handle(), &clock) != 0 || clock_gettime(clock, &time) != 0)
        return 0.0;
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

#else

double processorMs(std::thread& /*thread*/)
{
    return 0.0;
}

#endif

} // namespace hairpaint::app
