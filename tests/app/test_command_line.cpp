// The command line: its verbs, its exit codes. Maps from images: test_drawn_images.cpp; files that are none:
// test_broken_files.cpp.
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "tests/app/program.h"
#include "tests/support/locations.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

#include <QImage>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#ifdef Q_OS_LINUX
#include <fcntl.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <cmath>

using namespace hairpaint::test;

class TestCommandLine : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    [[nodiscard]] QString filled(const char* name, const QColor& colour, int size = 256) const
    {
        QImage image(size, size, QImage::Format_RGB32);
        image.fill(colour);
        const QString file = path(name);
        image.save(file);
        return file;
    }

private Q_SLOTS:
    void hairsAreProportionalToTheGreen()
    {
        double full = 0.0;
        for (const int green : {255, 191, 128, 64}) {
            // Green value g on white-to-green: red and blue fall as the value rises.
            const QString image = filled("density.png", QColor(255 - green, 255, 255 - green));
            const QString project = path("density.hairpaint");
            const Outcome made = runProgram({QStringLiteral("new"), QStringLiteral("-o"), project,
                                             QStringLiteral("--map"), QStringLiteral("density=") + image,
                                             QStringLiteral("--max-candidates"), QStringLiteral("50000")});
            QCOMPARE(made.error, QString());
            QCOMPARE(made.code, 0);
            const double hairs = infoOf(project).value(QLatin1String("hairs")).toDouble();
            if (green == 255)
                full = hairs;
            QVERIFY(full > 10'000.0);
            QVERIFY2(std::abs(hairs / full - green / 255.0) <= 0.02 * green / 255.0,
                     qPrintable(QStringLiteral("%1 of %2 at green %3").arg(hairs).arg(full).arg(green)));
        }
    }

    void whiteAndBlackGrowNothing()
    {
        for (const QColor& colour : {QColor(Qt::white), QColor(Qt::black)}) {
            const QString project = path("bare.hairpaint");
            QCOMPARE(runProgram({QStringLiteral("new"), QStringLiteral("-o"), project, QStringLiteral("--map"),
                                 QStringLiteral("density=") + filled("bare.png", colour)})
                         .code,
                     0);
            QCOMPARE(infoOf(project).value(QLatin1String("hairs")).toInt(-1), 0);
        }
    }

    void presetsAreListedAndAppliedFromTheCommandLine()
    {
        const Outcome outcome = runProgram({QStringLiteral("presets"), QStringLiteral("--json")});
        QCOMPARE(outcome.code, 0);
        const QJsonArray list = QJsonDocument::fromJson(outcome.output.toUtf8()).array();
        QVERIFY(list.size() >= 8);
        const QString name = list.first().toObject().value(QLatin1String("name")).toString();
        QCOMPARE(runProgram({QStringLiteral("new"), QStringLiteral("-o"), path("preset.hairpaint"),
                             QStringLiteral("--preset"), name})
                     .code,
                 0);
        QVERIFY(infoOf(path("preset.hairpaint")).value(QLatin1String("hairs")).toInt() > 10'000);
    }

    void wrongUsageEndsWithTwo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const auto row = [](const char* line) {
            QTest::newRow(line) << QString::fromLatin1(line).split(QLatin1Char(' '));
        };
        row("new");
        row("new --map density=x.png");
        row("new -o p.hairpaint --map nonsense=x.png");
        row("new -o p.hairpaint --seed many");
        row("new -o p.hairpaint --max-hairs 0");
        row("new -o p.hairpaint --max-candidates 0");
        row("export p.hairpaint -o p.hair --hairs 0");
        row("export p.hairpaint -o p.hair --wind 1,2,x");
        row("render p.hairpaint -o p.png --hairs all");
        row("info");
        row("info a b");
        row("export p.hairpaint");
        row("export p.hairpaint -o p.docx");
        row("export p.hairpaint -o p.usda --target cinema");
        row("export p.hairpaint -o p.usda --tolerance -1");
        row("export p.hairpaint -o p.usda --tolerance 11");
        row("export p.hairpaint -o p.usda --frames 4-2");
        row("export p.hairpaint -o p.usda --frames 2-4 --tolerance 1");
        row("export p.hairpaint --maps . --depth 12");
        row("export p.hairpaint --maps . --image gif");
        row("export p.hairpaint --uv-sheet p.png");
        row("export p.hairpaint -o p.hair --grey");
        row("export p.hairpaint -o p.hair --depth 8");
        row("export p.hairpaint --uv-sheet p.svg --image png");
        row("export p.hairpaint --maps . --frames 1-2");
        row("export p.hairpaint --maps . --target blender");
        row("render p.hairpaint -o p.png --size 9x9");
        row("render p.hairpaint -o p.png --view inside");
        row("render p.hairpaint -o p.png --frames 9-3");
        row("render p.hairpaint -o p.png --wind 1,2");
        row("render p.hairpaint -o p.png --frames 0-3 --motion bow");
        row("render p.hairpaint -o p.png --motion nod");
        row("export p.hairpaint -o p.hair --motion bow");
        row("--nonsense");
        row("new -o p.hairpaint --max-candidates 1e3");
        row("export p.hairpaint -o p.hair --hairs 2.5");
        row("new -o p.hairpaint --map /density=x.png");
        row("new -o p.png");
        row("new -o p");
        row("new -o p.");
        row("new -o p.hairpaint.zip");
        row("repair p.hairpaint -o q");
        row("render p.hairpaint -o p");
        row("export p.hairpaint -o p");
        row("export p.hairpaint --uv-sheet p");
        row("new -o p.hairpaint --head ");
        row("new -o p.hairpaint --preset ");
    }

    void wrongUsageEndsWithTwo()
    {
        QFETCH(QStringList, arguments);
        const Outcome outcome = runProgram(arguments);
        QCOMPARE(outcome.code, 2);
        QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
    }

    void whatCannotBePrintedFails()
    {
#ifdef Q_OS_LINUX
        for (const char* arguments : {"presets", "--version", "--help", "new --help"}) {
            const Outcome outcome = runProgram(QString::fromLatin1(arguments).split(QLatin1Char(' ')), [] {
                const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
                ::dup2(full, STDOUT_FILENO);
            });
            QCOMPARE(outcome.code, 1);
            QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
        }
#endif
    }

    void namesReachATerminalTamed()
    {
        const QString name = QStringLiteral("two  spaces \x1b[31mred\x07.hairpaint");
        const Outcome outcome = runProgram({QStringLiteral("info"), path("x").chopped(1) + name});
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains(QStringLiteral("two  spaces")), qPrintable(outcome.error));
        QVERIFY(!outcome.error.contains(QChar(0x1b)));
        QVERIFY(!outcome.error.contains(QChar(0x07)));
        QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
    }

    /// A file of somebody else's moves no cursor, writes no title and makes no line or column that is not there;
    /// scripts get its names as they are.
    void whatFilesHoldReachesATerminalTamed_data()
    {
        QTest::addColumn<QString>("hostile");
        QTest::newRow("a command to the terminal") << QStringLiteral("\x1b]0;title\x07 \x1b[2J");
        QTest::newRow("a command in one character") << QStringLiteral("\u009b31m");
        QTest::newRow("a line and a column") << QStringLiteral("one\ttwo\r\nGroup x: 3");
        QTest::newRow("a deleted character") << QStringLiteral("a\x08\x7f");
        QTest::newRow("other lines") << QStringLiteral("one\u2028two\u2029\u0085");
        QTest::newRow("writing turned around") << QStringLiteral("\u202egpj\u2066.exe\u200f");
    }
    void whatFilesHoldReachesATerminalTamed()
    {
        using namespace hairpaint;
        QFETCH(QString, hostile);
        const QString name = QStringLiteral("Häar ") + hostile;
        const auto isTame = [](const QString& text) {
            return std::ranges::none_of(text, [](QChar c) {
                return (c.category() == QChar::Other_Control && c != QLatin1Char('\n') && c != QLatin1Char('\t')) ||
                       c.category() == QChar::Separator_Line || c.category() == QChar::Separator_Paragraph ||
                       (c.category() == QChar::Other_Format);
            });
        };
        const QTemporaryDir data;
#ifdef Q_OS_WIN // Where the system wants it, whatever the environment says.
        const QString home = qEnvironmentVariable("APPDATA");
#else
        const QString home = data.path();
#endif
        qputenv("XDG_DATA_HOME", QFile::encodeName(home));
        const auto restored = qScopeGuard([] { qunsetenv("XDG_DATA_HOME"); });
        model::Project project = model::newProject();
        project.groups.front().name = name;
        project.maxHairs = 500; // Only names matter.
        QVERIFY(model::saveProject(project, path("hostile.hairpaint"), {}));
        const QString styles = home + QStringLiteral("/Hair Paint/hairpaint/styles");
        QVERIFY(QDir().mkpath(styles));
        const QString styleFile = styles + QStringLiteral("/hostile.hairpreset");
        const auto removed = qScopeGuard([&styleFile] { QFile::remove(styleFile); });
        model::Preset style = model::presetFrom(project, name);
        style.tags = QStringList{hostile};
        QVERIFY(model::savePreset(style, styleFile));

        const QString info = path("hostile.hairpaint");
        const QString plain = runProgram({QStringLiteral("info"), info}).output;
        QVERIFY2(isTame(plain) && plain.contains(QStringLiteral("Häar ")), qPrintable(plain));
        QCOMPARE(plain.count(QStringLiteral("\nGroup ")), 1);
        QVERIFY(!plain.contains(QLatin1Char('\t')));
        const QString json = runProgram({QStringLiteral("info"), info, QStringLiteral("--json")}).output;
        QVERIFY2(isTame(json), qPrintable(json));
        QCOMPARE(QJsonDocument::fromJson(json.toUtf8())[QLatin1String("groups")][0][QLatin1String("name")].toString(),
                 name);

        const QStringList listed = runProgram({QStringLiteral("presets")})
                                       .output.trimmed()
                                       .split(QLatin1Char('\n'))
                                       .filter(QStringLiteral("Häar "));
        QCOMPARE(listed.size(), 1);
        QVERIFY2(isTame(listed.front()), qPrintable(listed.front()));
        QCOMPARE(listed.front().count(QLatin1Char('\t')), 2);
        const QString all = runProgram({QStringLiteral("presets"), QStringLiteral("--json")}).output;
        QVERIFY2(isTame(all), qPrintable(all));
        const QJsonArray styleList = QJsonDocument::fromJson(all.toUtf8()).array();
        QVERIFY(std::ranges::any_of(styleList, [&](const QJsonValue& style) {
            return style[QLatin1String("name")].toString() == name &&
                   style[QLatin1String("tags")][0].toString() == hostile;
        }));

        const Outcome failed = runProgram(
            {QStringLiteral("export"), info, QStringLiteral("-o"), path("x.hair"), QStringLiteral("--group"), hostile});
        QCOMPARE(failed.code, 1);
        QVERIFY2(isTame(failed.error), qPrintable(failed.error));
        QCOMPARE(failed.error.count(QLatin1Char('\n')), 1);
    }

    void theVersionTellsWhatHoldsTheHelper()
    {
        const Outcome outcome = runProgram({QStringLiteral("--version")});
        QCOMPARE(outcome.code, 0);
        const QStringList lines = outcome.output.split(QLatin1Char('\n'));
        QVERIFY2(lines.front().startsWith(QStringLiteral("Hair Paint ")), qPrintable(outcome.output));
        for (const char* layer : {"  files: ", "  system calls: ", "  memory: "})
            QCOMPARE(lines.filter(QString::fromLatin1(layer)).size(), 1);
        qputenv("HAIRPAINT_IMPORT", "/nowhere");
        const auto restored = qScopeGuard([] { qunsetenv("HAIRPAINT_IMPORT"); });
        const Outcome without = runProgram({QStringLiteral("--version")});
        QCOMPARE(without.code, 0);
        QVERIFY2(without.output.contains(QStringLiteral("hairpaint-import, does not answer")),
                 qPrintable(without.output));
    }

    void anOutputWithoutAnEndingIsRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        for (const char* verb : {"export", "render", "repair"})
            QTest::newRow(verb) << QStringList{QString::fromLatin1(verb), QStringLiteral("a.hairpaint")};
        QTest::newRow("new") << QStringList{QStringLiteral("new")};
    }
    void anOutputWithoutAnEndingIsRefused()
    {
        QFETCH(const QStringList, arguments);
        const Outcome outcome = runProgram(arguments + QStringList{QStringLiteral("-o"), path("unended")});
        QCOMPARE(outcome.code, 2);
        QVERIFY2(outcome.error.contains(QStringLiteral("takes a name that ends in .")), qPrintable(outcome.error));
        QVERIFY(!QFileInfo::exists(path("unended")));
    }

    /// Such names can't be told apart once they are text: nothing is written under another one.
    void namesThatAreNotUtf8AreRefused()
    {
#ifdef Q_OS_UNIX
        QProcess process; // By a shell, for QProcess can't give such bytes either.
        process.setWorkingDirectory(m_folder.path());
        process.start(QStringLiteral("/bin/sh"),
                      {QStringLiteral("-c"),
                       QStringLiteral("mkdir bytes && exec '%1' new -o \"bytes/$(printf 'caf\\351').hairpaint\"")
                           .arg(hairpaintProgram())});
        QVERIFY(process.waitForFinished(kPatienceMs));
        QCOMPARE(process.exitCode(), 2);
        QCOMPARE(process.readAllStandardError().count('\n'), 1);
        QVERIFY(QDir(path("bytes")).isEmpty());
#endif
    }

    void aCommandsHelpTellsOfEachOption_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("new") << QStringList{QStringLiteral("--map"), QStringLiteral("--max-candidates")};
        QTest::newRow("info") << QStringList{QStringLiteral("--json")};
        QTest::newRow("presets") << QStringList{QStringLiteral("--json")};
        QTest::newRow("export") << QStringList{QStringLiteral("--target"),    QStringLiteral("--group"),
                                               QStringLiteral("--tolerance"), QStringLiteral("--settle"),
                                               QStringLiteral("--hairs"),     QStringLiteral("--wind"),
                                               QStringLiteral("--motion")};
        QTest::newRow("render") << QStringList{QStringLiteral("--size"), QStringLiteral("--frames"),
                                               QStringLiteral("--wind"), QStringLiteral("--motion")};
    }
    void aCommandsHelpTellsOfEachOption()
    {
        QFETCH(QStringList, options);
        const QString verb = QString::fromLatin1(QTest::currentDataTag());
        for (const QStringList& arguments : {QStringList{verb, QStringLiteral("--help")},
                                             QStringList{verb, path("none.hairpaint"), QStringLiteral("-h")}}) {
            const Outcome outcome = runProgram(arguments);
            QCOMPARE(outcome.code, 0);
            QCOMPARE(outcome.error, QString());
            QVERIFY(outcome.output.startsWith(QStringLiteral("hairpaint ") + verb));
            for (const QString& option : options)
                QCOMPARE(outcome.output.count(QRegularExpression(QStringLiteral("\n  %1(?![\\w-])").arg(option))), 1);
        }
    }

    void aSeedHasNoSign()
    {
        const quint64 seed = 18'446'744'073'709'551'557ULL;
        hairpaint::model::Project project = hairpaint::model::newProject();
        project.seed = seed;
        project.maxHairs = 500;
        project.groups.front().name = QStringLiteral("\"seed\": -59");
        QVERIFY(hairpaint::model::saveProject(project, path("seed.hairpaint"), {}));
        const QString json =
            runProgram({QStringLiteral("info"), path("seed.hairpaint"), QStringLiteral("--json")}).output;
        QVERIFY2(json.contains(QStringLiteral("\"seed\": 18446744073709551557\n")), qPrintable(json));
        QCOMPARE(QJsonDocument::fromJson(json.toUtf8())[QLatin1String("groups")][0][QLatin1String("name")].toString(),
                 project.groups.front().name);
        const QString text = runProgram({QStringLiteral("info"), path("seed.hairpaint")}).output;
        QVERIFY2(text.contains(QStringLiteral("seed 18446744073709551557\n")), qPrintable(text));
    }

    void itSpeaksTheLanguageOfTheSystem_data()
    {
        QTest::addColumn<QByteArray>("language");
        QTest::addColumn<QString>("word");
        QTest::newRow("Spanish") << QByteArray("es_ES") << QStringLiteral("no existe tal archivo");
        QTest::newRow("Mexican Spanish") << QByteArray("es_MX") << QStringLiteral("no existe tal archivo");
        QTest::newRow("a language that it does not know") << QByteArray("xh_ZA") << QStringLiteral("no such file");
    }
    void itSpeaksTheLanguageOfTheSystem()
    {
        QFETCH(QByteArray, language);
        QFETCH(QString, word);
        const QString missing = path("missing.hairpaint");
        const Outcome outcome = runProgram({QStringLiteral("info"), missing}, {}, language.constData());
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains(word), qPrintable(outcome.error));
        QVERIFY(outcome.error.contains(QDir::toNativeSeparators(missing)));
        QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
        // The parser's own words come from Qt's catalogue, and end in a full stop.
        const Outcome wrong =
            runProgram({QStringLiteral("info"), QStringLiteral("--nonsense"), missing}, {}, language.constData());
        QCOMPARE(wrong.code, 2);
        QCOMPARE(wrong.error.count(QLatin1Char('\n')), 1);
        QVERIFY2(!wrong.error.contains(QStringLiteral("..")), qPrintable(wrong.error));
    }

    void filesAndJsonAreTheSameInEveryLanguage()
    {
        QList<QByteArray> files;
        QStringList facts;
        for (const char* language : {"en_GB", "es_ES"}) {
            const QString project = path("spoken.hairpaint");
            const Outcome made = runProgram({QStringLiteral("new"), QStringLiteral("-o"), project,
                                             QStringLiteral("--preset"), QStringLiteral("Buzz cut")},
                                            {}, language);
            QCOMPARE(made.error, QString());
            files.append(contentOf(project));
            facts.append(runProgram({QStringLiteral("info"), project, QStringLiteral("--json")}, {}, language).output);
            facts.append(runProgram({QStringLiteral("presets"), QStringLiteral("--json")}, {}, language).output);
        }
        QVERIFY(!files.front().isEmpty());
        QVERIFY(files.front() == files.back());
        QVERIFY(facts.front().contains(QStringLiteral("Scalp")));
        QCOMPARE(facts.mid(0, 2), facts.mid(2));
    }

    void factsAreToldInTheUsersLanguageWhateverTheNamesAre()
    {
        // A head's name that looks like a placeholder of another text.
        const QString mesh = path("%2.obj");
        QFile file(mesh);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
        file.close();
        const QString project = path("named.hairpaint");
        QCOMPARE(
            runProgram({QStringLiteral("new"), QStringLiteral("-o"), project, QStringLiteral("--head"), mesh}).code, 0);
        const QString said = runProgram({QStringLiteral("info"), project}, {}, "es_ES").output;
        QVERIFY2(said.startsWith(QStringLiteral("Cabeza: %2, 3 vértices, 1 triángulos\n")), qPrintable(said));
        QVERIFY2(said.contains(QStringLiteral("\n  Densidad: 1")), qPrintable(said));
    }

    void aStyleIsFoundByItsNameInTheUsersLanguage()
    {
        const QString listed = runProgram({QStringLiteral("presets")}, {}, "es_ES").output;
        QVERIFY2(listed.contains(QStringLiteral("Rapado\t")), qPrintable(listed));
        for (const char* name : {"rapado", "Buzz cut", "buzz-cut"}) {
            const Outcome made = runProgram({QStringLiteral("new"), QStringLiteral("-o"), path("named.hairpaint"),
                                             QStringLiteral("--preset"), QString::fromLatin1(name)},
                                            {}, "es_ES");
            QCOMPARE(made.error, QString());
            QCOMPARE(made.code, 0);
        }
    }

