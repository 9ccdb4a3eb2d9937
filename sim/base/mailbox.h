// Where two threads meet: a slot that holds the latest value.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace hairpaint::sim {

/// Latest wins: a value that was not taken is replaced. Any thread.
template<typename T>
class Mailbox
{
public:
    void put(T value)
    {
        {
            const std::lock_guard lock(m_mutex);
            m_value = std::move(value);
        }
        m_arrived.notify_one();
    }

    /// Changes what lies there, or a new T{} where nothing does: for values that gather until they are taken.
    template<typename Edit>
    void update(Edit&& edit)
    {
        {
            const std::lock_guard lock(m_mutex);
            if (!m_value)
                m_value.emplace();
            std::forward<Edit>(edit)(*m_value);
        }
        m_arrived.notify_one();
    }

    [[nodiscard]] std::optional<T> take()
    {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_value, std::nullopt);
    }

    [[nodiscard]] bool waiting() const ///< Whether a value lies there; another thread may take it at once.
    {
        const std::lock_guard lock(m_mutex);
        return m_value.has_value();
    }

    [[nodiscard]] bool awaited() const ///< Whether a thread is in waitAndTake() and there is nothing to take.
    {
        const std::lock_guard lock(m_mutex);
        return m_awaited && !m_value;
    }

    /// Waits until there is a value.
    [[nodiscard]] T waitAndTake()
    {
        std::unique_lock lock(m_mutex);
        m_awaited = true;
        m_arrived.wait(lock, [this] { return m_value.has_value(); });
        m_awaited = false;
        T value = *std::move(m_value);
        m_value.reset();
        return value;
    }

    /// Waits for a value until `deadline`; none where it passes.
    template<typename Clock, typename Duration>
    [[nodiscard]] std::optional<T> takeUntil(std::chrono::time_point<Clock, Duration> deadline)
    {
        std::unique_lock lock(m_mutex);
        m_arrived.wait_until(lock, deadline, [this] { return m_value.has_value(); });
        return std::exchange(m_value, std::nullopt);
    }

private:
    mutable std::mutex m_mutex;
    std::condition_variable m_arrived;
    std::optional<T> m_value;
    bool m_awaited = false;
};

} // namespace hairpaint::sim
