// Loops that run on several threads; all of the program's are here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace hairpaint::sim {

/// Calls body(begin, end) for ranges that cover 0..count, each at least `grain` long, on several threads; returns when
/// all are done. The body must give the same result however the range is cut. What a body throws comes out of the call,
/// when no range runs any more; ranges not begun by then may be left out. oneTBB; std::thread in the tsan
/// preset.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

/// Whom a thread's loops serve. Each has slots for threads of its own, so that a loop of the window never waits for a
/// groom or a file to be done; idle threads help the window first, then simulation and drawing.
enum class Arena : std::uint8_t
{
    Window,
    Simulation,
    Drawing,
    Background
};

/// The loops that this thread begins while the scope lives run in that arena; those of a thread without one, in the
/// window's.
class ArenaScope
{
public:
    explicit ArenaScope(Arena arena);
    ~ArenaScope();
    ArenaScope(const ArenaScope&) = delete;
    ArenaScope& operator=(const ArenaScope&) = delete;

private:
    Arena m_before;
};

/// How many threads the loops of each arena may use from now on: 1 to 64, 0 for all cores. For tests and benchmarks.
void setThreadCount(int threads);
[[nodiscard]] int threadCount();

} // namespace hairpaint::sim