#ifdef Q_OS_LINUX
    void withoutADisplayTheEditorNamesTheCommandLine_data()
    {
        QTest::addColumn<QByteArray>("display");
        QTest::addColumn<QByteArray>("language");
        QTest::addColumn<QString>("words");
        const QString english = QStringLiteral("There is no display to open a window on.");
        QTest::newRow("none is named") << QByteArray() << QByteArray("C") << english;
        QTest::newRow("there is none of that number") << QByteArray(":7777") << QByteArray("C") << english;
        QTest::newRow("nothing listens at that port") << QByteArray("127.0.0.1:7777") << QByteArray("C") << english;
        QTest::newRow("its name is nonsense") << QByteArray("%1 \n") << QByteArray("C") << english;
        QTest::newRow("in Spanish") << QByteArray(":7777") << QByteArray("es_ES")
                                    << QStringLiteral("No hay pantalla donde abrir una ventana.");
    }

    void withoutADisplayTheEditorNamesTheCommandLine()
    {
        QFETCH(QByteArray, display);
        QFETCH(QByteArray, language);
        QFETCH(QString, words);
        const Outcome outcome =
            runProgram({}, {}, language.constData(), display.isEmpty() ? nullptr : display.constData());
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains(words), qPrintable(outcome.error));
        QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
        // A command that works as it stands.
        const QString command = hairpaintProgram() + QStringLiteral(" --help\n");
        QVERIFY2(outcome.error.endsWith(QLatin1Char(' ') + command), qPrintable(outcome.error));
    }
#endif
};

HAIRPAINT_TEST(TestCommandLine, Core)
#include "test_command_line.moc"
