// What an output's path leads to: links are followed, also those to nothing yet; what is no ordinary file is refused as
// what it is.
#include "model/disk/atomic_file.h"
#include "model/disk/staged_files.h"
#include "tests/model/archive_maker.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#endif

using namespace hairpaint;
using namespace hairpaint::model;

#ifdef Q_OS_UNIX

class TestOutputPath : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<QTemporaryDir> m_folder;

    [[nodiscard]] QString path(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    /// As it stands, relative ones too.
    void link(const QByteArray& target, const char* name) const
    {
        QCOMPARE(::symlink(target.constData(), QFile::encodeName(path(name)).constData()), 0);
    }
    [[nodiscard]] QByteArray targetOf(const char* name) const
    {
        std::array<char, 4096> target{};
        const ssize_t size = ::readlink(QFile::encodeName(path(name)).constData(), target.data(), target.size());
        return {target.data(), size};
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("deep/er")));
    }

    void aLinkIsFollowedAndStays_data()
    {
        QTest::addColumn<QByteArray>("target");
        QTest::addColumn<bool>("exists");
        for (const bool exists : {true, false}) {
            const QByteArray row = exists ? " that is there" : " that is not there yet";
            QTest::newRow("to a file" + row) << QByteArray("aim") << exists;
            QTest::newRow("to a file elsewhere" + row) << QByteArray("deep/er/aim") << exists;
            QTest::newRow("up from behind a link to a folder," + row) << QByteArray("short/../aim") << exists;
            QTest::newRow("to a link" + row) << QByteArray("second") << exists;
        }
    }
    void aLinkIsFollowedAndStays()
    {
        QFETCH(QByteArray, target);
        QFETCH(bool, exists);
        link("deep/er", "short");
        link("deep/../deep/er/aim", "second");
        link(target, "link");
        const QString aim = target == "aim"            ? path("aim")
                            : target == "short/../aim" ? path("deep/aim")
                                                       : path("deep/er/aim");
        if (exists)
            test::writeBytes(aim, "old");
        QVERIFY(writeFile(path("link"), "new"));
        QCOMPARE(test::readBytes(aim), QByteArray("new"));
        QCOMPARE(targetOf("link"), target);

        StagedFiles staged(m_folder->path());
        test::writeBytes(staged.pathFor(path("link")), "together");
        QVERIFY(staged.publish({path("link")}));
        QCOMPARE(test::readBytes(aim), QByteArray("together"));
        QCOMPARE(targetOf("link"), target);
    }

    /// A rename can't bring them there.
    void filesBehindLinksToAnotherDiskAreReplacedTogether()
    {
        const QTemporaryDir other(QStringLiteral("/dev/shm/hairpaint-XXXXXX"));
        struct stat here = {};
        struct stat there = {};
        if (!other.isValid() || ::stat(QFile::encodeName(m_folder->path()).constData(), &here) != 0 ||
            ::stat(QFile::encodeName(other.path()).constData(), &there) != 0 || here.st_dev == there.st_dev)
            QSKIP("There is no other disk.");
        test::writeBytes(other.filePath(QStringLiteral("one")), "old");
        link(QFile::encodeName(other.filePath(QStringLiteral("one"))), "one");
        link(QFile::encodeName(other.filePath(QStringLiteral("two"))), "two");
        for (const bool isGood : {false, true}) {
            StagedFiles staged(m_folder->path());
            const QStringList paths{path("one"), path("two"), path("three")};
            for (const QString& path : paths.first(isGood ? 3 : 2)) // What is not there can't be moved.
                test::writeBytes(staged.pathFor(path), "new");
            QCOMPARE(staged.publish(paths).has_value(), isGood);
            QCOMPARE(test::readBytes(other.filePath(QStringLiteral("one"))), QByteArray(isGood ? "new" : "old"));
            QCOMPARE(QFileInfo::exists(other.filePath(QStringLiteral("two"))), isGood);
            QVERIFY(QFileInfo(path("one")).isSymbolicLink() && QFileInfo(path("two")).isSymbolicLink());
        }
        QCOMPARE(QDir(other.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).size(), 2);
    }

    void whatIsNoOrdinaryFileIsRefusedAsWhatItIs_data()
    {
        QTest::addColumn<QString>("words");
        QTest::newRow("folder") << QStringLiteral("it is a folder");
        QTest::newRow("pipe") << QStringLiteral("it is a pipe");
        QTest::newRow("socket") << QStringLiteral("it is a socket");
        QTest::newRow("device") << QStringLiteral("it is a device");
        QTest::newRow("circle") << QStringLiteral("leads round in a circle");
        QTest::newRow("nowhere") << QStringLiteral("there is no folder");
#ifdef Q_OS_LINUX
        QTest::newRow("nameless") << QStringLiteral("a file without a name");
        QTest::newRow("closed") << QString();
#endif
    }
    void whatIsNoOrdinaryFileIsRefusedAsWhatItIs()
    {
        QFETCH(QString, words);
        const QByteArray kind = QTest::currentDataTag();
        const QByteArray direct = QFile::encodeName(path("direct"));
        if (kind == "folder")
            QVERIFY(QDir().mkpath(path("direct")));
        else if (kind == "pipe")
            QCOMPARE(::mkfifo(direct.constData(), 0600), 0);
        else if (kind == "device")
            link("/dev/null", "direct");
        else if (kind == "circle")
            link("link", "direct");
        else if (kind == "nowhere")
            link("no/folder", "direct");
        else if (kind == "closed")
            link("/proc/self/fd/987", "direct");
        QFile nameless(path("gone"));
        if (kind == "nameless") {
            QVERIFY(nameless.open(QIODevice::ReadWrite) && nameless.remove() && nameless.open(QIODevice::ReadWrite));
            QVERIFY(QFile::remove(path("gone")));
            link("/proc/self/fd/" + QByteArray::number(nameless.handle()), "direct");
        }
        if (kind == "socket") {
            sockaddr_un address{};
            address.sun_family = AF_UNIX;
            QVERIFY(direct.size() < static_cast<qsizetype>(sizeof address.sun_path));
            std::memcpy(address.sun_path, direct.constData(), static_cast<std::size_t>(direct.size()));
            const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
            QCOMPARE(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
            ::close(socket);
        }
        link("direct", "link");
        struct stat before = {};
        QCOMPARE(::lstat(direct.constData(), &before), 0);
        for (const char* name : {"direct", "link"}) {
            const Checked<void> written = writeFile(path(name), "new");
            QVERIFY(!written);
            QVERIFY2(written.error().text.contains(words), qPrintable(written.error().text));
            StagedFiles staged(m_folder->path());
            test::writeBytes(staged.pathFor(path(name)), "new");
            QVERIFY(!staged.publish({path(name)}));
        }
        struct stat after = {};
        QCOMPARE(::lstat(direct.constData(), &after), 0);
        QCOMPARE(after.st_ino, before.st_ino);
        QCOMPARE(after.st_mode, before.st_mode);
        QCOMPARE(targetOf("link"), QByteArray("direct"));
    }
};

#else

class TestOutputPath : public QObject
{
    Q_OBJECT
};

#endif

HAIRPAINT_TEST(TestOutputPath, Core)
#include "test_output_path.moc"
