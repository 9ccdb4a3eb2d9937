// glibc's limit, which moves unless it is set.
#include "app/large_memory.h"

#include <cstdlib>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace hairpaint::app {

void returnLargeMemory()
{
#if defined(__GLIBC__)
    constexpr int kLargeBytes = 256 << 10;
    mallopt(M_MMAP_THRESHOLD, kLargeBytes);
#endif
}

} // namespace hairpaint::app
