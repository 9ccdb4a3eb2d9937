// Arrays of floats that start on a cache line, as the kernels like them.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace hairpaint::sim {

template<typename T>
struct CacheLineAllocator
{
    using value_type = T;
    static constexpr std::align_val_t kAlignment{64};

    CacheLineAllocator() = default;
    template<typename U>
    explicit CacheLineAllocator(const CacheLineAllocator<U>& /*other*/)
    {}

    [[nodiscard]] T* allocate(std::size_t count)
    {
        return static_cast<T*>(::operator new(count * sizeof(T), kAlignment));
    }
    void deallocate(T* memory, std::size_t /*count*/) { ::operator delete(memory, kAlignment); }

    friend bool operator==(const CacheLineAllocator& /*a*/, const CacheLineAllocator& /*b*/) { return true; }
};

using AlignedFloats = std::vector<float, CacheLineAllocator<float>>;

} // namespace hairpaint::sim
