// operator new that can be made to fail.
#include "tests/support/allocation_limit.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

std::atomic<std::size_t> leastRefused{std::numeric_limits<std::size_t>::max()};

void* allocate(std::size_t bytes, std::size_t alignment)
{
    if (bytes >= leastRefused.load(std::memory_order_relaxed))
        throw std::bad_alloc();
#ifdef _WIN32
    void* memory = _aligned_malloc(bytes, alignment);
#else
    // The size is a multiple of the alignment, as std::aligned_alloc wants it.
    void* memory = alignment <= alignof(std::max_align_t)
                       ? std::malloc(bytes == 0 ? 1 : bytes)
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
    leastRefused = std::numeric_limits<std::size_t>::max();
}

} // namespace hairpaint::test

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
