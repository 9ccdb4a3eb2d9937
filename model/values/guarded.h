// Exceptions end here: what throws on a thread of work, most likely for want of memory, becomes an error in words.
#pragma once

#include "model/values/error.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <type_traits>

namespace hairpaint::model {

/// What `work` returns; what `instead` returns where memory runs out. A container asked for more than it can ever hold
/// throws length_error, and files may ask for that. Any thread.
template<typename Work, typename Instead>
[[nodiscard]] std::invoke_result_t<const Work&> whereMemoryLasts(const Work& work, const Instead& instead)
{
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return instead();
    } catch (const std::length_error&) {
        return instead();
    }
}

/// One sentence each. `doing` begins it: what was under way, the file named ("Reading head.glb").
[[nodiscard]] Error memoryError(const QString& doing);
[[nodiscard]] Error thrownError(const QString& doing, const std::exception& thrown);

/// What `work` returns, a Result; an error where it throws. Any thread.
template<typename Work>
[[nodiscard]] std::invoke_result_t<const Work&> guarded(const QString& doing, const Work& work)
{
    try {
        return whereMemoryLasts(work, [&doing] { return tl::unexpected(memoryError(doing)); });
    } catch (const std::exception& thrown) {
        return tl::unexpected(thrownError(doing, thrown));
    }
}

} // namespace hairpaint::model
