// One run of hairpaint-import: a request in, a checked answer out, bounded in time and memory.
// Any thread. The child runs in its own process group, whose whole is killed on timeout, cancelling or nonsense.
#pragma once

#include "model/files/project_file.h"
#include "model/files/wire_format.h"

namespace hairpaint::model {

enum class HelperFailure : std::uint8_t
{
    NotStarted,
    Crashed,
    TimedOut,
    Nonsense,
    Cancelled
};

struct HelperAnswer
{
    wire::Kind kind = wire::Kind::Refusal;
    wire::Bytes body;
};

/// `progress` is asked about every 50 ms; it is told the fraction of the answer's bytes received.
[[nodiscard]] tl::expected<HelperAnswer, HelperFailure> runHelper(const QString& program, const wire::Bytes& request,
                                                                  int timeoutMs, const Progress& progress);

} // namespace hairpaint::model
