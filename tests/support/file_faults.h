// A disk that fails on order: while one lives, the n-th time that a file is opened for writing, written, flushed or
// renamed fails, on every thread.
#pragma once

#include <QtGlobal>

#ifdef Q_OS_LINUX

namespace hairpaint::test {

/// One at a time. Needs file_faults.cpp, which takes the place of the C library's calls, in a program that exports its
/// symbols.
class FileFault
{
public:
    explicit FileFault(int nth);
    ~FileFault();
    FileFault(const FileFault&) = delete;
    FileFault& operator=(const FileFault&) = delete;

    /// There were so many.
    [[nodiscard]] static bool happened();
};

} // namespace hairpaint::test
#endif
