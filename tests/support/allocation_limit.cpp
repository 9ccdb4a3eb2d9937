// operator new and malloc that can be made to fail.
#include "tests/support/allocation_limit.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

// What malloc is in the C library or the address sanitizer, under a name that nobody replaces.
#if defined(__GLIBC__) && defined(HAIRPAINT_ASAN)
#define HAIRPAINT_OWN_MALLOC(name) __interceptor_##name
#elif defined(__GLIBC__) && !defined(HAIRPAINT_TSAN)
#define HAIRPAINT_OWN_MALLOC(name) __libc_##name
#endif
#ifdef HAIRPAINT_OWN_MALLOC
extern "C" void* HAIRPAINT_OWN_MALLOC(malloc)(std::size_t bytes);
extern "C" void* HAIRPAINT_OWN_MALLOC(calloc)(std::size_t count, std::size_t bytes);
extern "C" void* HAIRPAINT_OWN_MALLOC(realloc)(void* memory, std::size_t bytes);
#endif

namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

std::atomic<std::size_t> leastRefused{kNone};
std::atomic<std::size_t> leastCounted{kNone};
std::atomic<int> untilFault{0};

/// Whether this is the one that fails.
bool isFault(std::size_t bytes)
{
    return bytes >= leastCounted.load(std::memory_order_relaxed) && untilFault.fetch_sub(1) == 1;
}

#ifndef _WIN32
void* plainMalloc(std::size_t bytes)
{
#ifdef HAIRPAINT_OWN_MALLOC
    return HAIRPAINT_OWN_MALLOC(malloc)(bytes);
#else
    return std::malloc(bytes);
#endif
}
#endif

void* allocate(std::size_t bytes, std::size_t alignment)
{
    if (bytes >= leastRefused.load(std::memory_order_relaxed) || isFault(bytes))
        throw std::bad_alloc();
#ifdef _WIN32
    void* memory = _aligned_malloc(bytes, alignment);
#else
    // The size is a multiple of the alignment, as std::aligned_alloc wants it.
    void* memory = alignment <= alignof(std::max_align_t)
                       ? plainMalloc(bytes == 0 ? 1 : bytes)
                       : std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
#endif
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

void release(void* memory)
{
#ifdef _WIN32
    _aligned_free(memory);
#else
    std::free(memory);
#endif
}

} // namespace

namespace hairpaint::test {

AllocationLimit::AllocationLimit(std::size_t bytes)
{
    leastRefused = bytes;
}

AllocationLimit::~AllocationLimit()
{
    leastRefused = kNone;
}

AllocationFault::AllocationFault(int nth, std::size_t leastBytes)
{
    untilFault = nth;
    leastCounted = leastBytes;
}

AllocationFault::~AllocationFault()
{
    leastCounted = kNone;
}

bool AllocationFault::happened()
{
    return untilFault <= 0;
}

} // namespace hairpaint::test

#ifdef HAIRPAINT_OWN_MALLOC
extern "C" void* malloc(std::size_t bytes) noexcept
{
    return isFault(bytes) ? nullptr : HAIRPAINT_OWN_MALLOC(malloc)(bytes);
}

extern "C" void* calloc(std::size_t count, std::size_t bytes) noexcept
{
    return isFault(count * bytes) ? nullptr : HAIRPAINT_OWN_MALLOC(calloc)(count, bytes);
}

extern "C" void* realloc(void* memory, std::size_t bytes) noexcept
{
    return isFault(bytes) ? nullptr : HAIRPAINT_OWN_MALLOC(realloc)(memory, bytes);
}
#endif

void* operator new(std::size_t bytes)
{
    return allocate(bytes, alignof(std::max_align_t));
}

void* operator new[](std::size_t bytes)
{
    return allocate(bytes, alignof(std::max_align_t));
}

void* operator new(std::size_t bytes, std::align_val_t alignment)
{
    return allocate(bytes, static_cast<std::size_t>(alignment));
}

void* operator new[](std::size_t bytes, std::align_val_t alignment)
{
    return allocate(bytes, static_cast<std::size_t>(alignment));
}

// These too, or what they gave would be released by those below.
void* operator new(std::size_t bytes, const std::nothrow_t& /*tag*/) noexcept
{
    try {
        return allocate(bytes, alignof(std::max_align_t));
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

void* operator new[](std::size_t bytes, const std::nothrow_t& tag) noexcept
{
    return operator new(bytes, tag);
}

void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t& /*tag*/) noexcept
{
    try {
        return allocate(bytes, static_cast<std::size_t>(alignment));
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

void* operator new[](std::size_t bytes, std::align_val_t alignment, const std::nothrow_t& tag) noexcept
{
    return operator new(bytes, alignment, tag);
}

void operator delete(void* memory) noexcept
{
    release(memory);
}

void operator delete[](void* memory) noexcept
{
    release(memory);
}

void operator delete(void* memory, std::size_t /*bytes*/) noexcept
{
    release(memory);
}

void operator delete[](void* memory, std::size_t /*bytes*/) noexcept
{
    release(memory);
}

void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept
{
    release(memory);
}

void operator delete[](void* memory, std::align_val_t /*alignment*/) noexcept
{
    release(memory);
}

void operator delete(void* memory, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept
{
    release(memory);
}

void operator delete[](void* memory, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept
{
    release(memory);
}
