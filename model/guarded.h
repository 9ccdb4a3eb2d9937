// Exceptions end here: what throws on a thread of work, most likely for want of memory, becomes an error in words.
#pragma once

#include "model/error.h"

#include <exception>
#include <type_traits>

namespace hairpaint::model {

/// Within a catch block: what was caught, as one sentence. `doing` begins it: what was under way, the file named
/// ("Reading head.glb").
[[nodiscard]] Error caughtError(const QString& doing);

/// What `work` returns, a Result; an error where it throws. Any thread.
template<typename Work>
[[nodiscard]] std::invoke_result_t<const Work&> guarded(const QString& doing, const Work& work)
{
    try {
        return work();
    } catch (const std::exception&) {
        return tl::unexpected(caughtError(doing));
    }
}

} // namespace hairpaint::model
