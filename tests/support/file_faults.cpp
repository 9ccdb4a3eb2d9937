// The system's calls, and one of them that does not come so far.
#include "tests/support/file_faults.h"

#ifdef Q_OS_LINUX

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

std::atomic<bool> isCounting{false};
std::atomic<int> callsUntilFault{0};

std::atomic<const char*> stalledFolder{nullptr};
std::atomic<const char*> stalledCall{nullptr};
std::atomic<int> waitingThreads{0};
std::atomic<int> mainThreadCalls{0};
std::atomic<const char*> lastMainCall{""};

/// Nothing that may lock or allocate: it stands in for calls of the C library.
void stallAt(const char* call, const char* path)
{
    const char* folder = stalledFolder;
    if (folder == nullptr || path == nullptr || std::strncmp(path, folder, std::strlen(folder)) != 0)
        return;
    if (getpid() == static_cast<pid_t>(syscall(SYS_gettid))) {
        lastMainCall = call;
        ++mainThreadCalls;
        return;
    }
    if (const char* only = stalledCall; only != nullptr && std::strcmp(only, call) != 0)
        return;
    constexpr useconds_t kMicrosecondsBetweenLooks = 2000;
    ++waitingThreads;
    while (stalledFolder != nullptr)
        usleep(kMicrosecondsBetweenLooks);
    --waitingThreads;
}

void stallAt(const char* call, int descriptor)
{
    if (stalledFolder == nullptr)
        return;
    std::array<char, 64> link{};
    std::array<char, 4096> path{};
    std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", descriptor);
    if (syscall(SYS_readlink, link.data(), path.data(), path.size() - 1) > 0)
        stallAt(call, path.data());
}

std::atomic<const char*> refusingFolder{nullptr};
std::atomic<bool> refusesRemoval{false};

bool isBelow(const char* path, const char* folder)
{
    return folder != nullptr && std::strncmp(path, folder, std::strlen(folder)) == 0;
}

/// `path` may be relative to an open folder.
bool isRefusing(int at, const char* path)
{
    const char* folder = refusingFolder;
    if (folder == nullptr || path == nullptr)
        return false;
    if (path[0] == '/')
        return isBelow(path, folder);
    std::array<char, 64> link{};
    std::array<char, 4096> whole{};
    std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", at);
    return syscall(SYS_readlink, link.data(), whole.data(), whole.size() - 1) > 0 && isBelow(whole.data(), folder);
}

/// As the kernel has it: what is wrong with the name comes first.
bool refusesOpening(int at, const char* path, int flags)
{
    if ((flags & (O_WRONLY | O_RDWR | O_CREAT)) == 0 || !isRefusing(at, path))
        return false;
    struct stat status = {};
    const bool exists = syscall(SYS_newfstatat, at, path, &status, AT_SYMLINK_NOFOLLOW) == 0;
    const bool makes = (flags & O_CREAT) != 0 && !exists;
    if (exists && (flags & O_CREAT) != 0 && (flags & O_EXCL) != 0)
        errno = EEXIST;
    else if (!exists && !makes && (flags & O_TMPFILE) != O_TMPFILE)
        errno = ENOENT;
    else if (refusesRemoval)
        errno = EROFS;
    else if (makes || (flags & O_TMPFILE) == O_TMPFILE)
        errno = ENOSPC;
    else
        return false;
    return true;
}

bool refusesChange(int at, const char* path, bool makes)
{
    if (!isRefusing(at, path) || (!makes && !refusesRemoval))
        return false;
    struct stat status = {};
    const bool exists = syscall(SYS_newfstatat, at, path, &status, AT_SYMLINK_NOFOLLOW) == 0;
    errno = makes && exists ? EEXIST : refusesRemoval ? EROFS : ENOSPC;
    return true;
}

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
    stallAt("open", path);
    if (refusesOpening(folder, path, flags))
        return -1;
    if ((flags & (O_WRONLY | O_RDWR | O_CREAT)) != 0 && isFileFault(EACCES))
        return -1;
    return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
}

bool hasMode(int flags)
{
    return (flags & (O_CREAT | O_TMPFILE)) != 0;
}

} // namespace

extern "C" int open(const char* path, int flags, ...)
{
    std::va_list arguments;
    va_start(arguments, flags);
    // The analyzer does not see where it begins. NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized)
    const mode_t mode = hasMode(flags) ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    return openAt(AT_FDCWD, path, flags, mode);
}

extern "C" int open64(const char* path, int flags, ...)
{
    std::va_list arguments;
    va_start(arguments, flags);
    // The analyzer does not see where it begins. NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized)
    const mode_t mode = hasMode(flags) ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    return openAt(AT_FDCWD, path, flags, mode);
}

