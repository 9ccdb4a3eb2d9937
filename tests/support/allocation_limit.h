// Want of memory on order, on every thread: while a limit lives, all allocations of its size or more fail; while a
// fault lives, one large one does.
#pragma once

#include <cstddef>

namespace hairpaint::test {

/// One at a time. Needs allocation_limit.cpp, which replaces operator new.
class AllocationLimit
{
public:
    explicit AllocationLimit(std::size_t bytes);
    ~AllocationLimit();
    AllocationLimit(const AllocationLimit&) = delete;
    AllocationLimit& operator=(const AllocationLimit&) = delete;
};

/// The n-th allocation of `leastBytes` or more fails, by operator new and, on Linux without the thread sanitizer, by
/// malloc, which Qt and C libraries use. One at a time.
class AllocationFault
{
public:
    AllocationFault(int nth, std::size_t leastBytes);
    ~AllocationFault();
    AllocationFault(const AllocationFault&) = delete;
    AllocationFault& operator=(const AllocationFault&) = delete;

    /// There were so many.
    [[nodiscard]] static bool happened();
};

} // namespace hairpaint::test
