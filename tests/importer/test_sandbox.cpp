// What a decoder can still do once it is in its sandbox, tried in a child of this process.
#include "app/importer/sandbox.h"

#include "model/files/importer_client.h"
#include "tests/importer/sandbox_users.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <optional>

#ifdef Q_OS_LINUX
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <fcntl.h>
#include <functional>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
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
using namespace hairpaint::test;

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

    /// From now on these calls fail as on a kernel that does not have them.
    static void pretendToLack(std::initializer_list<long> calls)
    {
        std::vector<sock_filter> program{{BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)}};
        for (const long call : calls) {
            program.push_back({BPF_JMP | BPF_JEQ | BPF_K, 0, 1, static_cast<std::uint32_t>(call)});
            program.push_back({BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | ENOSYS});
        }
        program.push_back({BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW});
        const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
        if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0)
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
        if (!filtersCalls())
            QSKIP(kNoFilter);
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
        if (!filtersCalls())
            QSKIP(kNoFilter);
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

    void anOlderKernelKeepsWhatItHas()
    {
        if (!filtersCalls() || !hasLandlock())
            QSKIP("This kernel is older itself.");
        const std::string file = fileIn(m_folder).toStdString();
        const auto enters = [&file](std::initializer_list<long> lacking, bool landlock, bool filter) {
            const pid_t child = ::fork();
            if (child == 0) {
                pretendToLack(lacking);
                const importer::Confinement sandbox = importer::enterSandbox(file);
                const bool isTold = (sandbox.landlockVersion > 0) == landlock && sandbox.filtersCalls == filter;
                const bool reads = ::open(file.c_str(), O_RDONLY | O_CLOEXEC) >= 0;
                const bool writes = !refused(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
                ::_exit(isTold && reads && writes == !(landlock || filter) ? 0 : 1);
            }
            int status = -1;
            ::waitpid(child, &status, 0);
            return WIFEXITED(status) && WEXITSTATUS(status) == 0;
        };
        QVERIFY(enters({}, true, true));
        QVERIFY(enters({SYS_landlock_create_ruleset}, false, true));
        // Without PR_SET_NO_NEW_PRIVS there is neither, and files are read all the same.
        QVERIFY(enters({SYS_seccomp, SYS_prctl}, false, false));
    }

    /// A file that a shell had open when it started the editor, say.
    void theHelperKeepsNothingOpenThatItInherited()
    {
        int pipe[2] = {-1, -1};
        QVERIFY(::pipe2(pipe, O_CLOEXEC) == 0);
        constexpr int kInherited = 9;
        QProcess helper; // Waits for its request.
        helper.setChildProcessModifier([&pipe] { ::dup2(pipe[1], kInherited); });
        helper.start(test::importProgram(), QStringList());
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
        const std::optional<model::HelperSandbox> sandbox = model::ImporterClient(test::importProgram()).sandbox();
        QVERIFY(sandbox);
        QCOMPARE(sandbox->landlockVersion > 0, hasLandlock());
        QCOMPARE(sandbox->filtersCalls, filtersCalls());
#ifndef HAIRPAINT_ASAN
        QCOMPARE(sandbox->mostMegabytes, 1800);
#endif
    }
#endif
};

HAIRPAINT_TEST(TestSandbox, Core)
#include "test_sandbox.moc"
