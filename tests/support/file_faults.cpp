// The system's calls, and one of them that does not come so far.
#include "tests/support/file_faults.h"

#ifdef Q_OS_LINUX

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

std::atomic<bool> isCounting{false};
std::atomic<int> callsUntilFault{0};

bool isFileFault(int error)
{
    if (!isCounting || callsUntilFault.fetch_sub(1) != 1)
        return false;
    errno = error;
    return true;
}

/// Pipes and sockets wake threads; they belong to no file.
bool isOrdinaryFile(int descriptor)
{
    struct stat status = {};
    return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

int openAt(int folder, const char* path, int flags, mode_t mode)
{
    if ((flags & (O_WRONLY | O_RDWR | O_CREAT)) != 0 && isFileFault(EACCES))
        return -1;
    return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
}

mode_t modeOf(int flags, std::va_list arguments)
{
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

} // namespace

extern "C" int open(const char* path, int flags, ...)
{
    std::va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = modeOf(flags, arguments);
    va_end(arguments);
    return openAt(AT_FDCWD, path, flags, mode);
}

extern "C" int open64(const char* path, int flags, ...)
{
    std::va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = modeOf(flags, arguments);
    va_end(arguments);
    return openAt(AT_FDCWD, path, flags, mode);
}

extern "C" ssize_t write(int descriptor, const void* bytes, size_t count)
{
    if (isCounting && isOrdinaryFile(descriptor) && isFileFault(ENOSPC))
        return -1;
    return syscall(SYS_write, descriptor, bytes, count);
}

extern "C" int fsync(int descriptor)
{
    return isFileFault(EIO) ? -1 : static_cast<int>(syscall(SYS_fsync, descriptor));
}

extern "C" int fdatasync(int descriptor)
{
    return isFileFault(EIO) ? -1 : static_cast<int>(syscall(SYS_fdatasync, descriptor));
}

extern "C" int rename(const char* from, const char* to) noexcept
{
    return isFileFault(EACCES) ? -1 : static_cast<int>(syscall(SYS_rename, from, to));
}

extern "C" int renameat2(int fromFolder, const char* from, int toFolder, const char* to, unsigned flags) noexcept
{
    return isFileFault(EACCES) ? -1 : static_cast<int>(syscall(SYS_renameat2, fromFolder, from, toFolder, to, flags));
}

extern "C" int link(const char* from, const char* to) noexcept
{
    return isFileFault(EPERM) ? -1 : static_cast<int>(syscall(SYS_link, from, to));
}

extern "C" int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags) noexcept
{
    return isFileFault(EPERM) ? -1 : static_cast<int>(syscall(SYS_linkat, fromFolder, from, toFolder, to, flags));
}

namespace hairpaint::test {

FileFault::FileFault(int nth)
{
    callsUntilFault = nth;
    isCounting = true;
}

FileFault::~FileFault()
{
    isCounting = false;
}

bool FileFault::happened()
{
    return callsUntilFault <= 0;
}

} // namespace hairpaint::test
#endif
