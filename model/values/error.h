// What went wrong outside the program, in one sentence for the user.
#pragma once

#include <QString>

#include <tl/expected.hpp>

namespace hairpaint::model {

/// `message` is one whole translated sentence: what happened, to which file, and what to do.
struct Error
{
    QString message;
    bool isDamage = false; ///< Of a file of ours, of which some may still be read.
};

template<typename T>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> failure(QString message)
{
    return tl::unexpected<Error>(Error{.message = std::move(message)});
}

} // namespace hairpaint::model
