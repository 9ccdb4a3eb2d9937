// The list of system calls against what the kernel says: every number there is, with arguments of all kinds.
#include "app/importer/call_filter.h"
#include "app/importer/sandbox.h"
#include "tests/importer/filter_probe.h"
#include "tests/importer/sandbox_users.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <optional>
#include <random>

#ifdef HAIRPAINT_HAS_FILTER_PROBE
#include <array>
#include <csignal>
#include <fcntl.h>
#include <functional>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace hairpaint;
using namespace hairpaint::test;

class TestCallFilter : public QObject
{
    Q_OBJECT
#ifdef HAIRPAINT_HAS_FILTER_PROBE
private:
    template<typename Act>
    bool diesInSandbox(const Act& act)
    {
        const pid_t child = ::fork();
        if (child == 0) {
            const rlimit none{};
            (void)::setrlimit(RLIMIT_CORE, &none);
            // So a kernel without calls of 32 bits answers them; a sanitizer's handler would exit instead of dying.
            (void)::signal(SIGSEGV, SIG_DFL);
            (void)importer::enterSandbox({});
            act();
            ::_exit(0);
        }
        int status = -1;
        ::waitpid(child, &status, 0);
        return WIFSIGNALED(status);
    }

    static std::vector<test::Call> argumentsOfAllKinds()
    {
        std::vector<test::Call> calls(3);
        calls[1].arguments.fill(~0UL);
        calls[2].arguments.fill(static_cast<unsigned long>(::getpid()));
        // Every bit alone, in each argument, and a few of any.
        for (std::size_t argument = 0; argument < 3; ++argument)
            for (unsigned bit = 0; bit < 33; ++bit)
                calls.emplace_back().arguments.at(argument) = 1UL << bit;
        std::mt19937_64 random(1);
        for (int i = 0; i < 12; ++i)
            for (unsigned long& argument : calls.emplace_back().arguments) {
                argument = random(); // Half of its bits, then a quarter.
                argument &= random();
            }
        return calls;
    }

    static bool isOnList(const std::vector<importer::AllowedCall>& list, const test::Call& call)
    {
        return std::ranges::any_of(list, [&call](const importer::AllowedCall& allowed) {
            return allowed.number == call.number &&
                   std::ranges::all_of(allowed.limits, [&call](const importer::ArgumentLimit& limit) {
                       return (call.arguments.at(limit.argument) & limit.mask) == limit.value;
                   });
        });
    }

    /// What the kernel says otherwise than the list; empty where they agree.
    QString faultOfList(const std::vector<test::Call>& calls, bool asNobody)
    {
        const auto verdicts = test::probe(calls, asNobody ? std::function<void()>(becomeNobody) : nullptr);
        if (!verdicts)
            return QStringLiteral("The kernel was not asked to the end.");
        // A process's number is in the list, and those of the child and of this one differ: none of these calls has the
        // child's.
        const std::vector<importer::AllowedCall> list = importer::allowedCalls();
        std::size_t allowed = 0;
        for (std::size_t i = 0; i < calls.size(); ++i) {
            const bool expected = isOnList(list, calls[i]) && calls[i].number != SYS_tgkill;
            if (((*verdicts)[i] == test::Verdict::Allowed) != expected)
                return QStringLiteral("Call %1 (%2, %3, %4) is %5")
                    .arg(calls[i].number)
                    .arg(calls[i].arguments[0], 0, 16)
                    .arg(calls[i].arguments[1], 0, 16)
                    .arg(calls[i].arguments[2], 0, 16)
                    .arg(expected ? QStringLiteral("refused") : QStringLiteral("allowed"));
            allowed += expected ? 1 : 0;
        }
        return allowed > 0 ? QString() : QStringLiteral("Nothing was allowed.");
    }

private Q_SLOTS:
    void theKernelAllowsTheListAndNothingElse_data()
    {
        addUsers();
    }

    /// Every number there is, and twice as many that there are not yet, each with arguments of all kinds.
    void theKernelAllowsTheListAndNothingElse()
    {
        QFETCH(bool, asNobody);
        if (!filtersCalls())
            QSKIP(kNoFilter);
        constexpr int kNumbers = 1024;
        const std::vector<test::Call> arguments = argumentsOfAllKinds();
        std::vector<test::Call> calls;
        for (int number = 0; number < kNumbers; ++number) {
            // uretprobe and uprobe, which Linux 6.14 and later ask no filter about; outside of the kernel's own
            // trampolines they only end the process.
            if (number == 335 || number == 336)
                continue;
            for (test::Call call : arguments) {
                call.number = number;
                calls.push_back(call);
            }
        }
        QCOMPARE(faultOfList(calls, asNobody), QString());
    }

