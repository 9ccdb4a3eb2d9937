// Where large blocks of memory go when they are not used any more.
#pragma once

namespace hairpaint::app {

/// Blocks of 256 KiB and more go back to the system the moment they are freed. glibc by itself begins to keep them as
/// soon as one has been freed, and a window that is open for a day holds twice what it uses, in pieces. Once, before
/// other threads begin. Other libraries are left as they are.
void returnLargeMemory();

} // namespace hairpaint::app
