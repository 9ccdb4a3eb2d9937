// What a decoder can still do once it is in its sandbox, tried in a child of this process.
#include "app/importer/sandbox.h"

#include "app/importer/call_filter.h"
#include "model/files/importer_client.h"
#include "tests/importer/filter_probe.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <optional>
#include <random>

#ifdef Q_OS_LINUX
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <functional>
#include <grp.h>
#include <linux/landlock.h>
#include <sched.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <thread>
#include <unistd.h>
#endif

using namespace hairpaint;

class TestSandbox : public QObject
{
    Q_OBJECT
#ifdef Q_OS_LINUX
private:
    QTemporaryDir m_folder;
    QTemporaryDir m_elsewhere;

    static QByteArray fileIn(const QTemporaryDir& folder)
    {
        QFile file(folder.filePath(QStringLiteral("file")));
        if (file.open(QIODevice::WriteOnly))
            file.write("content");
        return QFile::encodeName(file.fileName());
    }

    /// Who tries: whoever runs the test and, where that is root, nobody, too.
    static constexpr uid_t kNobody = 65534;
    static void addUsers()
    {
        QTest::addColumn<bool>("asNobody");
        QTest::newRow("as who runs this") << false;
        if (::geteuid() == 0)
            QTest::newRow("as nobody") << true;
    }
    static void becomeNobody()
    {
        if (::setgroups(0, nullptr) != 0 || ::setresgid(kNobody, kNobody, kNobody) != 0 ||
            ::setresuid(kNobody, kNobody, kNobody) != 0)
            ::_exit(2);
    }

    /// Whether `act` is true in a child that has entered the sandbox.
    template<typename Act>
    bool inSandbox(const Act& act, bool asNobody = false)
    {
        const std::string file = QFile::encodeName(m_folder.filePath(QStringLiteral("file"))).toStdString();
        const pid_t child = ::fork();
        if (child == 0) {
            if (asNobody)
                becomeNobody();
            (void)importer::enterSandbox(file);
            ::_exit(act() ? 0 : 1);
        }
        int status = -1;
        ::waitpid(child, &status, 0);
        return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }

    static bool hasLandlock()
    {
        return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) > 0;
    }

    static bool refused(long result)
    {
        return result < 0 && (errno == ENOSYS || errno == EPERM || errno == EACCES);
    }

