// Settings survive the program, other windows and a full disk.
#include "app/background/counted_thread.h"
#include "app/settings/settings_store.h"
#include "tests/model/archive_maker.h"
#include "tests/support/await.h"
#include "tests/support/file_faults.h"
#include "tests/support/full_disk.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace hairpaint;
using hairpaint::app::SettingsStore;

class TestSettingsStore : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString path() const { return m_folder.filePath(QStringLiteral("a/b/settings.json")); }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
    }
    void init() { SettingsStore(path()).clear(); }

    void everyKindOfValueComesBack()
    {
        const QByteArray bytes("\0\xFF geometry", 11);
        const QStringList list{QStringLiteral("/ä/b.hairpaint"), QStringLiteral("c")};
        {
            SettingsStore store(path());
            store.setValue(QStringLiteral("text"), QStringLiteral("base"));
            store.setValue(QStringLiteral("number"), 7);
            store.setValue(QStringLiteral("truth"), true);
            store.setValue(QStringLiteral("bytes"), bytes);
            store.setValue(QStringLiteral("keys/list"), list);
            store.setValue(QStringLiteral("gone"), 1);
            store.remove(QStringLiteral("gone"));
        }
        const SettingsStore store(path());
        QCOMPARE(store.value(QStringLiteral("text")).toString(), QStringLiteral("base"));
        QCOMPARE(store.value(QStringLiteral("number")).toInt(), 7);
        QCOMPARE(store.value(QStringLiteral("truth")).toBool(), true);
        QCOMPARE(store.value(QStringLiteral("bytes")).toByteArray(), bytes);
        QCOMPARE(store.value(QStringLiteral("keys/list")).toStringList(), list);
        QCOMPARE(store.value(QStringLiteral("gone"), 5).toInt(), 5);
    }

    void twoWindowsKeepEachOthersSettings()
    {
        SettingsStore one(path());
        SettingsStore other(path());
        one.setValue(QStringLiteral("one"), 1);
        other.setValue(QStringLiteral("other"), 2);
        // Nothing is lost before it is written, and what is set stays although the file did not hold it yet.
        one.setValue(QStringLiteral("both"), 3);
        QCOMPARE(one.value(QStringLiteral("one")).toInt(), 1);
        one.flush();
        other.flush();
        const SettingsStore both(path());
        QCOMPARE(both.value(QStringLiteral("one")).toInt(), 1);
        QCOMPARE(both.value(QStringLiteral("other")).toInt(), 2);
        QCOMPARE(both.value(QStringLiteral("both")).toInt(), 3);
    }

    void whatIsSetTogetherIsWrittenOnce()
    {
        const QString file = m_folder.filePath(QStringLiteral("once/settings.json"));
        SettingsStore store(file);
        for (int i = 0; i < 100; ++i)
            store.setValue(QStringLiteral("keys/%1").arg(i), i);
        QVERIFY(!QFile::exists(file));
        QCoreApplication::processEvents();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file), test::kPatienceMs);
        QCOMPARE(SettingsStore(file).value(QStringLiteral("keys/99")).toInt(), 99);
        // What is the same already is not written again.
        QVERIFY(QFile::remove(file));
        store.setValue(QStringLiteral("keys/99"), 99);
        store.flush();
        QVERIFY(!QFile::exists(file));
    }

#ifdef Q_OS_LINUX // The older program was there alone.
    void whatAnOlderProgramLeftIsTakenOver()
    {
        QSettings().setValue(QStringLiteral("keys/tool.brush"), QStringLiteral("Q"));
        QSettings().setValue(QStringLiteral("geometry"), QByteArray("\1\2", 2));
        const SettingsStore store(m_folder.filePath(QStringLiteral("none/settings.json")));
        QCOMPARE(store.value(QStringLiteral("keys/tool.brush")).toString(), QStringLiteral("Q"));
        QCOMPARE(store.value(QStringLiteral("geometry")).toByteArray(), QByteArray("\1\2", 2));
        QSettings().clear();
    }
#endif

    void aSpoiltFileIsNoSettings()
    {
        test::writeBytes(path(), "{ \"text\": ");
        QVERIFY(!SettingsStore(path()).value(QStringLiteral("text")).isValid());
    }

