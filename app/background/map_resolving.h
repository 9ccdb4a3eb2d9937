// Where a document has its large maps resolved.
#pragma once

#include "app/background/jobs.h"
#include "model/maps/map_resolver.h"

namespace hairpaint::app {

/// By a job of `jobs`. Nobody is told where `receiver` is gone by then; it must not outlive the document. GUI thread.
[[nodiscard]] model::MapResolver::Background resolvedByJobs(Jobs& jobs, QObject* receiver);

} // namespace hairpaint::app