private Q_SLOTS:
    void itReadsTheModelsFolderAndStartsThreads()
    {
        const QByteArray file = fileIn(m_folder);
        QVERIFY(inSandbox([&file] {
            char content[8] = {};
            const int opened = ::open(file.constData(), O_RDONLY | O_CLOEXEC);
            bool ran = false;
            std::thread([&ran] { ran = true; }).join();
            return opened >= 0 && ::read(opened, content, 7) == 7 && qstrcmp(content, "content") == 0 && ran;
        }));
    }

    void itReadsAndWritesNothingElse()
    {
        const QByteArray own = fileIn(m_folder);
        const QByteArray other = fileIn(m_elsewhere);
        if (!hasLandlock()) {
            // A kernel without it: heads must still be read.
            QVERIFY(inSandbox([&other] { return ::open(other.constData(), O_RDONLY | O_CLOEXEC) >= 0; }));
            return;
        }
        QVERIFY(inSandbox([&other] { return refused(::open(other.constData(), O_RDONLY | O_CLOEXEC)); }));
        QVERIFY(inSandbox([] { return refused(::open("/etc/passwd", O_RDONLY | O_CLOEXEC)); }));
        QVERIFY(inSandbox([&own] { return refused(::open(own.constData(), O_WRONLY | O_CLOEXEC)); }));
        const QByteArray fresh = own + "-new";
        QVERIFY(
            inSandbox([&fresh] { return refused(::open(fresh.constData(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600)); }));
        QVERIFY(inSandbox([&own] { return refused(::unlink(own.constData())); }));
        QVERIFY(inSandbox([&own] { return refused(::truncate(own.constData(), 0)); }));
        QVERIFY(QFile::exists(QFile::decodeName(own)));
    }

    void itReachesNobody()
    {
        QVERIFY(inSandbox([] { return refused(::socket(AF_INET, SOCK_STREAM, 0)); }));
        QVERIFY(inSandbox([] { return refused(::socket(AF_UNIX, SOCK_STREAM, 0)); }));
        QVERIFY(inSandbox([] { return refused(::kill(::getppid(), 0)); }));
        QVERIFY(inSandbox([] {
            char name[] = "/bin/true";
            char* const arguments[] = {name, nullptr};
            return refused(::execv(name, arguments));
        }));
        QVERIFY(inSandbox([] { return refused(::fork()); }));
    }

    void nothingIsChangedOutsideOfItsMemory_data()
    {
        addUsers();
    }

    void nothingIsChangedOutsideOfItsMemory()
    {
        QFETCH(bool, asNobody);
        const QByteArray file = fileIn(m_folder);
        if (asNobody) {
            QVERIFY(::chown(QFile::encodeName(m_folder.path()).constData(), kNobody, kNobody) == 0);
            QVERIFY(::chown(file.constData(), kNobody, kNobody) == 0);
        }
        struct stat before = {};
        QVERIFY(::stat(file.constData(), &before) == 0);
        const char* const path = file.constData();
        const pid_t parent = ::getpid();
        rlimit limit{};
        QVERIFY(::getrlimit(RLIMIT_CORE, &limit) == 0);
        std::array<char, 256> host{};
        QVERIFY(::gethostname(host.data(), host.size() - 1) == 0);
        constexpr long kFchmodat2 = 452; // Newer than Debian 12's headers.
        constexpr int kExecutable = PROT_READ | PROT_EXEC;
        void* const page = ::mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        QVERIFY(page != MAP_FAILED);
        const std::vector<std::pair<const char*, std::function<long()>>> attempts{
            {"open with O_TRUNC", [&] { return ::open(path, O_RDONLY | O_TRUNC | O_CLOEXEC); }},
            {"creat", [&] { return ::creat(path, 0600); }},
            {"fchmodat2", [&] { return ::syscall(kFchmodat2, AT_FDCWD, path, 0777, 0); }},
            {"lchown", [&] { return ::lchown(path, before.st_uid, before.st_gid); }},
            {"utimensat", [&] { return ::utimensat(AT_FDCWD, path, nullptr, 0); }},
            {"lsetxattr", [&] { return ::lsetxattr(path, "user.hair", "x", 1, 0); }},
            {"mkdir", [&] { return ::mkdir((file + "-made").constData(), 0700); }},
            {"symlink", [&] { return ::symlink("x", (file + "-link").constData()); }},
            {"openat2", [&] { return ::syscall(SYS_openat2, AT_FDCWD, path, nullptr, 0); }},
            {"tgkill of the parent", [&] { return ::syscall(SYS_tgkill, parent, parent, 0); }},
            {"kill of itself and its group", [] { return ::kill(0, 0); }},
            {"prlimit64 of the parent", [&] { return ::prlimit(parent, RLIMIT_CORE, &limit, nullptr); }},
            {"setrlimit of itself", [&] { return ::setrlimit(RLIMIT_CORE, &limit); }},
            {"setpriority of the parent", [&] { return ::setpriority(PRIO_PROCESS, static_cast<id_t>(parent), 0); }},
            {"sched_setaffinity of the parent",
             [&] {
                 cpu_set_t processors{};
                 CPU_SET(0, &processors);
                 return ::sched_setaffinity(parent, sizeof processors, &processors);
             }},
            {"fcntl of who gets signals", [&] { return ::fcntl(STDERR_FILENO, F_SETOWN, parent); }},
            {"shmget", [] { return ::shmget(IPC_PRIVATE, 4096, 0600); }},
            {"memfd_create", [] { return ::syscall(SYS_memfd_create, "x", 0); }},
            {"chroot", [] { return ::chroot("/"); }},
            {"sethostname", [&] { return ::sethostname(host.data(), ::strlen(host.data())); }},
            {"fsopen", [] { return ::syscall(SYS_fsopen, "tmpfs", 0); }},
            {"prctl of its dumps", [] { return ::prctl(PR_SET_DUMPABLE, 1, 0, 0, 0); }},
            {"mprotect as a program", [&] { return ::mprotect(page, 4096, kExecutable); }},
            {"mmap as a program",
             [] {
                 void* const made = ::mmap(nullptr, 4096, kExecutable, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
                 return made == MAP_FAILED ? -1L : 0L;
             }},
        };
        for (const auto& [name, attempt] : attempts)
            QVERIFY2(inSandbox([&attempt = attempt] { return refused(attempt()); }, asNobody), name);
        ::munmap(page, 4096);
        struct stat after = {};
        QVERIFY(::stat(path, &after) == 0);
        QCOMPARE(after.st_size, before.st_size);
        QCOMPARE(after.st_mode, before.st_mode);
        QCOMPARE(after.st_mtim.tv_sec, before.st_mtim.tv_sec);
        QCOMPARE(after.st_mtim.tv_nsec, before.st_mtim.tv_nsec);
    }

#ifdef HAIRPAINT_HAS_FILTER_PROBE
    void theKernelAllowsTheListAndNothingElse_data()
    {
        addUsers();
    }

    /// Every number there is, and twice as many that there are not yet, each with arguments of all kinds.
    void theKernelAllowsTheListAndNothingElse()
    {
        QFETCH(bool, asNobody);
        if (!filtersCalls())
            QSKIP("Built without libseccomp, or the kernel has no filters.");
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
            QSKIP("Built without libseccomp, or the kernel has no filters.");
        const std::optional<std::vector<test::Verdict>> verdicts = test::probe({call}, {});
        QVERIFY(verdicts);
        QCOMPARE(verdicts->front() == test::Verdict::Allowed, allowed);
    }

    /// Numbers that other machines give their calls, and this one understands.
    void callsOfAnotherMachineKill()
    {
        if (!filtersCalls())
            QSKIP("Built without libseccomp, or the kernel has no filters.");
        constexpr long kX32 = 0x40000000;
        QVERIFY(diesInSandbox([] { (void)::syscall(kX32 | SYS_getpid); }));
        QVERIFY(diesInSandbox([] {
            long result = 20; // getpid of 32 bits.
            asm volatile("int $0x80" : "+a"(result) : : "memory");
        }));
    }

    /// A file that a shell had open when it started the editor, say.
    void theHelperKeepsNothingOpenThatItInherited()
    {
        int pipe[2] = {-1, -1};
        QVERIFY(::pipe2(pipe, O_CLOEXEC) == 0);
        constexpr int kInherited = 9;
        QProcess helper; // Waits for its request.
        helper.setChildProcessModifier([&pipe] { ::dup2(pipe[1], kInherited); });
        helper.start(QStringLiteral(HAIRPAINT_IMPORT_PROGRAM), QStringList());
        QVERIFY(helper.waitForStarted(-1));
        ::close(pipe[1]);
        char byte = 0;
        QCOMPARE(::read(pipe[0], &byte, 1), ssize_t{0}); // Returns once nobody has the other end.
        ::close(pipe[0]);
        QCOMPARE(helper.state(), QProcess::Running);
        helper.closeWriteChannel();
        QVERIFY(helper.waitForFinished(-1));
    }

    void theHelperTellsWhatHoldsIt()
    {
        const std::optional<model::HelperSandbox> sandbox =
            model::ImporterClient(QStringLiteral(HAIRPAINT_IMPORT_PROGRAM)).sandbox();
        QVERIFY(sandbox);
        QCOMPARE(sandbox->landlockVersion > 0, hasLandlock());
        QCOMPARE(sandbox->filtersCalls, filtersCalls());
#ifndef HAIRPAINT_ASAN
        QCOMPARE(sandbox->mostMegabytes, 1800);
#endif
    }

private:
    static bool filtersCalls()
    {
        return !importer::allowedCalls().empty() && ::prctl(PR_GET_SECCOMP, 0, 0, 0, 0) >= 0;
    }

    template<typename Act>
    bool diesInSandbox(const Act& act)
    {
        const pid_t child = ::fork();
        if (child == 0) {
            const rlimit none{};
            (void)::setrlimit(RLIMIT_CORE, &none);
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
            for (unsigned long& argument : calls.emplace_back().arguments)
                argument = random() & random();
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
#endif
#endif
};

HAIRPAINT_TEST(TestSandbox, Core)
#include "test_sandbox.moc"
