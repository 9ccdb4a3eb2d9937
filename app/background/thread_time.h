// How long a thread has been computing.
#pragma once

#include <thread>

namespace hairpaint::app {

/// Milliseconds of processor time; what waits for a disk uses none. Always 0 where the system does not tell. `thread`
/// has not been joined.
[[nodiscard]] double processorMs(std::thread& thread);

} // namespace hairpaint::app
