// Threads that may outlive whoever started them, since they ask a disk that may not answer. Each is counted as long as
// it runs, so that the end of the program takes nothing from under them.
#pragma once

#include <functional>
#include <thread>

namespace hairpaint::app {

/// To be joined or detached. `work` owns all that it uses, and is gone when the thread is no longer counted.
[[nodiscard]] std::thread countedThread(std::function<void()> work);
/// Any thread.
[[nodiscard]] bool anyCountedThread();

} // namespace hairpaint::app
