// The list, and libseccomp that makes a filter of it. What is in it was seen by strace over the formats that are read
// and written, besides what the C library needs for memory, threads, time and its own end.
#include "app/importer/call_filter.h"

#ifdef HAIRPAINT_HAS_SECCOMP
#include <cerrno>
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>
#endif

namespace hairpaint::importer {

#ifdef HAIRPAINT_HAS_SECCOMP

namespace {

/// An int's: the kernel does not look at the upper half of its register.
constexpr std::uint64_t kWhole = 0xFFFFFFFFU;
constexpr std::uint64_t kPointer = ~std::uint64_t{0};

constexpr ArgumentLimit is(unsigned argument, std::uint64_t value)
{
    return {.argument = argument, .mask = kWhole, .value = value};
}

constexpr ArgumentLimit isNull(unsigned argument)
{
    return {.argument = argument, .mask = kPointer, .value = 0};
}

constexpr ArgumentLimit has(unsigned argument, std::uint64_t none, std::uint64_t all = 0)
{
    return {.argument = argument, .mask = none | all, .value = all};
}

/// Limits the flags of open() to reading. Any flag that is not named here, also a future one, is refused.
constexpr ArgumentLimit isForReading(unsigned argument)
{
    constexpr std::uint64_t kLargeFile = 0100000; // The C library's constant is 0 where it is implied.
    constexpr std::uint64_t kHarmless = O_CLOEXEC | O_DIRECTORY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | kLargeFile;
    return has(argument, kWhole & ~kHarmless);
}

constexpr ArgumentLimit isNoProgram(unsigned argument)
{
    return has(argument, PROT_EXEC);
}

/// Limits the flags of clone() to a thread of this process, in the same namespaces.
constexpr ArgumentLimit isThread(unsigned argument)
{
    constexpr std::uint64_t kSpaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER |
                                      CLONE_NEWPID | CLONE_NEWNET | CLONE_PTRACE | CLONE_VFORK | CLONE_PARENT;
    return has(argument, kSpaces, CLONE_VM | CLONE_SIGHAND | CLONE_THREAD);
}

} // namespace

std::vector<AllowedCall> allowedCalls()
{
    std::vector<AllowedCall> calls;
    // Files, what is open already included.
    for (const int number :
         {SCMP_SYS(read),      SCMP_SYS(readv),      SCMP_SYS(pread64),    SCMP_SYS(preadv),     SCMP_SYS(write),
          SCMP_SYS(writev),    SCMP_SYS(lseek),      SCMP_SYS(close),      SCMP_SYS(fadvise64),  SCMP_SYS(fstat),
          SCMP_SYS(stat),      SCMP_SYS(lstat),      SCMP_SYS(newfstatat), SCMP_SYS(statx),      SCMP_SYS(access),
          SCMP_SYS(faccessat), SCMP_SYS(faccessat2), SCMP_SYS(readlink),   SCMP_SYS(readlinkat), SCMP_SYS(getdents64),
          SCMP_SYS(getcwd)})
        calls.push_back({.number = number, .limits = {}});
    // openat2 has its flags in memory, where no filter sees them; it stays out, as clone3 does.
    calls.push_back({.number = SCMP_SYS(open), .limits = {isForReading(1)}});
    calls.push_back({.number = SCMP_SYS(openat), .limits = {isForReading(2)}});
    // Others of its commands have signals sent, or wait for locks.
    for (const int command : {F_GETFD, F_SETFD, F_GETFL})
        calls.push_back({.number = SCMP_SYS(fcntl), .limits = {is(1, static_cast<std::uint64_t>(command))}});

    // Memory that is never a program.
    for (const int number : {SCMP_SYS(brk), SCMP_SYS(munmap), SCMP_SYS(mremap)})
        calls.push_back({.number = number, .limits = {}});
    for (const int number : {SCMP_SYS(mmap), SCMP_SYS(mprotect)})
        calls.push_back({.number = number, .limits = {isNoProgram(2)}});
    for (const int advice : {MADV_NORMAL, MADV_RANDOM, MADV_SEQUENTIAL, MADV_WILLNEED, MADV_DONTNEED, MADV_FREE,
                             MADV_HUGEPAGE, MADV_NOHUGEPAGE, MADV_DONTDUMP, MADV_DODUMP})
        calls.push_back({.number = SCMP_SYS(madvise), .limits = {is(2, static_cast<std::uint64_t>(advice))}});

    // Threads, time, chance, and what libraries ask of the machine.
    for (const int number : {SCMP_SYS(futex),
                             SCMP_SYS(set_robust_list),
                             SCMP_SYS(rseq),
                             SCMP_SYS(exit),
                             SCMP_SYS(exit_group),
                             SCMP_SYS(getpid),
                             SCMP_SYS(gettid),
                             SCMP_SYS(sched_yield),
                             SCMP_SYS(sched_getaffinity),
                             SCMP_SYS(getcpu),
                             SCMP_SYS(clock_gettime),
                             SCMP_SYS(clock_getres),
                             SCMP_SYS(gettimeofday),
                             SCMP_SYS(time),
                             SCMP_SYS(nanosleep),
                             SCMP_SYS(clock_nanosleep),
                             SCMP_SYS(getrandom),
                             SCMP_SYS(sysinfo),
                             SCMP_SYS(uname),
                             SCMP_SYS(getrlimit)})
        calls.push_back({.number = number, .limits = {}});
    calls.push_back({.number = SCMP_SYS(clone), .limits = {isThread(0)}});
    calls.push_back({.number = SCMP_SYS(prctl), .limits = {is(0, PR_SET_NAME)}});
    // Its own limits, and to be told alone.
    calls.push_back({.number = SCMP_SYS(prlimit64), .limits = {is(0, 0), isNull(2)}});

    // Its own signals: a failed assertion, the sanitizers' handlers.
    for (const int number : {SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn),
                             SCMP_SYS(sigaltstack), SCMP_SYS(restart_syscall)})
        calls.push_back({.number = number, .limits = {}});
    calls.push_back({.number = SCMP_SYS(tgkill), .limits = {is(0, static_cast<std::uint64_t>(::getpid()))}});
#ifdef HAIRPAINT_ASAN
    // The sanitizers try by a pipe whether memory may be read.
    for (const int number : {SCMP_SYS(pipe), SCMP_SYS(pipe2)})
        calls.push_back({.number = number, .limits = {}});
#endif
    return calls;
}

