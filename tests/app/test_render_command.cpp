// `hairpaint render`: films at every rate and from every frame on, and the wind in them.
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/test_program.h"

#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

#include <optional>

using namespace hairpaint::test;

namespace {

/// Mean x of the pixels that hair covers, those that `bald` shows otherwise; in pixels, none where there are few.
std::optional<double> middleOfHair(const QImage& picture, const QImage& bald)
{
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < bald.height(); ++y)
        for (int x = 0; x < bald.width(); ++x)
            if (picture.pixel(x, y) != bald.pixel(x, y)) {
                sum += x;
                ++count;
            }
    return count > 500 ? std::optional(sum / count) : std::nullopt;
}

} // namespace

class TestRenderCommand : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_project;
    QString m_baldProject;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    /// Small pictures, with more options; empty, or what went wrong.
    [[nodiscard]] QString render(const QString& project, const char* output, const char* options) const
    {
        const QStringList more = QString::fromLatin1(options).split(QLatin1Char(' '), Qt::SkipEmptyParts);
        const Outcome outcome =
            runProgram(QStringList{QStringLiteral("render"), project, QStringLiteral("-o"), path(output),
                                   QStringLiteral("--size"), QStringLiteral("96x96")} +
                       more);
        return outcome.code == 0 ? QString() : outcome.error;
    }

    /// Pictures of hair that has just begun to fall.
    [[nodiscard]] QString film(const char* output, const char* options) const
    {
        return render(m_project, output, QByteArray("--settle 0 ").append(options).constData());
    }

    /// Frame `number` of a film written as `film`.png; empty where it was not written.
    [[nodiscard]] QByteArray frame(const char* film, int number) const
    {
        return contentOf(m_folder.filePath(
            QStringLiteral("%1.%2.png").arg(QLatin1StringView(film)).arg(number, 4, 10, QLatin1Char('0'))));
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_project = path("falling.hairpaint");
        m_baldProject = path("bald.hairpaint");
        QImage image(256, 256, QImage::Format_RGB32);
        for (const QString& project : {m_project, m_baldProject}) {
            image.fill(project == m_project ? QColor(225, 255, 225) : QColor(Qt::white));
            QVERIFY(image.save(path("density.png")));
            const Outcome made =
                runProgram({QStringLiteral("new"), QStringLiteral("-o"), project, QStringLiteral("--map"),
                            QStringLiteral("density=") + path("density.png")});
            QCOMPARE(made.error, QString());
            QCOMPARE(made.code, 0);
            QVERIFY(thinOut(project));
        }
    }

    void aFilmsFramesAreTheSameFromWhicheverOneItStarts()
    {
        QCOMPARE(film("whole.png", "--frames 0-3"), QString());
        QCOMPARE(film("part.png", "--frames 2-3"), QString());
        for (const int number : {0, 1})
            QVERIFY(!frame("whole", number).isEmpty() && frame("part", number).isEmpty());
        for (const int number : {2, 3}) {
            QVERIFY(!frame("whole", number).isEmpty() && frame("whole", number) != frame("whole", number - 1));
            QVERIFY2(frame("part", number) == frame("whole", number), qPrintable(QString::number(number)));
        }
    }

    /// A step of the simulation is 1/120 s: at most rates a frame is no whole number of steps.
    void theSameMomentIsTheSamePictureAtEveryRate_data()
    {
        QTest::addColumn<QByteArray>("options");
        QTest::addColumn<int>("number");
        QTest::newRow("24 a second") << QByteArray("--fps 24 --frames 2-2") << 2;
        QTest::newRow("48 a second") << QByteArray("--fps 48 --frames 4-4") << 4;
        QTest::newRow("96 a second") << QByteArray("--fps 96 --frames 8-8") << 8;
        QTest::newRow("240 a second") << QByteArray("--fps 240 --frames 20-20") << 20;
    }

    void theSameMomentIsTheSamePictureAtEveryRate()
    {
        QFETCH(QByteArray, options);
        QFETCH(int, number);
        // 10 steps; in still air a step is the same whenever it is made.
        if (frame("steps", 10).isEmpty())
            QCOMPARE(film("steps.png", "--fps 120 --frames 9-11"), QString());
        QCOMPARE(film("rate.png", options.constData()), QString());
        QVERIFY(!frame("rate", number).isEmpty());
        QVERIFY(frame("steps", 9) != frame("steps", 10) && frame("steps", 10) != frame("steps", 11));
        QVERIFY(frame("rate", number) == frame("steps", 10));
    }

    void aMotionIsTheSameAtEveryRate()
    {
        QCOMPARE(film("shaken.png", "--motion shake --fps 120 --frames 10-10"), QString());
        QCOMPARE(film("shaken-24.png", "--motion shake --fps 24 --frames 2-2"), QString());
        QCOMPARE(film("unshaken.png", "--fps 24 --frames 2-2"), QString());
        QVERIFY(!frame("shaken", 10).isEmpty() && frame("shaken", 10) == frame("shaken-24", 2));
        QVERIFY(frame("shaken", 10) != frame("unshaken", 2));
    }

    /// Seen on a head without hair, which swings on by itself.
    void aMotionIsRepeatedAfterItsEnd_data()
    {
        QTest::addColumn<QByteArray>("motion");
        QTest::addColumn<QByteArray>("fps");
        QTest::newRow("nod") << QByteArray("nod") << QByteArray("5");     // 8 frames
        QTest::newRow("shake") << QByteArray("shake") << QByteArray("5"); // 8 frames
        QTest::newRow("turn") << QByteArray("turn") << QByteArray("2");   // 8 frames
    }

    void aMotionIsRepeatedAfterItsEnd()
    {
        QFETCH(QByteArray, motion);
        QFETCH(QByteArray, fps);
        const QByteArray options = "--settle 0 --frames 0-9 --motion " + motion + " --fps " + fps;
        QCOMPARE(render(m_baldProject, "moved.png", options.constData()), QString());
        QVERIFY(!frame("moved", 0).isEmpty() && frame("moved", 1) != frame("moved", 0));
        QVERIFY(frame("moved", 3) != frame("moved", 1));
        QVERIFY(frame("moved", 8) == frame("moved", 0));
        QVERIFY(frame("moved", 9) == frame("moved", 1));
    }

    void withoutARateAFilmHasThirtyFramesASecond()
    {
        QCOMPARE(film("given.png", "--frames 0-2 --fps 30"), QString());
        QCOMPARE(film("slow.png", "--frames 0-2 --fps 60"), QString());
        QCOMPARE(film("usual.png", "--frames 0-2"), QString());
        QVERIFY(frame("usual", 0) == frame("slow", 0));
        QVERIFY(frame("usual", 1) == frame("slow", 2) && frame("usual", 1) != frame("slow", 1));
        for (const int number : {0, 1, 2})
            QVERIFY(!frame("usual", number).isEmpty() && frame("usual", number) == frame("given", number));
    }

    void theSkinIsTheOneAskedFor()
    {
        const auto faceOf = [&](const char* options) {
            const QString problem = render(m_baldProject, "skin.png", options);
            return problem.isEmpty() ? QImage(path("skin.png")).pixelColor(48, 48).lightness() : -1;
        };
        const int clay = faceOf("--view front --fit head --settle 0");
        const int deep = faceOf("--view front --fit head --settle 0 --skin deep");
        QVERIFY2(clay > 0 && deep > 0 && deep < clay - 60, qPrintable(QStringLiteral("%1 %2").arg(clay).arg(deep)));
        QVERIFY(render(m_baldProject, "skin.png", "--skin green").contains(QStringLiteral("There is no skin 'green'")));
    }

    void theLightIsAPreset()
    {
        const auto colourOf = [this](const char* options) {
            const QString problem = render(m_baldProject, "light.png", options);
            return problem.isEmpty() ? QImage(path("light.png")).pixelColor(48, 48) : QColor();
        };
        const QColor studio = colourOf("--view front --fit head --settle 0 --light studio");
        const QColor sunset = colourOf("--view front --fit head --settle 0 --light sunset");
        QVERIFY(studio.isValid() && sunset.isValid() && studio != sunset);
        QCOMPARE(colourOf("--view front --fit head --settle 0"), studio);
        QVERIFY(
            render(m_baldProject, "light.png", "--light moon").contains(QStringLiteral("There is no light 'moon'")));
    }

    /// +X is the head's own left, which the view from the front shows on the right.
    void theWindBlowsTheHairInItsDirection()
    {
        QCOMPARE(render(m_baldProject, "bald.png", "--view front --fit bust --settle 0"), QString());
        const QImage bald(path("bald.png"));
        const auto middle = [&](const char* wind) {
            const QString problem = render(m_project, "wind.png",
                                           QByteArray("--view front --fit bust --settle 1 ").append(wind).constData());
            return problem.isEmpty() ? middleOfHair(QImage(path("wind.png")), bald) : std::nullopt;
        };
        const auto still = middle("");
        const auto calm = middle("--wind 0,0,0");
        const auto toTheRight = middle("--wind 15,0,0");
        const auto toTheLeft = middle("--wind -15,0,0");
        QVERIFY(still && calm && toTheRight && toTheLeft);
        QCOMPARE(*calm, *still);
        QVERIFY2(*toTheLeft < *still - 3.0 && *still + 3.0 < *toTheRight,
                 qPrintable(QStringLiteral("%1, %2, %3").arg(*toTheLeft).arg(*still).arg(*toTheRight)));
    }

    void unlessAskedForThePedestalIsNotFramed()
    {
        for (const char* fit : {"", "hair", "bust"}) {
            const QByteArray options = *fit == '\0' ? QByteArray() : QByteArray("--fit ").append(fit);
            const QByteArray name = QByteArray("fit-").append(fit).append(".png");
            QCOMPARE(render(m_baldProject, name.constData(), QByteArray("--settle 0 ").append(options).constData()),
                     QString());
        }
        QVERIFY(contentOf(path("fit-.png")) == contentOf(path("fit-hair.png")));
        QVERIFY(contentOf(path("fit-.png")) != contentOf(path("fit-bust.png")));
    }

    void aFractionOfTheHairsIsDrawnAndWritten()
    {
        QVERIFY(render(m_baldProject, "bald.png", "--fit bust --settle 0").isEmpty());
        const QImage bald(path("bald.png"));
        std::vector<int> covered;
        for (const char* hairs : {"", "--hairs 60", "--hairs 6"}) {
            QCOMPARE(render(m_project, "fraction.png", QByteArray("--fit bust --settle 0 ").append(hairs).constData()),
                     QString());
            const QImage picture(path("fraction.png"));
            int pixels = 0;
            for (int y = 0; y < bald.height(); ++y)
                for (int x = 0; x < bald.width(); ++x)
                    pixels += picture.pixel(x, y) != bald.pixel(x, y) ? 1 : 0;
            covered.push_back(pixels);
        }
        QVERIFY2(covered[0] > covered[1] && covered[1] > covered[2] && covered[2] > 0,
                 qPrintable(QStringLiteral("%1, %2 and %3 pixels").arg(covered[0]).arg(covered[1]).arg(covered[2])));

        const QString file = path("fraction.hair");
        QCOMPARE(runProgram({QStringLiteral("export"), m_project, QStringLiteral("-o"), file, QStringLiteral("--hairs"),
                             QStringLiteral("500")})
                     .code,
                 0);
        const auto some = readHair(file);
        QCOMPARE(some.size(), std::size_t{500});
        QCOMPARE(runProgram({QStringLiteral("export"), m_project, QStringLiteral("-o"), file}).code, 0);
        const auto all = readHair(file);
        QVERIFY(all.size() > 1'000);
        // In their order, and each as it is among all.
        auto next = all.begin();
        for (const auto& strand : some) {
            next = std::find(next, all.end(), strand);
            QVERIFY(next != all.end());
        }
    }

    void theWindBlowsThroughExportedHair()
    {
        std::vector<std::vector<std::vector<glm::vec3>>> hair;
        for (const char* wind : {"-20,0,0", "20,0,0"}) {
            const QString file = path("blown.hair");
            QCOMPARE(
                runProgram({QStringLiteral("export"), m_project, QStringLiteral("-o"), file, QStringLiteral("--settle"),
                            QStringLiteral("0.5"), QStringLiteral("--wind"), QString::fromLatin1(wind)})
                    .code,
                0);
            hair.push_back(readHair(file));
        }
        const auto middle = [](const std::vector<std::vector<glm::vec3>>& strands) {
            double sum = 0.0;
            for (const auto& strand : strands)
                sum += static_cast<double>(strand.back().x);
            return sum / static_cast<double>(strands.size());
        };
        QVERIFY(middle(hair[1]) > middle(hair[0]) + 0.01);
    }

    void exportedHairHasSwungAndItsHeadLooksAheadAgain()
    {
        const auto exported = [this](const QStringList& options) {
            const QString file = path("swung.hair");
            const Outcome outcome = runProgram(QStringList{QStringLiteral("export"), m_project, QStringLiteral("-o"),
                                                           file, QStringLiteral("--settle"), QStringLiteral("0.5")} +
                                               options);
            return outcome.code == 0 ? readHair(file) : std::vector<std::vector<glm::vec3>>();
        };
        const auto still = exported({});
        const auto swung = exported({QStringLiteral("--motion"), QStringLiteral("turn")});
        QVERIFY(!still.empty());
        QCOMPARE(swung.size(), still.size());
        bool moved = false;
        for (std::size_t i = 0; i < still.size(); ++i) {
            QVERIFY(glm::distance(swung[i].front(), still[i].front()) < 1e-6F);
            moved = moved || glm::distance(swung[i].back(), still[i].back()) > 1e-3F;
        }
        QVERIFY(moved);
    }
};

HAIRPAINT_TEST(TestRenderCommand, Core)
#include "test_render_command.moc"
