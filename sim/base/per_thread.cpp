// By oneTBB, whose headers take words of ours on Windows and so stay here.
#include "sim/base/per_thread.h"

#include <tbb/enumerable_thread_specific.h>

#include <memory>
#include <utility>

namespace hairpaint::sim {

struct PerThreadStore::State
{
    explicit State(Make make) : all(std::move(make)) {}
    /// In the program's own memory: what lies in oneTBB's pools, a leak checker takes for lost.
    tbb::enumerable_thread_specific<std::shared_ptr<void>, std::allocator<std::shared_ptr<void>>> all;
};

PerThreadStore::PerThreadStore(Make make) : m_state(std::make_unique<State>(std::move(make))) {}

PerThreadStore::~PerThreadStore() = default;

void* PerThreadStore::here()
{
    return m_state->all.local().get();
}

} // namespace hairpaint::sim
