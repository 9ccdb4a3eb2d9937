// Something that each thread has of its own and that needs a destructor.
#pragma once

#include <functional>
#include <memory>

namespace hairpaint::sim {

/// PerThread without its type. Any thread.
class PerThreadStore
{
public:
    using Make = std::function<std::shared_ptr<void>()>;
    explicit PerThreadStore(Make make);
    ~PerThreadStore();
    PerThreadStore(const PerThreadStore&) = delete;
    PerThreadStore& operator=(const PerThreadStore&) = delete;

    [[nodiscard]] void* here();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// One T for each thread that asks, made when it first does and kept until all are destroyed. For what `thread_local`
/// would do but on Windows, where GCC frees the variables of a thread before their destructors run. Any thread.
template<class T>
class PerThread
{
public:
    [[nodiscard]] T& here() { return *static_cast<T*>(m_store.here()); }

private:
    PerThreadStore m_store{[] { return std::make_shared<T>(); }};
};

} // namespace hairpaint::sim
