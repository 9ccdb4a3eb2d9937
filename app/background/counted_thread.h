// Threads that may outlive whoever started them, since they ask a disk that may not answer. Each is counted as long as
// it runs, so that the end of the program takes nothing from under them.
#pragma once

#include <functional>
#include <thread>

namespace hairpaint::app {

/// Counts as one of them as long as it lives: owned by a thread that was started otherwise and is left to itself.
class ThreadCount
{
public:
    ThreadCount();
    ~ThreadCount();
    ThreadCount(const ThreadCount&) = delete;
    ThreadCount& operator=(const ThreadCount&) = delete;
    ThreadCount(ThreadCount&&) = delete;
    ThreadCount& operator=(ThreadCount&&) = delete;
};

/// To be joined or detached. `work` owns all that it uses, and is gone when the thread is no longer counted.
[[nodiscard]] std::thread countedThread(std::function<void()> work);
/// Any thread.
[[nodiscard]] bool anyCountedThread();

} // namespace hairpaint::app