#ifdef Q_OS_UNIX
    void onlyAnOrdinaryFileHasSettings_data()
    {
        QTest::addColumn<QString>("target");
        QTest::newRow("a device without an end") << QStringLiteral("/dev/zero");
        QTest::newRow("a pipe") << QString();
        QTest::newRow("a folder") << m_folder.path();
    }
    void onlyAnOrdinaryFileHasSettings()
    {
        QFETCH(QString, target);
        const QString file = m_folder.filePath(QStringLiteral("odd.json"));
        QFile::remove(file);
        if (target.isEmpty())
            QCOMPARE(::mkfifo(QFile::encodeName(file).constData(), 0600), 0);
        else
            QVERIFY(QFile::link(target, file));
        SettingsStore store(file);
        QVERIFY(!store.value(QStringLiteral("text")).isValid());
        store.setValue(QStringLiteral("text"), QStringLiteral("held"));
        store.flush();
        QCOMPARE(store.value(QStringLiteral("text")).toString(), QStringLiteral("held"));
        QVERIFY(QFileInfo(file).isSymbolicLink() || !QFileInfo(file).isFile()); // It stays what it was.
        QFile::remove(file);
    }

    void settingsMayLieBehindALink()
    {
        const QString file = m_folder.filePath(QStringLiteral("link.json"));
        test::writeBytes(m_folder.filePath(QStringLiteral("kept.json")), R"({"text": "kept"})");
        QVERIFY(QFile::link(m_folder.filePath(QStringLiteral("kept.json")), file));
        QCOMPARE(SettingsStore(file).value(QStringLiteral("text")).toString(), QStringLiteral("kept"));
    }
#endif

#ifdef Q_OS_LINUX
    void aDiskThatDoesNotAnswerIsNotWaitedFor()
    {
        const QString folder = m_folder.filePath(QStringLiteral("server"));
        QVERIFY(QDir().mkpath(folder));
        const QString file = folder + QStringLiteral("/settings.json");
        test::writeBytes(file, R"({"text": "there"})");
        const QByteArray path = QFile::encodeName(folder);
        {
            constexpr int kMs = 50;
            const test::FileStall stall(path.constData());
            SettingsStore store(file, kMs);
            QVERIFY(!store.value(QStringLiteral("text")).isValid());
            store.setValue(QStringLiteral("text"), QStringLiteral("mine"));
            store.flush();
            QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
        }
        QCOMPARE(SettingsStore(file).value(QStringLiteral("text")).toString(), QStringLiteral("there"));
        QVERIFY(test::awaitUntil([] { return test::FileStall::waiting() == 0; }));
    }
    void whatADiskThatDoesNotAnswerIsToKeepItKeepsLater()
    {
        const QString folder = m_folder.filePath(QStringLiteral("late"));
        QVERIFY(QDir().mkpath(folder));
        const QString file = folder + QStringLiteral("/settings.json");
        test::writeBytes(file, R"({"text": "there", "other": 1})");
        const QByteArray folderBytes = QFile::encodeName(folder);
        {
            constexpr int kMs = 50;
            SettingsStore store(file, kMs);
            const test::FileStall stall(folderBytes.constData());
            store.setValue(QStringLiteral("text"), QStringLiteral("mine"));
            test::handleDueEvents(); // That nothing waits in.
            QVERIFY(test::awaitUntil([] { return test::FileStall::waiting() > 0; }));
            store.setValue(QStringLiteral("number"), 1);
            store.flush();
            store.setValue(QStringLiteral("number"), 2);
            QCOMPARE(store.value(QStringLiteral("text")).toString(), QStringLiteral("mine"));
            QVERIFY2(test::FileStall::askedByMain() == 0, test::FileStall::lastByMain());
        }
        QVERIFY(test::awaitUntil([] { return !app::anyCountedThread(); }));
        const SettingsStore store(file);
        QCOMPARE(store.value(QStringLiteral("text")).toString(), QStringLiteral("mine"));
        QCOMPARE(store.value(QStringLiteral("number")).toInt(), 2);
        QCOMPARE(store.value(QStringLiteral("other")).toInt(), 1);
    }
#endif

#ifdef Q_OS_UNIX
    /// A limit on a file's size fails writes as a full disk does.
    void onAFullDiskTheOldSettingsStay()
    {
        SettingsStore store(path());
        store.setValue(QStringLiteral("text"), QStringLiteral("old"));
        store.flush();
        {
            const test::FullDisk disk(10);
            store.setValue(QStringLiteral("text"), QStringLiteral("new"));
            store.flush();
        }
        QCOMPARE(store.value(QStringLiteral("text")).toString(), QStringLiteral("new"));
        QCOMPARE(SettingsStore(path()).value(QStringLiteral("text")).toString(), QStringLiteral("old"));
        // It is tried again with the next.
        store.setValue(QStringLiteral("number"), 1);
        store.flush();
        QCOMPARE(SettingsStore(path()).value(QStringLiteral("text")).toString(), QStringLiteral("new"));
    }
#endif
};

HAIRPAINT_TEST(TestSettingsStore, Core)
#include "test_settings_store.moc"
