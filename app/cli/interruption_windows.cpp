// The console's Ctrl+C, Ctrl+Break and end are remembered, asked for, and told again by the exit code.
#include "app/cli/interruption.h"

#ifdef _WIN32

#include <windows.h>

#include <atomic>
#include <cstdio>

namespace hairpaint::app {

namespace {

/// Handlers run on a thread of the system's own.
std::atomic<bool> wasInterrupted{false};

BOOL WINAPI remember(DWORD event)
{
    if (wasInterrupted.exchange(true))
        return FALSE; // The next one does what it always did.
    // With its console a process ends as soon as this returns, and after five seconds in any case.
    constexpr DWORD kCleaningUpMs = 5000;
    if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT)
        Sleep(kCleaningUpMs);
    return TRUE;
}

} // namespace

Interruption::Interruption()
{
    SetConsoleCtrlHandler(remember, TRUE);
}

Interruption::~Interruption()
{
    SetConsoleCtrlHandler(remember, FALSE);
    if (!wasInterrupted)
        return;
    constexpr UINT kStatusControlCExit = 0xC000013A;
    std::fflush(nullptr);
    ExitProcess(kStatusControlCExit);
}

model::Progress Interruption::progress()
{
    return [](double) { return !wasInterrupted; };
}

} // namespace hairpaint::app

#endif
