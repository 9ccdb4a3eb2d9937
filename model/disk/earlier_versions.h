// Earlier versions of a file, kept beside it.
#pragma once

#include "model/values/sentences.h"

#include <QString>

namespace hairpaint::model {

inline constexpr int kEarlierVersions = 3;

/// "Bob~1.hairpaint" of "Bob.hairpaint" is what the file held before it was saved last, up to number kEarlierVersions.
[[nodiscard]] QString earlierVersion(const QString& path, int number);

/// Before `path` is replaced: what it holds becomes its earlier version 1, version 1 becomes 2,
/// and so on; the last one is deleted. Does nothing if there is no such file. `path` itself never changes. Errors:
/// clauses for cannotWrite of the earlier version. Any thread.
[[nodiscard]] Checked<void> keepEarlierVersions(const QString& path);

} // namespace hairpaint::model
