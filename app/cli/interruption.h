// Ctrl+C, kill and a closed terminal while a verb writes: unfinished files are removed first.
#pragma once

#include "model/values/progress.h"

namespace hairpaint::app {

/// While it lives, SIGINT, SIGTERM and SIGHUP stop the work that was given its progress(); its end then ends the
/// process by that signal, as callers expect it. A second signal does so at once. Signals that are ignored stay so. One
/// at a time, on the main thread, before what is to be cleaned up. On Windows the console's Ctrl+C, Ctrl+Break and end
/// do so, and the process ends with STATUS_CONTROL_C_EXIT.
class Interruption
{
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// For work on any thread.
    [[nodiscard]] static model::Progress progress();
};

} // namespace hairpaint::app
