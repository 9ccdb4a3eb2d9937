// The real program, told to end from outside while its window is open.
#include "tests/support/locations.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#ifdef Q_OS_UNIX
#include <csignal>
#endif

using namespace hairpaint::test;

class TestEndedWindow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
#ifdef Q_OS_UNIX
    void itEndsWellAndWithoutAWord_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("kill") << SIGTERM;
        QTest::newRow("Ctrl+C") << SIGINT;
        QTest::newRow("the end of a login") << SIGHUP;
    }
    void itEndsWellAndWithoutAWord()
    {
        QFETCH(int, signal);
        const QTemporaryDir home;
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove(QStringLiteral("XDG_RUNTIME_DIR")); // Qt would warn of it.
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        environment.insert(QStringLiteral("QT_LOGGING_RULES"), QStringLiteral("hairpaint.start=true"));
        environment.insert(QStringLiteral("XDG_DATA_HOME"), home.path());
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), home.path());
        program.setProcessEnvironment(environment);
        program.setChildProcessModifier([] {
            for (const int one : {SIGTERM, SIGINT, SIGHUP})
                std::signal(one, SIG_DFL); // Whatever the one who runs the tests ignores.
        });
        program.start(hairpaintProgram(), QStringList());
        QByteArray said;
        const auto isOpen = [&] {
            said += program.readAllStandardError();
            return said.contains("hairs after");
        };
        QTRY_VERIFY_WITH_TIMEOUT(isOpen(), kPatienceMs);
        ::kill(static_cast<pid_t>(program.processId()), signal);
        QVERIFY(program.waitForFinished(kPatienceMs));
        said += program.readAllStandardError();
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(program.exitCode(), 0);
        QVERIFY2(said.count('\n') == 1, said.constData());
    }
#endif
};

HAIRPAINT_TEST(TestEndedWindow, Core)
#include "test_ended_window.moc"
