// Where a document has its large maps resolved.
#pragma once

#include "app/background/jobs.h"
#include "model/maps/map_resolver.h"

namespace hairpaint::app {

/// Resolves in a job of `jobs`. If `receiver` no longer exists, nothing is reported; it must not outlive the document.
/// GUI thread.
[[nodiscard]] model::MapResolver::Background resolvedByJobs(Jobs& jobs, QObject* receiver);

} // namespace hairpaint::app
