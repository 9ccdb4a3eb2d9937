// Verbs that are told to end while they write: nothing half made is left, and whoever called them learns of it.
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/locations.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QTemporaryDir>
#include <QtTest>

#ifdef Q_OS_UNIX
#include <csignal>
#endif

using namespace hairpaint;

class TestInterruption : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString project() const { return m_folder.filePath(QStringLiteral("p.hairpaint")); }
    [[nodiscard]] QString folder() const { return m_folder.filePath(QStringLiteral("made")); }

    /// Files that lie somewhere below the folder, under whatever name.
    [[nodiscard]] int filesThere() const
    {
        int count = 0;
        for (QDirIterator files(folder(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories); files.hasNext();
             files.next())
            ++count;
        return count;
    }

    [[nodiscard]] bool isEmptyThere() const
    {
        return QDir(folder()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(QDir(m_folder.path()).mkdir(QStringLiteral("made")));
        const test::Outcome made = test::runProgram({QStringLiteral("new"), QStringLiteral("-o"), project(),
                                                     QStringLiteral("--preset"), QStringLiteral("Buzz cut")});
        QCOMPARE(made.code, 0);
        QVERIFY(test::thinOut(project()));
    }

#ifdef Q_OS_UNIX
    void aFilmThatIsInterruptedLeavesNothing_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("signal");
        const QStringList render{QStringLiteral("render"), project(),
                                 QStringLiteral("--size"), QStringLiteral("64x64"),
                                 QStringLiteral("-o"),     folder() + QStringLiteral("/f.png")};
        const QStringList curves{QStringLiteral("export"), project(), QStringLiteral("-o"),
                                 folder() + QStringLiteral("/f.hair")};
        QTest::newRow("pictures, killed") << render << SIGTERM;
        QTest::newRow("pictures, Ctrl+C") << render << SIGINT;
        QTest::newRow("pictures, a closed terminal") << render << SIGHUP;
        QTest::newRow("curves, killed") << curves << SIGTERM;
    }
    void aFilmThatIsInterruptedLeavesNothing()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, signal);
        QProcess process;
        process.setChildProcessModifier([] {
            for (const int one : {SIGTERM, SIGINT, SIGHUP})
                std::signal(one, SIG_DFL); // Whatever the one who runs the tests ignores.
        });
        process.start(test::hairpaintProgram(),
                      arguments + QStringList{QStringLiteral("--frames"), QStringLiteral("0-5000"),
                                              QStringLiteral("--settle"), QStringLiteral("0")});
        QTRY_VERIFY_WITH_TIMEOUT(filesThere() > 2, test::kPatienceMs);
        ::kill(static_cast<pid_t>(process.processId()), signal);
        QVERIFY(process.waitForFinished(test::kPatienceMs));
        QCOMPARE(process.exitStatus(), QProcess::CrashExit); // By that signal: shells stop their loops then.
        QCOMPARE(process.exitCode(), signal);
        QCOMPARE(process.readAllStandardError(), QByteArray());
        QVERIFY(isEmptyThere());
    }

    void aFilmThatIsKilledIsSweptByTheNext()
    {
        QProcess process;
        const QStringList render{QStringLiteral("render"),   project(),
                                 QStringLiteral("--size"),   QStringLiteral("64x64"),
                                 QStringLiteral("-o"),       folder() + QStringLiteral("/f.png"),
                                 QStringLiteral("--settle"), QStringLiteral("0"),
                                 QStringLiteral("--frames")};
        process.start(test::hairpaintProgram(), render + QStringList{QStringLiteral("0-5000")});
        QTRY_VERIFY_WITH_TIMEOUT(filesThere() > 2, test::kPatienceMs);
        process.kill();
        QVERIFY(process.waitForFinished(test::kPatienceMs));
        QVERIFY(!isEmptyThere());
        QCOMPARE(test::runProgram(render + QStringList{QStringLiteral("0-0")}).code, 0);
        QVERIFY(QFile::remove(folder() + QStringLiteral("/f.0000.png")));
        QVERIFY(isEmptyThere());
    }
#endif
};

HAIRPAINT_TEST(TestInterruption, Core)
#include "test_interruption.moc"
