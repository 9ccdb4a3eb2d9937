// Resolving as a job.
#include "app/background/map_resolving.h"

#include <utility>

namespace hairpaint::app {

model::MapResolver::Background resolvedByJobs(Jobs& jobs, QObject* receiver)
{
    return [&jobs, receiver](std::function<void()> work, std::function<void(bool)> done) {
        jobs.start<void>(
            {}, // Nobody reads why it failed: the resolver does it again.
            [work = std::move(work)](const model::Progress&) -> model::Result<void> {
                work();
                return {};
            },
            receiver, [done = std::move(done)](const model::Result<void>& worked) { done(worked.has_value()); });
    };
}

} // namespace hairpaint::app
