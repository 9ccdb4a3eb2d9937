// What went wrong outside the program, in one sentence for the user.
#pragma once

#include <QString>

#include <tl/expected.hpp>

namespace hairpaint::model {

/// `message` is one whole translated sentence: what happened, to which file, and what to do.
struct Error
{
    QString message;
    /// Whether a file of the program's own formats is damaged, and some of it may still be read.
    bool isDamage = false;
};

template<typename T>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> failure(QString message)
{
    return tl::unexpected<Error>(Error{.message = std::move(message)});
}

} // namespace hairpaint::model
