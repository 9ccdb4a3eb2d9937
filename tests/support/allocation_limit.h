// Want of memory on order: while a limit lives, allocations of its size or more fail, on every thread.
#pragma once

#include <cstddef>

namespace hairpaint::test {

/// One at a time. Needs allocation_limit.cpp, which takes the place of operator new.
class AllocationLimit
{
public:
    explicit AllocationLimit(std::size_t bytes);
    ~AllocationLimit();
    AllocationLimit(const AllocationLimit&) = delete;
    AllocationLimit& operator=(const AllocationLimit&) = delete;
};

} // namespace hairpaint::test