    void argumentsLimitWhatIsAllowed_data()
    {
        using U = unsigned long;
        QTest::addColumn<test::Call>("call");
        QTest::addColumn<bool>("allowed");
        const auto row = [](const char* name, bool allowed, long number, std::array<U, 5> arguments) {
            QTest::newRow(name) << test::Call{.number = number, .arguments = arguments} << allowed;
        };
        constexpr U kThread = CLONE_VM | CLONE_FS | CLONE_FILES | CLONE_SIGHAND | CLONE_THREAD | CLONE_SYSVSEM |
                              CLONE_SETTLS | CLONE_PARENT_SETTID | CLONE_CHILD_CLEARTID;
        row("open for reading", true, SYS_open, {1, O_RDONLY | O_CLOEXEC});
        row("openat for reading", true, SYS_openat, {1, 1, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_DIRECTORY});
        row("open for writing", false, SYS_open, {1, O_WRONLY});
        row("open for both", false, SYS_openat, {1, 1, O_RDWR});
        row("open for neither", false, SYS_openat, {1, 1, O_ACCMODE});
        row("open and empty", false, SYS_open, {1, O_RDONLY | O_TRUNC});
        row("openat and empty", false, SYS_openat, {1, 1, O_RDONLY | O_TRUNC});
        row("open and create", false, SYS_openat, {1, 1, O_RDONLY | O_CREAT});
        row("open a nameless file", false, SYS_openat, {1, 1, O_TMPFILE | O_RDWR});
        row("open with a flag of the future", false, SYS_openat, {1, 1, O_RDONLY | 1U << 30U});
        row("open with rubbish above its flags", true, SYS_openat, {1, 1, 7UL << 32U | O_RDONLY});
        row("open for writing with rubbish above its flags", false, SYS_openat, {1, 1, 7UL << 32U | O_WRONLY});
        row("memory", true, SYS_mmap, {0, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS});
        row("memory as a program", false, SYS_mmap, {0, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE});
        row("memory becomes a program", false, SYS_mprotect, {0, 4096, PROT_EXEC});
        row("memory is given back", true, SYS_madvise, {0, 4096, MADV_DONTNEED});
        row("memory is poisoned", false, SYS_madvise, {0, 4096, MADV_HWPOISON});
        row("a thread", true, SYS_clone, {kThread});
        row("a process", false, SYS_clone, {SIGCHLD});
        row("a thread in a space of its own", false, SYS_clone, {kThread | CLONE_NEWUSER});
        row("a name", true, SYS_prctl, {PR_SET_NAME});
        row("a lasting process", false, SYS_prctl, {PR_SET_PDEATHSIG});
        row("a second filter", false, SYS_prctl, {PR_SET_SECCOMP});
        row("its own limits", true, SYS_prlimit64, {0, RLIMIT_STACK, 0, 1});
        row("other limits for itself", false, SYS_prlimit64, {0, RLIMIT_STACK, 1, 0});
        row("the parent's limits", false, SYS_prlimit64, {static_cast<U>(::getpid()), RLIMIT_STACK, 0, 1});
        row("a signal to the parent", false, SYS_tgkill, {static_cast<U>(::getpid()), static_cast<U>(::getpid()), 9});
        row("whether a file is closed for programs", true, SYS_fcntl, {2, F_GETFD});
        row("who gets a file's signals", false, SYS_fcntl, {2, F_SETOWN});
        row("which signal that is", false, SYS_fcntl, {2, F_SETSIG});
        row("a lock", false, SYS_fcntl, {2, F_SETLKW});
        row("a key typed into a terminal", false, SYS_ioctl, {0, 0x5412});
        row("a terminal's settings", false, SYS_ioctl, {0, 0x5401});
    }

    void argumentsLimitWhatIsAllowed()
    {
        QFETCH(test::Call, call);
        QFETCH(bool, allowed);
        if (!filtersCalls())
            QSKIP(kNoFilter);
        const std::optional<std::vector<test::Verdict>> verdicts = test::probe({call}, {});
        QVERIFY(verdicts);
        QCOMPARE(verdicts->front() == test::Verdict::Allowed, allowed);
    }

    /// Numbers that other machines give their calls, and this one understands.
    void callsOfAnotherMachineKill()
    {
        if (!filtersCalls())
            QSKIP(kNoFilter);
        constexpr long kX32 = 0x40000000;
        QVERIFY(diesInSandbox([] { (void)::syscall(kX32 | SYS_getpid); }));
        QVERIFY(diesInSandbox([] {
            long result = 20; // getpid of 32 bits.
            asm volatile("int $0x80" : "+a"(result) : : "memory");
        }));
    }
#endif
};

HAIRPAINT_TEST(TestCallFilter, Core)
#include "test_call_filter.moc"
