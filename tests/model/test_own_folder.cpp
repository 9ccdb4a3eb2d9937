// What is done in the program's own folders touches nothing that a link leads to, and waits for no pipe; a lock tells
// who lives.
#include "model/disk/earlier_versions.h"
#include "model/disk/own_folder.h"
#include "model/disk/own_lock.h"
#include "model/disk/staged_sweep.h"
#include "tests/model/archive_maker.h"
#include "tests/support/file_faults.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QLockFile>
#include <QTemporaryDir>
#include <QTest>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#include <unistd.h>
#endif

using namespace hairpaint;
using namespace hairpaint::model;
using hairpaint::test::readBytes;
using hairpaint::test::writeBytes;

class TestOwnFolder : public QObject
{
    Q_OBJECT
#ifdef Q_OS_UNIX
private:
    std::unique_ptr<QTemporaryDir> m_folder;

    [[nodiscard]] QString path(const QString& name) const
    {
        return m_folder->filePath(name);
    }
    [[nodiscard]] OwnFolder own() const
    {
        return std::move(*OwnFolder::open(path(QStringLiteral("own"))));
    }

    /// Things that are not files, by their names in the folder, and what they lead to.
    void layTraps()
    {
        QVERIFY(QDir().mkpath(path(QStringLiteral("elsewhere"))));
        writeBytes(path(QStringLiteral("elsewhere/precious")), "precious");
        QVERIFY(QFile::link(path(QStringLiteral("elsewhere/precious")), path(QStringLiteral("own/link"))));
        QVERIFY(QFile::link(path(QStringLiteral("nowhere")), path(QStringLiteral("own/dangling"))));
        QVERIFY(QFile::link(QStringLiteral("/dev/zero"), path(QStringLiteral("own/device"))));
        QCOMPARE(::mkfifo(QFile::encodeName(path(QStringLiteral("own/pipe"))).constData(), 0600), 0);
        QVERIFY(QFile::link(path(QStringLiteral("elsewhere")), path(QStringLiteral("own/folder"))));
    }

