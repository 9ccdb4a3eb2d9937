// A file is written whole or not at all, also where only its last bytes found no room.
#include "model/disk/atomic_file.h"
#include "model/disk/staged_files.h"
#include "model/disk/staged_sweep.h"
#include "model/files/archive.h"
#include "tests/model/archive_maker.h"
#include "tests/support/file_faults.h"
#include "tests/support/full_disk.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

using namespace hairpaint;
using namespace hairpaint::model;

class TestAtomicFile : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString path() const { return m_folder.filePath(QStringLiteral("file")); }
    [[nodiscard]] QStringList names() const { return QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden); }

private Q_SLOTS:
    void init() { test::writeBytes(path(), "old"); }

    void piecesOfAnySizeArriveInOrder()
    {
        QByteArray expected;
        AtomicFile file(path());
        QVERIFY(file.open());
        for (const int size : {1, 100'000, 5, 300'000, 262'143, 1, 0, 1'000'000, 7}) {
            const QByteArray piece(size, static_cast<char>('a' + size % 26));
            expected += piece;
            file.write(piece);
        }
        QCOMPARE(test::readBytes(path()), QByteArray("old"));
        QVERIFY(file.commit());
        QVERIFY(test::readBytes(path()) == expected);
        QCOMPARE(names().size(), 1);
    }

    void whatIsNotCommittedLeavesTheOldFile()
    {
        {
            AtomicFile file(path());
            QVERIFY(file.open());
            file.write("new");
        }
        QCOMPARE(test::readBytes(path()), QByteArray("old"));
        QCOMPARE(names().size(), 1);
    }

    void whatCantBeReplacedIsRefused()
    {
        QVERIFY(!writeFile(m_folder.path(), "new"));
        QVERIFY(!writeFile(m_folder.filePath(QStringLiteral("nowhere/file")), "new"));
    }

    void whatAKillLeftIsSweptAndNothingElse()
    {
        const QString left = m_folder.filePath(QStringLiteral(".hairpaint-0123456789abcdef.part"));
        const QString users = m_folder.filePath(QStringLiteral(".hairpaint-mine.part"));
        test::writeBytes(left, "half");
        test::writeBytes(users, "mine");
        QCOMPARE(sweepStaged(m_folder.path()), 1);
        QCOMPARE(names(), QStringList({QStringLiteral(".hairpaint-mine.part"), QStringLiteral("file")}));
        QCOMPARE(sweepStaged(m_folder.filePath(QStringLiteral("nowhere"))), 0);
        QFile::remove(users);
    }

    void foldersUnderWayAreSweptOnceNobodyHasThem()
    {
        StagedFiles staged(m_folder.path());
        QVERIFY(staged.check(path()));
        test::writeBytes(staged.pathFor(path()), "new");
        QCOMPARE(sweepStaged(m_folder.path()), 0);
        QVERIFY(staged.publish({path()}));
        QCOMPARE(test::readBytes(path()), QByteArray("new"));
    }

    void whatAKillPutAsideIsKeptUnlessItIsAtItsPathToo()
    {
        const QString left = m_folder.filePath(QStringLiteral(".hairpaint-0123456789abcdef.part"));
        const QString aside = left + QStringLiteral("/before/");
        QVERIFY(QDir().mkpath(aside));
        test::writeBytes(left + QStringLiteral("/lock"), {});
        test::writeBytes(left + QStringLiteral("/half.png"), "half");
        std::filesystem::create_hard_link(QFileInfo(path()).filesystemFilePath(),
                                          QFileInfo(aside + QLatin1Char('0')).filesystemFilePath());
        test::writeBytes(aside + QLatin1Char('1'), "the only one");
        QCOMPARE(sweepStaged(m_folder.path()), 0);
        QCOMPARE(QDir(left).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList(QStringLiteral("before")));
        QCOMPARE(QDir(aside).entryList(QDir::Files), QStringList(QStringLiteral("1")));
        QVERIFY(QFile::remove(aside + QLatin1Char('1')));
        QCOMPARE(sweepStaged(m_folder.path()), 1);
        QCOMPARE(names(), QStringList(QStringLiteral("file")));
    }

#ifdef Q_OS_UNIX // What Qt makes for a link on Windows is a shortcut, a file of its own.
    void theFileBehindALinkIsReplacedAndKeepsItsPermissions()
    {
        const QString link = m_folder.filePath(QStringLiteral("link"));
        const QFileDevice::Permissions own = QFileDevice::ReadOwner | QFileDevice::WriteOwner;
        QVERIFY(QFile::setPermissions(path(), own));
        QVERIFY(QFile::link(path(), link));
        QVERIFY(writeFile(link, "new"));
        QVERIFY(QFileInfo(link).isSymLink());
        QCOMPARE(test::readBytes(path()), QByteArray("new"));
        const QFileDevice::Permissions group = QFileDevice::ReadGroup | QFileDevice::ReadOther;
        QCOMPARE(QFileInfo(path()).permissions() & (own | group), own);
        QFile::remove(link);
    }
#endif

#ifdef Q_OS_LINUX
    void aFileThatIsStillWrittenIsNotSwept()
    {
        const test::FileFault noNamelessFile(1);
        AtomicFile file(path());
        QVERIFY(file.open());
        file.write("new");
        QCOMPARE(names().size(), 2);
        QCOMPARE(sweepStaged(m_folder.path()), 0);
        QVERIFY(file.commit());
        QCOMPARE(test::readBytes(path()), QByteArray("new"));
        QCOMPARE(names().size(), 1);
    }
#endif

#ifdef Q_OS_UNIX
    void aFileWhoseLastBytesFindNoSpaceLeavesTheOldOne_data()
    {
        QTest::addColumn<int>("size");
        QTest::addColumn<int>("room");
        QTest::newRow("none of it") << 100 << 0;
        QTest::newRow("all but the last byte") << 100 << 99;
        QTest::newRow("all but the last of a buffer") << 16'384 << 16'383;
        QTest::newRow("a piece of many") << 3'000'000 << 2'999'999;
    }
    void aFileWhoseLastBytesFindNoSpaceLeavesTheOldOne()
    {
        QFETCH(int, size);
        QFETCH(int, room);
        ArchiveWriter archive; // Its own bytes come on top.
        archive.add("a", QByteArray(size, 'x'), ArchiveWriter::Method::Stored);

        const test::FullDisk disk(room);
        const Checked<void> written = writeFile(path(), QByteArray(size, 'x'));
        QVERIFY(!written);
        QVERIFY(!written.error().text.isEmpty());
        QVERIFY(!written.error().text.contains(QStringLiteral("Unknown")));
        QVERIFY(!archive.writeTo(path()));
        QCOMPARE(test::readBytes(path()), QByteArray("old"));
        QCOMPARE(names().size(), 1);
    }
#endif

#ifdef Q_OS_LINUX
    void aFullDiskIsNamedAsSuch()
    {
        QFile full(QStringLiteral("/dev/full"));
        QVERIFY(full.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
        QVERIFY(full.write("x", 1) < 0);
        QVERIFY2(writeProblem(full).contains(QStringLiteral("no space left")), qPrintable(writeProblem(full)));
    }
#endif
};

HAIRPAINT_TEST(TestAtomicFile, Core)
#include "test_atomic_file.moc"
