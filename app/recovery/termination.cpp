// Signals become an event: their handlers may do next to nothing.
#include "app/recovery/termination.h"

#include <QSocketNotifier>

#ifdef Q_OS_UNIX
#include <array>
#include <csignal>
#include <sys/socket.h>
#include <unistd.h>
#endif

namespace hairpaint::app {

#ifdef Q_OS_UNIX

namespace {

constexpr std::array<int, 3> kSignals{SIGTERM, SIGHUP, SIGINT};

/// Handler's end, reader's end.
std::array<int, 2>& ends()
{
    static std::array<int, 2> sockets{-1, -1};
    return sockets;
}

void onSignal(int /*signal*/)
{
    const char byte = 1;
    [[maybe_unused]] const ssize_t written = ::write(ends()[0], &byte, 1);
}

} // namespace

Termination::Termination(QObject* parent) : QObject(parent)
{
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends().data()) != 0)
        return;
    m_notifier = std::make_unique<QSocketNotifier>(ends()[1], QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, [this] {
        char byte = 0;
        if (::read(ends()[1], &byte, 1) == 1)
            Q_EMIT wanted();
    });
    struct sigaction action = {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND); // The next one does what it always did.
    for (const int signal : kSignals)
        ::sigaction(signal, &action, nullptr);
}

Termination::~Termination()
{
    for (const int signal : kSignals)
        std::signal(signal, SIG_DFL);
    m_notifier.reset();
    for (int& end : ends()) {
        if (end >= 0)
            ::close(end);
        end = -1;
    }
}

#else

Termination::Termination(QObject* parent) : QObject(parent) {}
Termination::~Termination() = default;

#endif

} // namespace hairpaint::app
