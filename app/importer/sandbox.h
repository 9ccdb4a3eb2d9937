// What a decoder that a hostile file has taken over can still reach: next to nothing.
#pragma once

#include <string>

namespace hairpaint::importer {

/// From now on this process, and whatever threads it starts, may read files in `folder` and those the system's
/// libraries come from, and no others; it may write to what is open already and create nothing; it may start no
/// program, open no connection and look into no other process. `folder`: empty where no file is read at all.
///
/// Linux: Landlock for files, a seccomp filter for the rest, each where the kernel has it; without them it goes on as
/// it is. Elsewhere nothing happens here (Windows: a job object, see resource_limits.h).
void enterSandbox(const std::string& folder);

} // namespace hairpaint::importer
