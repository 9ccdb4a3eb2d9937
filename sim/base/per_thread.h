// Something that each thread has of its own and that needs a destructor.
#pragma once

#include <tbb/enumerable_thread_specific.h>

namespace hairpaint::sim {

/// One T for each thread that asks, made when it first does and kept until all are destroyed. For what `thread_local`
/// would do but on Windows, where GCC frees the variables of a thread before their destructors run. Any thread.
template<class T>
class PerThread
{
public:
    [[nodiscard]] T& here() { return m_all.local(); }

private:
    tbb::enumerable_thread_specific<T> m_all;
};

} // namespace hairpaint::sim
