// What is made from something that does not change, made once and kept as long as that lives.
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

namespace hairpaint::sim {

/// One Value for each Key that is alive. A value whose key is gone is freed by the next call. Any thread.
template<typename Key, typename Value>
class KeptWith
{
public:
    using KeyPtr = std::shared_ptr<const Key>;
    using ValuePtr = std::shared_ptr<const Value>;

    /// `make(const Key&)` gives the value, as a ValuePtr, where there is none yet. It is called without a lock, since a
    /// thread that waits for its own loops may take up other work meanwhile: two threads that ask for the same at once
    /// may both make it, and both get the one that was ready first. What it throws goes to the caller.
    template<typename Make>
    [[nodiscard]] ValuePtr of(const KeyPtr& key, const Make& make)
    {
        if (ValuePtr known = keptOr(key, nullptr))
            return known;
        return keptOr(key, make(*key));
    }

private:
    struct Entry
    {
        std::weak_ptr<const Key> key;
        ValuePtr value;
    };

    /// That of the key, `made` where it has none; null where that is null, too.
    ValuePtr keptOr(const KeyPtr& key, ValuePtr made)
    {
        const std::lock_guard lock(m_mutex);
        std::erase_if(m_entries, [](const Entry& entry) { return entry.key.expired(); });
        const auto found = std::ranges::find_if(m_entries, [&key](const Entry& e) { return e.key.lock() == key; });
        if (found != m_entries.end())
            return found->value;
        if (made)
            m_entries.push_back({key, made});
        return made;
    }

    std::mutex m_mutex;
    std::vector<Entry> m_entries; ///< A few.
};

} // namespace hairpaint::sim
