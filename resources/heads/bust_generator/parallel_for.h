// Runs body(i) for every i in [0, count) on all cores; bodies must not touch each other's results.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace hairpaint::heads {

template<typename Body>
void parallelFor(int count, const Body& body)
{
    constexpr int grain = 8;
    std::atomic<int> next{0};
    const auto work = [&] {
        for (int begin = next.fetch_add(grain); begin < count; begin = next.fetch_add(grain))
            for (int i = begin; i < std::min(begin + grain, count); ++i)
                body(i);
    };
    const unsigned helpers = std::max(std::thread::hardware_concurrency(), 1U) - 1U;
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < helpers; ++i)
        threads.emplace_back(work);
    work();
    for (std::thread& thread : threads)
        thread.join();
}

} // namespace hairpaint::heads
