// The count.
#include "app/background/counted_thread.h"

#include <atomic>
#include <memory>

namespace hairpaint::app {

namespace {

std::atomic<int> countedThreads = 0;

} // namespace

ThreadCount::ThreadCount()
{
    ++countedThreads;
}

ThreadCount::~ThreadCount()
{
    --countedThreads;
}

std::thread countedThread(std::function<void()> work)
{
    // Counted from here on: whoever starts it may ask at once.
    return std::thread([work = std::move(work), counted = std::make_unique<ThreadCount>()]() mutable {
        work();
        work = nullptr;
        counted.reset();
    });
}

bool anyCountedThread()
{
    return countedThreads > 0;
}

} // namespace hairpaint::app
