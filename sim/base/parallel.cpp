// Loops on several threads: oneTBB, or plain threads where the thread sanitizer must see every lock.
#include "sim/base/parallel.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <thread>

#ifdef HAIRPAINT_STD_THREADS
#include <atomic>
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

/// The threads that loops run on. Loops under way keep the pool they began with.
class Pool
{
public:
    explicit Pool(int threads)
        : m_threads(threads)
#ifndef HAIRPAINT_STD_THREADS
          ,
          m_cap(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(std::max(threads, coreCount()))),
          m_arena(threads)
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
        const auto work = [&] {
            for (std::size_t piece = next.fetch_add(1); piece < pieces; piece = next.fetch_add(1))
                body(piece, piece + 1);
        };
        std::vector<std::jthread> helpers;
        const std::size_t helperCount = std::min(pieces, static_cast<std::size_t>(m_threads)) - 1;
        helpers.reserve(helperCount);
        for (std::size_t i = 0; i < helperCount; ++i)
            helpers.emplace_back(work);
        work();
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

/// The pool in use; made on first use, since oneTBB's objects must not outlive its own statics.
struct PoolSlot
{
    std::mutex mutex;
    std::shared_ptr<Pool> pool;
};

PoolSlot& poolSlot()
{
    static PoolSlot slot;
    return slot;
}

std::shared_ptr<Pool> currentPool()
{
    PoolSlot& slot = poolSlot();
    const std::lock_guard lock(slot.mutex);
    if (!slot.pool)
        slot.pool = std::make_shared<Pool>(coreCount());
    return slot.pool;
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
    pool->run(pieces, [&](std::size_t firstPiece, std::size_t endPiece) {
        body(firstPiece * step, endPiece == pieces ? count : endPiece * step);
    });
}

void setThreadCount(int threads)
{
    const int wanted = threads <= 0 ? coreCount() : std::min(threads, kMostThreads);
    PoolSlot& slot = poolSlot();
    const std::lock_guard lock(slot.mutex);
    if (!slot.pool || slot.pool->threads() != wanted)
        slot.pool = std::make_shared<Pool>(wanted);
}

int threadCount()
{
    return currentPool()->threads();
}

} // namespace hairpaint::sim
