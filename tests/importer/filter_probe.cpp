// A tracer and the child that it asks through.
#include "tests/importer/filter_probe.h"

#ifdef HAIRPAINT_HAS_FILTER_PROBE
#include "app/importer/sandbox.h"

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hairpaint::test {

namespace {

constexpr unsigned long kMark = 0x48616972; // "Hair"
constexpr int kAnswer = EXFULL;             // No call fails with it.

/// Calls with the mark go to the tracer, all others to the kernel.
bool handMarkedCallsToTracer()
{
    constexpr unsigned kSixth = offsetof(seccomp_data, args) + 5 * sizeof(__u64);
    std::array<sock_filter, 4> program{{{BPF_LD | BPF_W | BPF_ABS, 0, 0, kSixth},
                                        {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, kMark},
                                        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_TRACE},
                                        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW}}};
    const sock_fprog filter{program.size(), program.data()};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

[[noreturn]] void askAll(const std::vector<Call>& calls, const std::function<void()>& become, Verdict* verdicts)
{
    if (become)
        become();
    if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0 || ::raise(SIGSTOP) != 0 || !handMarkedCallsToTracer())
        ::_exit(1);
    (void)importer::enterSandbox({});
    for (std::size_t i = 0; i < calls.size(); ++i) {
        const auto& arguments = calls[i].arguments;
        const long result =
            ::syscall(calls[i].number, arguments[0], arguments[1], arguments[2], arguments[3], arguments[4], kMark);
        verdicts[i] = result != -1       ? Verdict::Other
                      : errno == kAnswer ? Verdict::Allowed
                      : errno == ENOSYS  ? Verdict::Refused
                                         : Verdict::Other;
    }
    // Not by _exit, which would leave the mark of the last call standing.
    (void)::syscall(SYS_exit_group, 0, 0, 0, 0, 0, 0);
    ::abort();
}

/// Answers for the kernel until the child has ended; false where it did not end well.
bool answerFor(pid_t child)
{
    int status = 0;
    if (::waitpid(child, &status, 0) != child || !WIFSTOPPED(status))
        return false;
    ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESECCOMP | PTRACE_O_EXITKILL);
    for (long signal = 0;;) {
        ::ptrace(PTRACE_CONT, child, nullptr, signal);
        if (::waitpid(child, &status, 0) != child)
            return false;
        if (!WIFSTOPPED(status))
            return WIFEXITED(status) && WEXITSTATUS(status) == 0;
        const bool isCall = status >> 8 == (SIGTRAP | PTRACE_EVENT_SECCOMP << 8);
        signal = isCall ? 0 : WSTOPSIG(status);
        if (!isCall)
            continue;
        user_regs_struct registers{};
        ::ptrace(PTRACE_GETREGS, child, nullptr, &registers);
        registers.orig_rax = ~0ULL; // No call at all.
        registers.rax = static_cast<unsigned long long>(-kAnswer);
        ::ptrace(PTRACE_SETREGS, child, nullptr, &registers);
    }
}

} // namespace

std::optional<std::vector<Verdict>> probe(const std::vector<Call>& calls, const std::function<void()>& become)
{
    const std::size_t bytes = calls.size() * sizeof(Verdict);
    void* const shared = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED)
        return std::nullopt;
    auto* const verdicts = static_cast<Verdict*>(shared);
    const pid_t child = ::fork();
    if (child == 0)
        askAll(calls, become, verdicts);
    const bool isAnswered = child > 0 && answerFor(child);
    std::optional<std::vector<Verdict>> told;
    if (isAnswered)
        told.emplace(verdicts, verdicts + calls.size());
    ::munmap(shared, bytes);
    return told;
}

} // namespace hairpaint::test
#endif
