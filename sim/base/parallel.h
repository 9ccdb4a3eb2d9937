// The one way in which this program runs a loop on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace hairpaint::sim {

/// Calls body(begin, end) for ranges that cover 0..count, each at least `grain` long, on several threads; returns when
/// all are done. The body must give the same result however the range is cut. oneTBB; std::thread in the tsan preset.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

/// How many threads the loops may use from now on: 1 to 64, 0 for all cores. For tests and benchmarks.
void setThreadCount(int threads);
[[nodiscard]] int threadCount();

} // namespace hairpaint::sim
