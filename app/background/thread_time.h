// The processor time that a thread has used.
#pragma once

#include <thread>

namespace hairpaint::app {

/// Milliseconds of processor time; waiting for a disk uses none. Always 0 if the system cannot tell. `thread`
/// has not been joined.
[[nodiscard]] double processorMs(std::thread& thread);

} // namespace hairpaint::app
