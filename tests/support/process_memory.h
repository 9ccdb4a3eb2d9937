// How much memory a program has.
#pragma once

#include <QtGlobal>

namespace hairpaint::test {

/// What a process holds in memory now, in bytes: on Linux its children too, on Windows what is its own alone.
qint64 residentBytes(qint64 process);

} // namespace hairpaint::test
