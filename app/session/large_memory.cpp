// glibc's limit, which moves unless it is set, and its pages, which it keeps unless it is told; Windows' heap, which is
// told alike.
#include "app/session/large_memory.h"

#include <cstdlib>

#if defined(__GLIBC__) || defined(_WIN32)
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

void returnFreedMemory()
{
#if defined(__GLIBC__)
    malloc_trim(0);
#elif defined(_WIN32)
    (void)_heapmin();
#endif
}

} // namespace hairpaint::app
