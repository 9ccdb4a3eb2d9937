// Loops on several threads: oneTBB, or plain threads where the thread sanitizer must see every lock.
#include "sim/base/parallel.h"

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <thread>

#ifdef HAIRPAINT_STD_THREADS
#include <atomic>
#include <exception>
#include <vector>
#else
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace hairpaint::sim {

namespace {

constexpr int kMostThreads = 64;

int coreCount()
{
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMostThreads);
}

using RangeBody = std::function<void(std::size_t, std::size_t)>;

constexpr std::size_t kArenas = 4;

/// Where the loops of this thread run.
thread_local Arena currentArena = Arena::Window;

#ifndef HAIRPAINT_STD_THREADS
tbb::task_arena::priority priorityOf(Arena arena)
{
    switch (arena) {
    case Arena::Window:
        return tbb::task_arena::priority::high;
    case Arena::Simulation:
    case Arena::Drawing:
        return tbb::task_arena::priority::normal;
    case Arena::Background:
        break;
    }
    return tbb::task_arena::priority::low;
}
#endif

/// The threads that the loops of one arena run on. Loops that run keep the pool they began with.
class Pool
{
public:
    Pool([[maybe_unused]] Arena arena, int threads)
        : m_threads(threads)
#ifndef HAIRPAINT_STD_THREADS
          ,
          m_cap(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(std::max(threads, coreCount()))),
          m_arena(threads, 1, priorityOf(arena))
#endif
    {}

    [[nodiscard]] int threads() const
    {
        return m_threads;
    }

    /// Calls body for ranges of pieces that cover 0..pieces.
    void run(std::size_t pieces, const RangeBody& body)
    {
#ifdef HAIRPAINT_STD_THREADS
        std::atomic<std::size_t> next{0};
        std::mutex mutex;
        std::exception_ptr thrown;
        const auto work = [&] {
            try {
                for (std::size_t piece = next.fetch_add(1); piece < pieces; piece = next.fetch_add(1))
                    body(piece, piece + 1);
            } catch (...) {
                next = pieces;
                const std::lock_guard lock(mutex);
                thrown = std::current_exception();
            }
        };
        {
            std::vector<std::jthread> helpers;
            const std::size_t helperCount = std::min(pieces, static_cast<std::size_t>(m_threads)) - 1;
            helpers.reserve(helperCount);
            for (std::size_t i = 0; i < helperCount; ++i)
                helpers.emplace_back(work);
            work();
        }
        if (thrown)
            std::rethrow_exception(thrown);
#else
        m_arena.execute([&] {
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pieces),
                              [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
        });
#endif
    }

private:
    int m_threads;
#ifndef HAIRPAINT_STD_THREADS
    tbb::global_control m_cap; ///< oneTBB's own cap is the number of cores; eight threads shall be eight on two.
    tbb::task_arena m_arena;
#endif
};

/// The pools in use; made on first use, since oneTBB's objects must not outlive its own statics.
struct Pools
{
    std::mutex mutex;
    int threads = 0; ///< 0: not chosen yet.
    std::array<std::shared_ptr<Pool>, kArenas> ofArena;
};

Pools& pools()
{
    static Pools all;
    return all;
}

std::shared_ptr<Pool> currentPool()
{
    Pools& all = pools();
    const std::lock_guard lock(all.mutex);
    std::shared_ptr<Pool>& pool = all.ofArena[static_cast<std::size_t>(currentArena)];
    if (!pool)
        pool = std::make_shared<Pool>(currentArena, all.threads > 0 ? all.threads : coreCount());
    return pool;
}

} // namespace

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body)
{
    if (count == 0)
        return;
    const std::size_t step = std::max<std::size_t>(grain, 1);
    const std::size_t pieces = std::max<std::size_t>(count / step, 1);
    if (pieces == 1) {
        body(0, count);
        return;
    }
    const std::shared_ptr<Pool> pool = currentPool();
    if (pool->threads() == 1) {
        body(0, count);
        return;
    }
    // Every range begins at a multiple of the grain; the last piece takes the rest.
    pool->run(pieces, [&, arena = currentArena](std::size_t firstPiece, std::size_t endPiece) {
        const ArenaScope scope(arena); // For loops within the body, on whichever thread it runs.
        body(firstPiece * step, endPiece == pieces ? count : endPiece * step);
    });
}

ArenaScope::ArenaScope(Arena arena) : m_before(currentArena)
{
    currentArena = arena;
}

ArenaScope::~ArenaScope()
{
    currentArena = m_before;
}

void setThreadCount(int threads)
{
    const int wanted = threads <= 0 ? coreCount() : std::min(threads, kMostThreads);
    Pools& all = pools();
    const std::lock_guard lock(all.mutex);
    if (all.threads == wanted)
        return;
    all.threads = wanted;
    for (std::shared_ptr<Pool>& pool : all.ofArena)
        pool.reset();
}

int threadCount()
{
    return currentPool()->threads();
}

} // namespace hairpaint::sim
