// Names that scripts and other systems give: each verb reads and writes the file that is meant, under that name.
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#ifdef Q_OS_LINUX
#include <sys/stat.h>
#include <unistd.h>
#endif

using namespace hairpaint;

class TestOddNames : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QByteArray m_project; ///< A file's bytes.

    [[nodiscard]] static QByteArray bytesOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private Q_SLOTS:
    void initTestCase()
    {
        const QString path = m_folder.filePath(QStringLiteral("plain.hairpaint"));
        model::Project project = test::smallProject();
        sim::TiledRaster& density = project.groups.front().map(model::MapKind::Density).layers.front().raster;
        density = sim::TiledRaster(density.size(), 2, {65535, 65535}); // A few hundred hairs, for others to read.
        project.groups.front().settings.greatestDensityPerM2 = 1e4F;
        QVERIFY(model::saveProject(project, path, {}));
        m_project = bytesOf(path);
    }

    void everyVerbTakesTheName_data()
    {
        QTest::addColumn<QString>("name");
        const auto row = [](const char* what, const char* name) { QTest::newRow(what) << QString::fromUtf8(name); };
        row("spaces", " two  spaces ");
        row("dots", ".take 1.2");
        row("a dash first", "-o");
        row("punctuation", "50%20#1 a{b}[c](d) it's `x` $HOME");
        row("accents, whole and in pieces", "\xC3\xB1 n\xCC\x83");
        row("other scripts", "\xF0\x9F\x92\x87 \xD7\xA9\xD7\xA2\xD7\xA8");
        QTest::newRow("as long as they come") << QString(240, QLatin1Char('x'));
#ifndef Q_OS_WIN // Where these are no names.
        row("question marks and their like", "what?a=1 *:|<>\"\\");
        row("control characters", "two\nlines \x1b[31mred");
#endif
    }
    void everyVerbTakesTheName()
    {
        QFETCH(QString, name);
        const QTemporaryDir root;
        const QString folder = root.filePath(name);
        QVERIFY(QDir().mkdir(folder));
        const auto file = [&](const char* suffix) { return folder + QLatin1Char('/') + name + QLatin1String(suffix); };
        const QString project = file(".hairpaint");
        {
            QFile made(project);
            QVERIFY(made.open(QIODevice::WriteOnly));
            made.write(m_project);
        }
        QStringList there{QFileInfo(project).fileName()};
        const auto passes = [](const QStringList& arguments) {
            const test::Outcome outcome = test::runProgram(arguments);
            if (outcome.code != 0 || !outcome.error.isEmpty())
                qWarning("%d: %s", outcome.code, qPrintable(outcome.error));
            return outcome.code == 0 && outcome.error.isEmpty();
        };
        const auto written = [&](const char* suffix) {
            there += QFileInfo(file(suffix)).fileName();
            return file(suffix);
        };
        QVERIFY(passes({QStringLiteral("info"), project}));
        QVERIFY(passes({QStringLiteral("export"), project, QStringLiteral("-o"), written(".hair"),
                        QStringLiteral("--hairs"), QStringLiteral("100")}));
        QVERIFY(passes({QStringLiteral("export"), project, QStringLiteral("-o"), written(".usdz"),
                        QStringLiteral("--hairs"), QStringLiteral("100")}));
        QVERIFY(
            passes({QStringLiteral("render"), project, QStringLiteral("-o"), written(".png"), QStringLiteral("--size"),
                    QStringLiteral("32x32"), QStringLiteral("--settle"), QStringLiteral("0")}));
        QVERIFY(passes({QStringLiteral("repair"), project, QStringLiteral("-o"), written("2.hairpaint")}));
        QVERIFY(passes({QStringLiteral("new"), QStringLiteral("-o"), written("3.hairpaint"), QStringLiteral("--curves"),
                        file(".hair"), QStringLiteral("--map"), QStringLiteral("density=") + file(".png")}));
        {
            QFile cube(file(".obj"));
            QVERIFY(cube.open(QIODevice::WriteOnly));
            cube.write("v 0 0 0\nv 0.2 0 0\nv 0 0.2 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
            there += QFileInfo(cube).fileName();
        }
        const test::Outcome head = test::runProgram({QStringLiteral("new"), QStringLiteral("-o"),
                                                     written("4.hairpaint"), QStringLiteral("--head"), file(".obj")});
        QVERIFY2(head.code == 0, qPrintable(head.error));
        there.sort();
        QStringList found = QDir(folder).entryList(QDir::Files | QDir::Hidden);
        found.sort();
        QCOMPARE(found, there);
        QVERIFY(model::loadProject(file("2.hairpaint")));
        QVERIFY(model::loadProject(file("3.hairpaint")));
        QCOMPARE(bytesOf(project), m_project);
    }

#ifdef Q_OS_LINUX
    /// Qt spells names in UTF-8, so a folder of another spelling is worked in from inside.
    void aFolderOfAnotherSpellingIsWorkedIn()
    {
        const QTemporaryDir root;
        const QByteArray folder = QFile::encodeName(root.path()) + "/caf\xE9";
        QCOMPARE(::mkdir(folder.constData(), 0700), 0);
        const auto inFolder = [&folder] { (void)!::chdir(folder.constData()); };
        const auto passes = [&inFolder](const char* arguments) {
            const test::Outcome outcome =
                test::runProgram(QString::fromLatin1(arguments).split(QLatin1Char(' ')), inFolder);
            return outcome.error.isEmpty() ? QString::number(outcome.code) : outcome.error;
        };
        QCOMPARE(passes("new -o p.hairpaint --preset Bob"), QStringLiteral("0"));
        QCOMPARE(passes("render p.hairpaint -o p.png --size 32x32 --settle 0"), QStringLiteral("0"));
        QCOMPARE(passes("render p.hairpaint -o p.png --size 32x32 --settle 0 --frames 1-1"), QStringLiteral("0"));
        QCOMPARE(passes("new -o p.hairpaint --map length=p.png"), QStringLiteral("0"));
        QCOMPARE(passes("export p.hairpaint -o p.glb --hairs 100"), QStringLiteral("0"));
        for (const char* name : {"p.hairpaint", "p.png", "p.0001.png", "p.glb"})
            QCOMPARE(::unlink((folder + '/' + name).constData()), 0);
        QCOMPARE(::rmdir(folder.constData()), 0);
    }
#endif

    /// What is told of a name stays one line of letters.
    void aSentenceHoldsNoControlCharacters()
    {
        const QString name = QStringLiteral("two\nlines \x1b[31mred\x07\x7f.hairpaint");
        const test::Outcome outcome = test::runProgram({QStringLiteral("info"), m_folder.filePath(name)});
        QCOMPARE(outcome.code, 1);
        QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
        for (const QChar c : outcome.error.chopped(1))
            QVERIFY2(c.isPrint(), qPrintable(outcome.error));
    }
};

HAIRPAINT_TEST(TestOddNames, Core)
#include "test_odd_names.moc"
