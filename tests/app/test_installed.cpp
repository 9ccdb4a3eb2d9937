// What `cmake --install` writes on Linux runs from there, with an empty home, and desktops know it.
#include "app/cli/command.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QVersionNumber>
#include <QtTest>

using namespace hairpaint;

namespace {

constexpr int kPatienceMs = 120'000;

struct Outcome
{
    int code = -1;
    QString output; ///< Standard output and standard error together.
};

} // namespace

class TestInstalled : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        const Outcome installed =
            run(QStringLiteral(HAIRPAINT_CMAKE),
                {QStringLiteral("--install"), test::buildFolder(), QStringLiteral("--prefix"), prefix()});
        QVERIFY2(installed.code == 0, qPrintable(installed.output));
    }

    void theProgramAndItsHelperStartFromThere()
    {
        const Outcome version = hairpaint({QStringLiteral("--version")});
        QCOMPARE(version.code, 0);
        QVERIFY2(version.output.startsWith(QStringLiteral("Hair Paint " HAIRPAINT_PROJECT_VERSION "\n")),
                 qPrintable(version.output));
        for (const char* library : {"Qt ", "OpenImageIO ", "Assimp ", "oneTBB ", "OpenEXR "})
            QVERIFY2(version.output.contains(QRegularExpression(QLatin1String(library) + QStringLiteral("\\d+\\."))),
                     qPrintable(version.output));
        QVERIFY2(version.output.contains(QStringLiteral("  memory: at most")), qPrintable(version.output));
    }

    void aProjectIsMadeDrawnAndExportedFromThere()
    {
        const QString project = path("my hair.hairpaint");
        const QString image = path("grey.png");
        QImage half(64, 64, QImage::Format_Grayscale8);
        half.fill(128);
        QVERIFY(half.save(image));
        Outcome outcome = hairpaint({QStringLiteral("new"), QStringLiteral("-o"), project, QStringLiteral("--map"),
                                     QStringLiteral("density=") + image});
        QVERIFY2(outcome.code == 0, qPrintable(outcome.output));
        outcome = hairpaint({QStringLiteral("render"), project, QStringLiteral("-o"), path("p.png"),
                             QStringLiteral("--size"), QStringLiteral("120x120"), QStringLiteral("--settle"),
                             QStringLiteral("0"), QStringLiteral("--hairs"), QStringLiteral("2000")});
        QVERIFY2(outcome.code == 0, qPrintable(outcome.output));
        QCOMPARE(QImage(path("p.png")).size(), QSize(120, 120));
        outcome = hairpaint({QStringLiteral("export"), project, QStringLiteral("-o"), path("p.hair"),
                             QStringLiteral("--settle"), QStringLiteral("0"), QStringLiteral("--hairs"),
                             QStringLiteral("2000")});
        QVERIFY2(outcome.code == 0, qPrintable(outcome.output));
    }

    /// What lies in the prefix may lie anywhere.
    void nothingNamesTheSources()
    {
        QDirIterator walk(prefix(), QDir::Files, QDirIterator::Subdirectories);
        int files = 0;
        while (walk.hasNext()) {
            QFile file(walk.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY2(!file.readAll().contains(test::sourcePath(u"").toUtf8()), qPrintable(file.fileName()));
            ++files;
        }
        QVERIFY(files >= 10);
    }

    void desktopsAcceptIt_data()
    {
        QTest::addColumn<QString>("checker");
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("menu entry") << QStringLiteral("desktop-file-validate")
                                    << QStringList{QStringLiteral("share/applications/hairpaint.desktop")};
        QTest::newRow("software centre") << QStringLiteral("appstreamcli")
                                         << QStringList{
                                                QStringLiteral("validate"), QStringLiteral("--no-net"),
                                                QStringLiteral("share/metainfo/org.hairpaint.HairPaint.metainfo.xml")};
        QTest::newRow("manual page") << QStringLiteral("man")
                                     << QStringList{QStringLiteral("--warnings"), QStringLiteral("-l"),
                                                    QStringLiteral("share/man/man1/hairpaint.1.gz")};
    }
    void desktopsAcceptIt()
    {
        QFETCH(const QString, checker);
        QFETCH(const QStringList, arguments);
        const Outcome outcome = run(checker, arguments);
        QVERIFY2(outcome.code == 0, qPrintable(outcome.output));
        QVERIFY2(!outcome.output.contains(QStringLiteral("warning:")), qPrintable(outcome.output));
    }

    void filesOfOursAreKnown_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("type");
        QTest::newRow("project") << QStringLiteral("a.hairpaint") << QStringLiteral("application/x-hairpaint");
        QTest::newRow("style") << QStringLiteral("a.hairpreset") << QStringLiteral("application/x-hairpaint-preset");
    }
    void filesOfOursAreKnown()
    {
        QFETCH(const QString, name);
        QFETCH(const QString, type);
        Outcome outcome = run(QStringLiteral("update-mime-database"), {prefix() + QStringLiteral("/share/mime")});
        QVERIFY2(outcome.code == 0, qPrintable(outcome.output));
        QFile file(path(qPrintable(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("PK");
        file.close();
        outcome =
            run(QStringLiteral("xdg-mime"), {QStringLiteral("query"), QStringLiteral("filetype"), file.fileName()});
        QCOMPARE(outcome.output.trimmed(), type);
        QFile menuEntry(prefix() + QStringLiteral("/share/applications/hairpaint.desktop"));
        QVERIFY(menuEntry.open(QIODevice::ReadOnly));
        QVERIFY(menuEntry.readAll().contains(type.toLatin1() + ';'));
    }

    void theManualPageHasEveryOption()
    {
        QFile file(test::sourcePath(u"resources/packaging/hairpaint.1.in"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QString page = QString::fromUtf8(file.readAll());
        page.replace(QStringLiteral("\\-"), QStringLiteral("-")).replace(QStringLiteral("\\(aq"), QStringLiteral("'"));
        for (const app::Command& command : app::commands()) {
            const QStringList lines = helpOf(command, true);
            QVERIFY2(page.contains(lines.front()), qPrintable(lines.front()));
            for (const QString& line : lines.mid(2))
                QVERIFY2(page.contains(line.trimmed()), qPrintable(line));
        }
    }

    void theVersionStandsInOneFile()
    {
        QFile file(test::sourcePath(u"vcpkg.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\"version-string\": \"" HAIRPAINT_PROJECT_VERSION "\""));
        QFile changes(test::sourcePath(u"resources/packaging/debian/changelog"));
        QVERIFY(changes.open(QIODevice::ReadOnly));
        QVERIFY(changes.readLine().startsWith("hairpaint (" HAIRPAINT_PROJECT_VERSION ")"));
    }

private:
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromUtf8(name)); }
    [[nodiscard]] QString prefix() const { return path("opt/hair paint \u00e9"); }

    /// In the prefix, with a home of its own.
    Outcome run(const QString& program, const QStringList& arguments)
    {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove(QStringLiteral("HAIRPAINT_IMPORT"));
        environment.insert(QStringLiteral("HOME"), path("home"));
        for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
            environment.remove(QString::fromLatin1(name));
        environment.insert(QStringLiteral("XDG_DATA_DIRS"),
                           prefix() + QStringLiteral("/share:/usr/local/share:/usr/share"));
        environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
        QDir(m_folder.path()).mkpath(QStringLiteral("home"));
        process.setProcessEnvironment(environment);
        if (QDir(prefix()).exists())
            process.setWorkingDirectory(prefix());
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(program, arguments);
        if (!process.waitForFinished(kPatienceMs))
            return {.output = program + QStringLiteral(": ") + process.errorString()};
        return {.code = process.exitCode(), .output = QString::fromUtf8(process.readAll())};
    }
    Outcome hairpaint(const QStringList& arguments)
    {
        return run(prefix() + QStringLiteral("/bin/hairpaint"), arguments);
    }

    QTemporaryDir m_folder;
};

HAIRPAINT_TEST(TestInstalled, None)
#include "test_installed.moc"