extern "C" int openat(int folder, const char* path, int flags, ...)
{
    std::va_list arguments;
    va_start(arguments, flags);
    // The analyzer does not see where it begins. NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized)
    const mode_t mode = hasMode(flags) ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    return openAt(folder, path, flags, mode);
}

extern "C" int openat64(int folder, const char* path, int flags, ...)
{
    std::va_list arguments;
    va_start(arguments, flags);
    // The analyzer does not see where it begins. NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized)
    const mode_t mode = hasMode(flags) ? va_arg(arguments, mode_t) : 0;
    va_end(arguments);
    return openAt(folder, path, flags, mode);
}

extern "C" int mkdir(const char* path, mode_t mode) noexcept
{
    return refusesChange(AT_FDCWD, path, true) ? -1 : static_cast<int>(syscall(SYS_mkdir, path, mode));
}

extern "C" int mkdirat(int folder, const char* path, mode_t mode) noexcept
{
    return refusesChange(folder, path, true) ? -1 : static_cast<int>(syscall(SYS_mkdirat, folder, path, mode));
}

extern "C" int unlink(const char* path) noexcept
{
    return refusesChange(AT_FDCWD, path, false) ? -1 : static_cast<int>(syscall(SYS_unlink, path));
}

extern "C" int unlinkat(int folder, const char* path, int flags) noexcept
{
    return refusesChange(folder, path, false) ? -1 : static_cast<int>(syscall(SYS_unlinkat, folder, path, flags));
}

extern "C" int rmdir(const char* path) noexcept
{
    return refusesChange(AT_FDCWD, path, false) ? -1 : static_cast<int>(syscall(SYS_rmdir, path));
}

extern "C" int renameat(int fromFolder, const char* from, int toFolder, const char* to) noexcept
{
    if (refusesChange(toFolder, to, false) || isFileFault(EACCES))
        return -1;
    return static_cast<int>(syscall(SYS_renameat, fromFolder, from, toFolder, to));
}

extern "C" ssize_t write(int descriptor, const void* bytes, size_t count)
{
    stallAt("write", descriptor);
    if (isRefusing(descriptor, "")) {
        errno = refusesRemoval ? EROFS : ENOSPC;
        return -1;
    }
    if (isCounting && isOrdinaryFile(descriptor) && isFileFault(ENOSPC))
        return -1;
    return syscall(SYS_write, descriptor, bytes, count);
}

extern "C" int fsync(int descriptor)
{
    stallAt("fsync", descriptor);
    return isFileFault(EIO) ? -1 : static_cast<int>(syscall(SYS_fsync, descriptor));
}

extern "C" int fdatasync(int descriptor)
{
    return isFileFault(EIO) ? -1 : static_cast<int>(syscall(SYS_fdatasync, descriptor));
}

extern "C" int rename(const char* from, const char* to) noexcept
{
    stallAt("rename", to);
    if (refusesChange(AT_FDCWD, to, false))
        return -1;
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

extern "C" int statx(int folder, const char* path, int flags, unsigned mask, struct statx* status) noexcept
{
    stallAt("statx", path);
    return static_cast<int>(syscall(SYS_statx, folder, path, flags, mask, status));
}

extern "C" int access(const char* path, int mode) noexcept
{
    stallAt("access", path);
    return static_cast<int>(syscall(SYS_access, path, mode));
}

extern "C" ssize_t readlink(const char* path, char* target, size_t size) noexcept
{
    stallAt("readlink", path);
    return syscall(SYS_readlink, path, target, size);
}

extern "C" int inotify_add_watch(int descriptor, const char* path, uint32_t mask) noexcept
{
    stallAt("inotify_add_watch", path);
    return static_cast<int>(syscall(SYS_inotify_add_watch, descriptor, path, mask));
}

namespace hairpaint::test {

FileStall::FileStall(const char* folder, const char* call)
{
    mainThreadCalls = 0;
    stalledCall = call;
    stalledFolder = folder;
}

FileStall::~FileStall()
{
    stalledFolder = nullptr;
}

int FileStall::waiting()
{
    return waitingThreads;
}

int FileStall::askedByMain()
{
    return mainThreadCalls;
}

const char* FileStall::lastByMain()
{
    return lastMainCall;
}

FileRefusal::FileRefusal(const char* folder, Why why)
{
    refusesRemoval = why == Why::ReadOnly;
    refusingFolder = folder;
}

FileRefusal::~FileRefusal()
{
    refusingFolder = nullptr;
}

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
