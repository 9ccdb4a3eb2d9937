// The command line on images drawn by another program, and on files that are none.
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPainter>
#include <QProcess>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>

#include <cmath>
#include <numbers>
#include <vector>

namespace {

struct Outcome
{
    int code = -1;
    QString output;
    QString error;
};

Outcome hairpaint(const QStringList& arguments, const char* language = "C")
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DISPLAY"));
    environment.remove(QStringLiteral("QT_QPA_PLATFORM"));
    for (const char* name : {"LANG", "LC_ALL", "LC_MESSAGES", "LANGUAGE"})
        environment.remove(QString::fromLatin1(name));
    environment.insert(QStringLiteral("LANG"), QLatin1StringView(language) + QStringLiteral(".UTF-8"));
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(HAIRPAINT_PROGRAM), arguments);
    if (!process.waitForFinished(180'000))
        return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

struct HairFile
{
    std::vector<quint16> segments;
    std::vector<float> points;

    static HairFile read(const QString& path)
    {
        const QByteArray bytes = contentOf(path);
        HairFile hair;
        if (bytes.size() < 128 || !bytes.startsWith("HAIR"))
            return hair;
        const auto strands = qFromLittleEndian<quint32>(bytes.constData() + 4);
        const auto points = qFromLittleEndian<quint32>(bytes.constData() + 8);
        hair.segments.resize(strands);
        hair.points.resize(std::size_t{points} * 3);
        std::memcpy(hair.segments.data(), bytes.constData() + 128, strands * sizeof(quint16));
        std::memcpy(hair.points.data(), bytes.constData() + 128 + strands * sizeof(quint16),
                    points * 3 * sizeof(float));
        return hair;
    }

    /// Sum of a strand's segment lengths.
    [[nodiscard]] std::vector<double> lengths() const
    {
        std::vector<double> result;
        std::size_t point = 0;
        for (const quint16 count : segments) {
            double length = 0.0;
            for (int i = 0; i < count; ++i, ++point) {
                const float* a = &points[point * 3];
                length += std::hypot(double(a[3]) - a[0], double(a[4]) - a[1], double(a[5]) - a[2]);
            }
            ++point;
            result.push_back(length);
        }
        return result;
    }
};

} // namespace

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

    [[nodiscard]] QJsonObject infoOf(const QString& project) const
    {
        const Outcome outcome = hairpaint({QStringLiteral("info"), project, QStringLiteral("--json")});
        return QJsonDocument::fromJson(outcome.output.toUtf8()).object();
    }

private Q_SLOTS:
    void hairsAreProportionalToTheGreen()
    {
        double full = 0.0;
        for (const int green : {255, 191, 128, 64}) {
            // Green value g on white-to-green: red and blue fall as the value rises.
            const QString image = filled("density.png", QColor(255 - green, 255, 255 - green));
            const QString project = path("density.hairpaint");
            const Outcome made = hairpaint({QStringLiteral("new"), QStringLiteral("-o"), project,
                                            QStringLiteral("--map"), QStringLiteral("density=") + image});
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

    void whiteBlackAndGreyGrowNothing()
    {
        for (const QColor& colour : {QColor(Qt::white), QColor(Qt::black), QColor(128, 128, 128)}) {
            const QString project = path("bare.hairpaint");
            QCOMPARE(hairpaint({QStringLiteral("new"), QStringLiteral("-o"), project, QStringLiteral("--map"),
                                QStringLiteral("density=") + filled("bare.png", colour)})
                         .code,
                     0);
            QCOMPARE(infoOf(project).value(QLatin1String("hairs")).toInt(-1), 0);
        }
    }

    void lengthsAreProportionalToTheBlue()
    {
        const QString density = filled("d.png", QColor(235, 255, 235));
        double atFull = 0.0;
        for (const int blue : {255, 128, 51}) {
            const QString project = path("length.hairpaint");
            const QString hair = path("length.hair");
            QCOMPARE(hairpaint({QStringLiteral("new"), QStringLiteral("-o"), project, QStringLiteral("--map"),
                                QStringLiteral("density=") + density, QStringLiteral("--map"),
                                QStringLiteral("length=") + filled("l.png", QColor(255 - blue, 255 - blue, 255))})
                         .code,
                     0);
            QCOMPARE(hairpaint({QStringLiteral("export"), project, QStringLiteral("-o"), hair}).error, QString());
            const HairFile file = HairFile::read(hair);
            QVERIFY(file.segments.size() > 1000);
            QCOMPARE(int(file.segments.size()), infoOf(project).value(QLatin1String("exported")).toInt());
            const std::vector<double> lengths = file.lengths();
            if (blue == 255)
                atFull = lengths.front();
            QVERIFY(atFull > 0.05);
            for (const double length : lengths)
                QVERIFY2(std::abs(length / atFull - blue / 255.0) <= 0.01 * blue / 255.0,
                         qPrintable(QStringLiteral("%1 m at blue %2").arg(length).arg(blue)));
        }
    }

    void theSameCommandGivesTheSameBytes()
    {
        const QString density = filled("same.png", QColor(200, 255, 200));
        QByteArray projects[2];
        QByteArray hairs[2];
        QByteArray pictures[2];
        for (int i = 0; i < 2; ++i) {
            const QString project = path("same.hairpaint");
            QCOMPARE(hairpaint({QStringLiteral("new"), QStringLiteral("-o"), project, QStringLiteral("--map"),
                                QStringLiteral("density=") + density})
                         .code,
                     0);
            QCOMPARE(hairpaint({QStringLiteral("export"), project, QStringLiteral("-o"), path("same.hair"),
                                QStringLiteral("--settle"), QStringLiteral("0.2")})
                         .code,
                     0);
            QCOMPARE(hairpaint({QStringLiteral("render"), project, QStringLiteral("-o"), path("same-out.png"),
                                QStringLiteral("--size"), QStringLiteral("128x128"), QStringLiteral("--settle"),
                                QStringLiteral("0.2")})
                         .error,
                     QString());
            projects[i] = contentOf(project);
            hairs[i] = contentOf(path("same.hair"));
            pictures[i] = contentOf(path("same-out.png"));
            QVERIFY(!projects[i].isEmpty() && !hairs[i].isEmpty() && !pictures[i].isEmpty());
        }
        QVERIFY(projects[0] == projects[1]);
        QVERIFY(hairs[0] == hairs[1]);
        QVERIFY(pictures[0] == pictures[1]);
    }

    void presetsAreListedAndAppliedFromTheCommandLine()
    {
        const Outcome outcome = hairpaint({QStringLiteral("presets"), QStringLiteral("--json")});
        QCOMPARE(outcome.code, 0);
        const QJsonArray list = QJsonDocument::fromJson(outcome.output.toUtf8()).array();
        QVERIFY(list.size() >= 8);
        const QString name = list.first().toObject().value(QLatin1String("name")).toString();
        QCOMPARE(hairpaint({QStringLiteral("new"), QStringLiteral("-o"), path("preset.hairpaint"),
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
        row("info");
        row("info a b");
        row("export p.hairpaint");
        row("export p.hairpaint -o p.docx");
        row("render p.hairpaint -o p.png --size 9x9");
        row("render p.hairpaint -o p.png --view inside");
        row("render p.hairpaint -o p.png --frames 9-3");
        row("render p.hairpaint -o p.png --wind 1,2");
        row("--nonsense");
    }

    void wrongUsageEndsWithTwo()
    {
        QFETCH(QStringList, arguments);
        const Outcome outcome = hairpaint(arguments);
        QCOMPARE(outcome.code, 2);
        QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
    }

    void brokenFilesEndWithOneSentenceAndNothingWritten_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<bool>("exists");
        QTest::newRow("missing") << QByteArray() << false;
        QTest::newRow("empty") << QByteArray() << true;
        QTest::newRow("text") << QByteArray("not a project at all") << true;
        QTest::newRow("zip header alone") << QByteArray("PK\x03\x04 and no more", 17) << true;
        QTest::newRow("zeros") << QByteArray(100'000, '\0') << true;
    }

    void brokenFilesEndWithOneSentenceAndNothingWritten()
    {
        QFETCH(QByteArray, content);
        QFETCH(bool, exists);
        const QString broken = path("broken.hairpaint");
        QFile::remove(broken);
        if (exists) {
            QFile file(broken);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(content);
        }
        const QString out = path("never");
        for (const QStringList& arguments :
             {QStringList{QStringLiteral("info"), broken},
              QStringList{QStringLiteral("export"), broken, QStringLiteral("-o"), out + QStringLiteral(".hair")},
              QStringList{QStringLiteral("render"), broken, QStringLiteral("-o"), out + QStringLiteral(".png")},
              QStringList{QStringLiteral("new"), QStringLiteral("-o"), out + QStringLiteral(".hairpaint"),
                          QStringLiteral("--map"), QStringLiteral("density=") + broken},
              QStringList{QStringLiteral("new"), QStringLiteral("-o"), out + QStringLiteral(".hairpaint"),
                          QStringLiteral("--head"), broken}}) {
            const Outcome outcome = hairpaint(arguments);
            QVERIFY2(outcome.code == 1, qPrintable(arguments.join(QLatin1Char(' ')) + outcome.error));
            QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
            QVERIFY2(outcome.error.contains(QStringLiteral("broken.hairpaint")), qPrintable(outcome.error));
            QCOMPARE(outcome.output, QString());
        }
        QVERIFY(QDir(m_folder.path()).entryList({QStringLiteral("never*")}).isEmpty());
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
        const Outcome outcome = hairpaint({QStringLiteral("info"), missing}, language.constData());
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains(word), qPrintable(outcome.error));
        QVERIFY(outcome.error.contains(missing));
        QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
        // The parser's own words come from Qt's catalogue, and end in a full stop.
        const Outcome wrong =
            hairpaint({QStringLiteral("info"), QStringLiteral("--nonsense"), missing}, language.constData());
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
            const Outcome made = hairpaint({QStringLiteral("new"), QStringLiteral("-o"), project,
                                            QStringLiteral("--preset"), QStringLiteral("Buzz cut")},
                                           language);
            QCOMPARE(made.error, QString());
            files.append(contentOf(project));
            facts.append(hairpaint({QStringLiteral("info"), project, QStringLiteral("--json")}, language).output);
            facts.append(hairpaint({QStringLiteral("presets"), QStringLiteral("--json")}, language).output);
        }
        QVERIFY(!files.front().isEmpty());
        QVERIFY(files.front() == files.back());
        QVERIFY(facts.front().contains(QStringLiteral("Scalp")));
        QCOMPARE(facts.mid(0, 2), facts.mid(2));
    }

    void aStyleIsFoundByItsNameInTheUsersLanguage()
    {
        const QString listed = hairpaint({QStringLiteral("presets")}, "es_ES").output;
        QVERIFY2(listed.contains(QStringLiteral("Rapado\t")), qPrintable(listed));
        for (const char* name : {"rapado", "Buzz cut", "buzz-cut"}) {
            const Outcome made = hairpaint({QStringLiteral("new"), QStringLiteral("-o"), path("named.hairpaint"),
                                            QStringLiteral("--preset"), QString::fromLatin1(name)},
                                           "es_ES");
            QCOMPARE(made.error, QString());
            QCOMPARE(made.code, 0);
        }
    }

    void withoutADisplayTheEditorNamesTheCommandLine()
    {
#ifdef Q_OS_LINUX
        const Outcome outcome = hairpaint({});
        QCOMPARE(outcome.code, 1);
        QVERIFY(outcome.error.contains(QStringLiteral("hairpaint --help")));
#endif
    }
};

QTEST_GUILESS_MAIN(TestCommandLine)
#include "test_command_line.moc"
