// Where two threads meet: a slot that holds the latest value.
#pragma once

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

    [[nodiscard]] std::optional<T> take()
    {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_value, std::nullopt);
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_arrived;
    std::optional<T> m_value;
};

} // namespace hairpaint::sim
