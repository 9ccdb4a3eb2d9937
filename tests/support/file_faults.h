// A disk that fails on order: while one lives, the n-th time that a file is opened for writing, written, flushed or
// renamed fails, on every thread. Or one that does not answer: whatever is asked of a folder waits. Or a folder that
// takes nothing.
#pragma once

#include <QtGlobal>

#ifdef Q_OS_LINUX

namespace hairpaint::test {

/// One at a time. Needs file_faults.cpp, which replaces the C library's calls, in a program that exports its
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

/// What threads ask of files below a folder waits until it goes, as where a server does not answer; what the main
/// thread asks is counted instead, and goes through. One at a time.
class FileStall
{
public:
    /// `call`: the only one that waits, as "fsync".
    explicit FileStall(const char* folder, const char* call = nullptr);
    ~FileStall();
    FileStall(const FileStall&) = delete;
    FileStall& operator=(const FileStall&) = delete;

    [[nodiscard]] static int waiting();            ///< Threads.
    [[nodiscard]] static int askedByMain();        ///< Calls.
    [[nodiscard]] static const char* lastByMain(); ///< Name of the last of those calls; of static lifetime.
};

/// A folder in which nothing can be changed, or made, for root neither. One at a time.
class FileRefusal
{
public:
    enum class Why
    {
        ReadOnly,
        Full ///< What is there can be removed and renamed.
    };
    FileRefusal(const char* folder, Why why);
    ~FileRefusal();
    FileRefusal(const FileRefusal&) = delete;
    FileRefusal& operator=(const FileRefusal&) = delete;
};

} // namespace hairpaint::test
#endif
