// Threads that may outlive whoever started them, since they ask a disk that may not answer. Each is counted as long as
// it runs, so that the end of the program takes nothing from under them.
#pragma once

#include <functional>
#include <thread>

namespace hairpaint::app {

/// Counts as such a thread while it exists. For threads that were started otherwise and are detached.
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

/// The caller joins or detaches it. `work` owns all that it uses and is destroyed before the thread stops counting.
[[nodiscard]] std::thread countedThread(std::function<void()> work);
/// Any thread.
[[nodiscard]] bool anyCountedThread();

} // namespace hairpaint::app
