// The signal is remembered, asked for, and sent again.
#include "app/cli/interruption.h"

#include <QtGlobal>

#ifdef Q_OS_UNIX

#include <array>
#include <atomic>
#include <csignal>

namespace hairpaint::app {

namespace {

/// A handler can reach nothing else. 0 where none came.
std::atomic<int> signalThatCame{0};
static_assert(std::atomic<int>::is_always_lock_free);

constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};

void remember(int signal)
{
    signalThatCame = signal;
}

} // namespace

Interruption::Interruption()
{
    for (const int signal : kSignals) {
        struct sigaction before = {};
        ::sigaction(signal, nullptr, &before);
        if (before.sa_handler == SIG_IGN)
            continue;
        struct sigaction action = {};
        action.sa_handler = remember;
        action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND); // The next one does what it always did.
        ::sigaction(signal, &action, nullptr);
    }
}

Interruption::~Interruption()
{
    for (const int signal : kSignals) {
        struct sigaction now = {};
        ::sigaction(signal, nullptr, &now);
        if (now.sa_handler == remember)
            std::signal(signal, SIG_DFL);
    }
    if (signalThatCame != 0)
        std::raise(signalThatCame);
}

model::Progress Interruption::progress()
{
    return [](double) { return signalThatCame == 0; };
}

} // namespace hairpaint::app

#endif
