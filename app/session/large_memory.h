// Returns freed memory to the system.
#pragma once

namespace hairpaint::app {

/// Blocks of 256 KiB and more go back to the system the moment they are freed. glibc by itself begins to keep them as
/// soon as one has been freed, and a window that is open for a day holds twice what it uses, in pieces. Once, before
/// other threads begin. Other libraries are left as they are.
void returnLargeMemory();

/// Gives back the pages that lie free among small blocks, which glibc keeps for ever: tiles of maps are of that size,
/// and hundreds of megabytes of them can be free. Any thread; takes some milliseconds, in which others that allocate
/// may have to wait.
void returnFreedMemory();

} // namespace hairpaint::app
