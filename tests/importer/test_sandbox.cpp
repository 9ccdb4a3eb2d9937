// What a decoder can still do once it is in its sandbox, tried in a child of this process.
#include "app/importer/sandbox.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#ifdef Q_OS_LINUX
#include <cerrno>
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#endif

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

    /// Whether `act` is true in a child that has entered the sandbox.
    template<typename Act>
    bool inSandbox(const Act& act)
    {
        const std::string folder = QFile::encodeName(m_folder.path()).toStdString();
        const pid_t child = ::fork();
        if (child == 0) {
            hairpaint::importer::enterSandbox(folder);
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
        return result < 0 && (errno == EPERM || errno == EACCES);
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
#endif
};

HAIRPAINT_TEST(TestSandbox, Core)
#include "test_sandbox.moc"