    [[nodiscard]] bool isPreciousThere() const
    {
        return readBytes(path(QStringLiteral("elsewhere/precious"))) == "precious" &&
               !QFile::exists(path(QStringLiteral("nowhere")));
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir().mkpath(path(QStringLiteral("own"))));
    }

    void onlyOrdinaryFilesAreReadAndNewOnesTakeTheNameAlone_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"link", "dangling", "device", "pipe"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void onlyOrdinaryFilesAreReadAndNewOnesTakeTheNameAlone()
    {
        QFETCH(QString, name);
        layTraps();
        const OwnFolder folder = own();
        QFile read;
        QVERIFY(!folder.openToRead(read, name));
        QVERIFY(!folder.problem().isEmpty());
        QVERIFY(folder.isHeld(name));
        QFile file;
        QVERIFY(folder.openNew(file, name));
        QCOMPARE(file.write("mine"), 4);
        file.close();
        QCOMPARE(readBytes(path(QStringLiteral("own/") + name)), QByteArray("mine"));
        QVERIFY(folder.openToRead(read, name));
        QVERIFY(isPreciousThere());
    }

    void aLinkToAFolderIsNone()
    {
        layTraps();
        const OwnFolder folder = own();
        QVERIFY(!folder.child(QStringLiteral("folder")));
        QVERIFY(!folder.removeFolder(QStringLiteral("folder")));
        QVERIFY(folder.remove(QStringLiteral("folder")));
        QVERIFY(isPreciousThere());
    }

    void aFolderThatWasMovedIsNotAtItsPath()
    {
        const OwnFolder folder = own();
        QVERIFY(folder.isAtPath());
        QVERIFY(QDir().rename(path(QStringLiteral("own")), path(QStringLiteral("moved"))));
        QVERIFY(!folder.isAtPath());
        QVERIFY(QDir().mkpath(path(QStringLiteral("own")))); // Another one.
        QVERIFY(!folder.isAtPath());
    }

    void contentIsThatOfOrdinaryFilesAlone()
    {
        layTraps();
        QCOMPARE(contentOfOrdinaryFile(path(QStringLiteral("own/link")), 100).value_or("none"), QByteArray("precious"));
        QVERIFY(!contentOfOrdinaryFile(path(QStringLiteral("own/link")), 7));
        for (const char* name : {"dangling", "device", "pipe", "folder"})
            QVERIFY2(!contentOfOrdinaryFile(path(QStringLiteral("own/") + QLatin1StringView(name)), 100), name);
    }

    void aLockIsHeldByWhoLivesAndOneMissingByNobody()
    {
        const OwnFolder folder = own();
        const QString name = QStringLiteral("lock");
        {
            OwnLock one(folder, name);
            QCOMPARE(one.take(), OwnLock::State::Taken);
            OwnLock other(folder, name);
            QCOMPARE(other.take(), OwnLock::State::Held);
            QVERIFY(other.isHeld());
            QLockFile earlier(folder.pathOf(name)); // The lock of an earlier version of the program.
            earlier.setStaleLockTime(0);
            QVERIFY(!earlier.tryLock(0));
            one.release();
            QCOMPARE(other.take(), OwnLock::State::Taken);
        }
        QVERIFY(folder.names().isEmpty());
        {
            QLockFile earlier(folder.pathOf(name));
            QVERIFY(earlier.tryLock(0));
            OwnLock other(folder, name);
            QCOMPARE(other.take(), OwnLock::State::Held);
        }
        // The lock of a process that is gone, whose number another process has now.
        writeBytes(folder.pathOf(name), QByteArray::number(::getpid()) + "\ntest_model\n");
        OwnLock lock(folder, name);
        QCOMPARE(lock.take(), OwnLock::State::Taken);
    }

    void whatIsNoLockIsSweptAside_data()
    {
        onlyOrdinaryFilesAreReadAndNewOnesTakeTheNameAlone_data();
    }
    void whatIsNoLockIsSweptAside()
    {
        QFETCH(QString, name);
        layTraps();
        const OwnFolder folder = own();
        OwnLock lock(folder, name);
        QCOMPARE(lock.take(), OwnLock::State::Taken);
        QVERIFY(isPreciousThere());
    }

    void whereNothingCanBeWrittenALockIsMissingOrHeld_data()
    {
        QTest::addColumn<bool>("isFull");
        QTest::newRow("read-only") << false;
        QTest::newRow("full") << true;
    }
    void whereNothingCanBeWrittenALockIsMissingOrHeld()
    {
#ifdef Q_OS_LINUX
        QFETCH(bool, isFull);
        const OwnFolder folder = own();
        writeBytes(folder.pathOf(QStringLiteral("left")), "999999999\nhairpaint\n");
        OwnLock living(folder, QStringLiteral("living"));
        QCOMPARE(living.take(), OwnLock::State::Taken);
        const QByteArray own = QFile::encodeName(path(QStringLiteral("own")));
        const test::FileRefusal refusal(own.constData(),
                                        isFull ? test::FileRefusal::Why::Full : test::FileRefusal::Why::ReadOnly);
        OwnLock none(folder, QStringLiteral("none"));
        QCOMPARE(none.take(), OwnLock::State::Missing);
        OwnLock held(folder, QStringLiteral("living"));
        QCOMPARE(held.take(), OwnLock::State::Held);
        OwnLock left(folder, QStringLiteral("left"));
        QVERIFY(!left.isHeld() && folder.entry(QStringLiteral("left")));
        QCOMPARE(left.take(), isFull ? OwnLock::State::Taken : OwnLock::State::Missing);
        OwnLock again(folder, QStringLiteral("left")); // By the one who reads what it guards.
        QCOMPARE(again.take(), OwnLock::State::Held);
#endif
    }

    void sweepingFollowsNoLink()
    {
        layTraps();
        const QString left = path(QStringLiteral("own/.hairpaint-0123456789abcdef.part"));
        QVERIFY(QDir().mkpath(left));
        // In a folder of what was put aside, files with another name would go.
        QVERIFY(QFile::link(path(QStringLiteral("elsewhere")), left + QStringLiteral("/before")));
        QCOMPARE(::link(QFile::encodeName(path(QStringLiteral("elsewhere/precious"))).constData(),
                        QFile::encodeName(path(QStringLiteral("elsewhere/twin"))).constData()),
                 0);
        QVERIFY(QFile::link(path(QStringLiteral("elsewhere")),
                            path(QStringLiteral("own/.hairpaint-fedcba9876543210.part"))));
        (void)sweepStaged(path(QStringLiteral("own")));
        QVERIFY(isPreciousThere());
        QVERIFY(QFile::exists(path(QStringLiteral("elsewhere/twin"))));
    }

    void earlierVersionsAreNotWrittenThroughLinks()
    {
        layTraps();
        const QString file = path(QStringLiteral("own/work.hairpaint"));
        writeBytes(file, "work");
        QVERIFY(QFile::link(path(QStringLiteral("elsewhere/precious")), earlierVersion(file, 0)));
        QCOMPARE(::mkfifo(QFile::encodeName(earlierVersion(file, 1)).constData(), 0600), 0); // Would be waited for.
        QVERIFY(keepEarlierVersions(file));
        QVERIFY(isPreciousThere());
        QCOMPARE(readBytes(earlierVersion(file, 1)), QByteArray("work"));
    }
#endif
};

HAIRPAINT_TEST(TestOwnFolder, Core)
#include "test_own_folder.moc"
