// A run of hairpaint-import: requests in, a checked answer out for each, bounded in time and memory.
// The child runs in its own process group, whose whole is killed on timeout, cancelling or nonsense, and at the end.
#pragma once

#include "model/files/project_file.h"
#include "model/files/wire_format.h"

#include <memory>

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

/// Starts the program at the first request, and anew where it has ended; ends it with itself. One thread.
class HelperRun
{
public:
    /// `timeoutMs`: for each request, a start included.
    HelperRun(QString program, int timeoutMs);
    ~HelperRun();
    HelperRun(const HelperRun&) = delete;
    HelperRun& operator=(const HelperRun&) = delete;

    /// Waits until the answer is whole and whatever served the request has ended, so that it can't answer the next one.
    /// `progress` is asked about every 50 ms; it is told the fraction of the answer's bytes received.
    [[nodiscard]] tl::expected<HelperAnswer, HelperFailure> ask(const wire::Bytes& request, const Progress& progress);

private:
    struct Started;

    QString m_program;
    int m_timeoutMs;
    std::unique_ptr<Started> m_started; ///< None where nothing runs.
};

} // namespace hairpaint::model
