// Waiting for what comes soon on an idle machine: by a condition, never for a while.
#pragma once

#include "tests/support/patience.h"

#include <QCoreApplication>
#include <QTimer>

#include <chrono>
#include <thread>

namespace hairpaint::test {

/// Waits, without an event loop, for what other threads or processes do; false where it does not come.
template<typename Condition>
[[nodiscard]] bool awaitUntil(const Condition& isThere)
{
    constexpr std::chrono::milliseconds kBetweenLooks(1);
    const auto giveUp = std::chrono::steady_clock::now() + std::chrono::milliseconds(kPatienceMs);
    while (!isThere()) {
        if (std::chrono::steady_clock::now() > giveUp)
            return false;
        std::this_thread::sleep_for(kBetweenLooks);
    }
    return true;
}

/// Handles events until all is done that was due when it was called, timers of zero length included.
inline void handleDueEvents()
{
    bool isDone = false;
    QTimer last; // Zero timers fire in the order in which they were started.
    QObject::connect(&last, &QTimer::timeout, [&isDone] { isDone = true; });
    last.start(0);
    while (!isDone)
        QCoreApplication::processEvents(QEventLoop::AllEvents);
}

} // namespace hairpaint::test