bool filterCalls()
{
    auto* const filter = seccomp_init(SCMP_ACT_ERRNO(ENOSYS));
    if (filter == nullptr)
        return false;
    (void)seccomp_attr_set(filter, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    (void)seccomp_attr_set(filter, SCMP_FLTATR_CTL_TSYNC, 1);
    constexpr std::uint32_t kByTree = 2; // A handful of comparisons a call, not sixty.
    (void)seccomp_attr_set(filter, SCMP_FLTATR_CTL_OPTIMIZE, kByTree);
    // One that this machine does not have can't be added, and is refused like all others.
    for (const AllowedCall& call : allowedCalls()) {
        std::vector<scmp_arg_cmp> limits;
        limits.reserve(call.limits.size());
        for (const ArgumentLimit& limit : call.limits)
            limits.push_back({limit.argument, SCMP_CMP_MASKED_EQ, limit.mask, limit.value});
        (void)seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call.number, static_cast<unsigned>(limits.size()),
                                     limits.data());
    }
    const bool isLoaded = seccomp_load(filter) == 0;
    seccomp_release(filter);
    return isLoaded;
}

#else

std::vector<AllowedCall> allowedCalls()
{
    return {};
}

bool filterCalls()
{
    return false;
}

#endif

} // namespace hairpaint::importer
