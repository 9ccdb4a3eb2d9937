// Landlock and seccomp by their system calls: the C library has no functions for them.
#include "app/importer/sandbox.h"

#if defined(__linux__) && defined(__x86_64__) && __has_include(<linux/landlock.h>)
#define HAIRPAINT_HAS_SANDBOX
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace hairpaint::importer {

#ifdef HAIRPAINT_HAS_SANDBOX

namespace {

constexpr std::uint64_t kRead = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
/// Everything about files that the first version of Landlock can forbid; opening for reading is given back below.
constexpr std::uint64_t kEverything =
    kRead | LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
    LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR |
    LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
    LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;

void allowReading(int rules, const char* folder)
{
    const int file = ::open(folder, O_PATH | O_CLOEXEC);
    if (file < 0)
        return;
    landlock_path_beneath_attr beneath{};
    beneath.allowed_access = kRead;
    beneath.parent_fd = file;
    ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0);
    ::close(file);
}

void confineFiles(const std::string& folder)
{
    landlock_ruleset_attr attributes{};
    attributes.handled_access_fs = kEverything;
    const auto rules = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0));
    if (rules < 0)
        return;
    for (const char* library : {"/usr", "/lib", "/lib64"})
        allowReading(rules, library);
    // Threads ask how many processors there are.
    allowReading(rules, "/sys/devices/system/cpu");
    allowReading(rules, "/sys/fs/cgroup");
    if (!folder.empty())
        allowReading(rules, folder.c_str());
    ::syscall(SYS_landlock_restrict_self, rules, 0);
    ::close(rules);
}

/// Numbers of system calls that no decoder needs.
constexpr std::array kForbidden = {
    SYS_socket,
    SYS_socketpair,
    SYS_connect,
    SYS_bind,
    SYS_listen,
    SYS_accept,
    SYS_accept4,
    SYS_sendto,
    SYS_sendmsg,
    SYS_execve,
    SYS_execveat,
    SYS_fork,
    SYS_vfork,
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_kill,
    SYS_process_vm_writev,
    SYS_tkill,
    SYS_pidfd_open,
    SYS_pidfd_send_signal,
    SYS_mount,
    SYS_umount2,
    SYS_unshare,
    SYS_setns,
    SYS_bpf,
    SYS_perf_event_open,
    SYS_keyctl,
    SYS_add_key,
    SYS_request_key,
    SYS_chmod,
    SYS_fchmod,
    SYS_fchmodat,
    SYS_chown,
    SYS_fchown,
    SYS_fchownat,
    SYS_truncate,
    SYS_io_uring_setup,
    SYS_userfaultfd,
    SYS_link,
    SYS_linkat,
    SYS_setxattr,
};

void confineCalls()
{
    constexpr std::uint32_t kArchitecture = offsetof(seccomp_data, arch);
    constexpr std::uint32_t kNumber = offsetof(seccomp_data, nr);
    constexpr std::uint32_t kFlags = offsetof(seccomp_data, args); // of clone: its first argument's lower half
    constexpr std::uint32_t kOtherAbi = 0x40000000;                // x32's calls
    constexpr std::uint32_t kRefuse = SECCOMP_RET_ERRNO | EPERM;
    constexpr std::size_t kFixed = 13;
    std::array<sock_filter, kFixed + 2 * kForbidden.size()> program{};
    std::size_t size = 0;
    const auto load = [&](std::uint32_t offset) { program[size++] = {BPF_LD | BPF_W | BPF_ABS, 0, 0, offset}; };
    const auto answer = [&](std::uint32_t value) { program[size++] = {BPF_RET | BPF_K, 0, 0, value}; };
    /// The next instruction is for that value alone.
    const auto ifEqual = [&](std::uint32_t value) { program[size++] = {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, value}; };

    load(kArchitecture);
    program[size++] = {BPF_JMP | BPF_JEQ | BPF_K, 1, 0, AUDIT_ARCH_X86_64};
    answer(SECCOMP_RET_KILL_PROCESS);
    load(kNumber);
    program[size++] = {BPF_JMP | BPF_JGE | BPF_K, 0, 1, kOtherAbi};
    answer(SECCOMP_RET_KILL_PROCESS);
    for (const long number : kForbidden) {
        ifEqual(static_cast<std::uint32_t>(number));
        answer(kRefuse);
    }
    // Threads, but no processes. The newer call hides its flags from filters: without it the older one is used.
    ifEqual(static_cast<std::uint32_t>(SYS_clone3));
    answer(SECCOMP_RET_ERRNO | ENOSYS);
    program[size++] = {BPF_JMP | BPF_JEQ | BPF_K, 0, 3, static_cast<std::uint32_t>(SYS_clone)};
    load(kFlags);
    program[size++] = {BPF_JMP | BPF_JSET | BPF_K, 1, 0, CLONE_THREAD};
    answer(kRefuse);
    answer(SECCOMP_RET_ALLOW);
    const sock_fprog filter{static_cast<unsigned short>(size), program.data()};
    ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

} // namespace

void enterSandbox(const std::string& folder)
{
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        return;
    confineFiles(folder);
    confineCalls();
}

#else

void enterSandbox(const std::string& /*folder*/) {}

#endif

} // namespace hairpaint::importer
