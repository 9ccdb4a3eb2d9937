// `hairpaint new`: what its options change in the project, and what `info` tells of it.
#include "model/files/preset_file.h"
#include "model/files/project_file.h"
#include "tests/app/project_folder.h"
#include "tests/app/thin_project.h"
#include "tests/model/archive_maker.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QJsonArray>
#include <QtTest>

#include <cmath>
#include <utility>

using namespace hairpaint;
using namespace hairpaint::test;

class TestNewCommand : public QObject
{
    Q_OBJECT
private:
    ProjectFolder m_folder;

    /// Makes the project; empty, or what went wrong.
    [[nodiscard]] static QString make(const QString& project, const QStringList& options)
    {
        const Outcome outcome = runProgram(QStringList{QStringLiteral("new"), QStringLiteral("-o"), project} + options);
        return outcome.code == 0 ? outcome.error : outcome.error + QStringLiteral(" failed");
    }

    [[nodiscard]] QByteArray restHairOf(const QString& project) const
    {
        const QString file = m_folder.path("rest.hair");
        const Outcome outcome = runProgram({QStringLiteral("export"), project, QStringLiteral("-o"), file});
        return outcome.code == 0 ? contentOf(file) : QByteArray();
    }

    [[nodiscard]] static qint64 hairsOf(const QJsonObject& infoOrGroup)
    {
        return infoOrGroup.value(QLatin1String("hairs")).toInteger(-1);
    }

private Q_SLOTS:
    void aSeedGivesItsOwnRootsEveryTime()
    {
        const QString thin = QStringLiteral("density=") + m_folder.filled("thin.png", QColor(225, 255, 225));
        QList<QByteArray> hairs;
        for (const char* seed : {"", "1", "7", "7", "9007199254740992"}) {
            const QString project = m_folder.path("seeded.hairpaint");
            QStringList options{QStringLiteral("--map"), thin, QStringLiteral("--max-candidates"),
                                QStringLiteral("4000")};
            if (*seed != '\0')
                options << QStringLiteral("--seed") << QString::fromLatin1(seed);
            QCOMPARE(make(project, options), QString());
            QCOMPARE(infoOf(project).value(QLatin1String("seed")).toInteger(),
                     *seed == '\0' ? 1 : QByteArray(seed).toLongLong());
            hairs.append(restHairOf(project));
            QVERIFY(hairs.back().size() > 20'000);
        }
        QVERIFY(hairs[0] == hairs[1]);
        QVERIFY(hairs[2] == hairs[3]);
        QVERIFY(hairs[1] != hairs[2] && hairs[2] != hairs[4]);
    }

    void theLimitOnCandidatesThinsHairsEvenly()
    {
        const QString density = QStringLiteral("density=") + m_folder.filled("half.png", QColor(127, 255, 127));
        const auto hairs = [&](const char* limit, const char* option = "--max-candidates") {
            const QString project = m_folder.path("limited.hairpaint");
            QStringList options{QStringLiteral("--map"), density, QString::fromLatin1(option),
                                QString::fromLatin1(limit)};
            return make(project, options).isEmpty() ? hairsOf(infoOf(project)) : -1;
        };
        // Candidates lie on the whole head, and half of them are hairs.
        QCOMPARE(hairs("20000"), 10'039);
        QCOMPARE(hairs("1000"), 502);
        QCOMPARE(hairs("1000", "--max-hairs"), 502); // Its name in 0.1.
        QCOMPARE(hairs("1"), 1);
        const qint64 all = hairs("1000000");
        QVERIFY2(all > 50'000 && all == hairs("4000000"), qPrintable(QString::number(all)));
    }

    void aLimitThatBitesIsTold_data()
    {
        QTest::addColumn<int>("maxHairs");
        QTest::addColumn<int>("nodes");
        QTest::addColumn<QJsonValue>("limitedBy");
        QTest::addColumn<QString>("words");
        QTest::newRow("none") << 1'000'000 << 8 << QJsonValue() << QString();
        QTest::newRow("the project's") << 1'000 << 8 << QJsonValue(QLatin1String("max_candidates"))
                                       << QStringLiteral("Fewer hairs than painted: the limit of 1,000 ");
        QTest::newRow("memory") << 4'000'000 << 32 << QJsonValue(QLatin1String("memory"))
                                << QStringLiteral("Fewer hairs than painted: memory ");
    }

    void aLimitThatBitesIsTold()
    {
        QFETCH(int, maxHairs);
        QFETCH(int, nodes);
        QFETCH(QJsonValue, limitedBy);
        QFETCH(QString, words);
        model::Project project = model::newProject();
        project.maxHairs = maxHairs;
        sim::GroupSettings& settings = project.groups.front().settings;
        settings.nodesPerHair = nodes;
        settings.greatestDensityPerM2 = nodes == 32 ? 4e6F : 1.5e6F;
        QVERIFY(model::saveProject(project, m_folder.path("told.hairpaint"), {}));

        const QJsonObject info = infoOf(m_folder.path("told.hairpaint"));
        QCOMPARE(info.value(QLatin1String("max_candidates")).toInt(), maxHairs);
        QCOMPARE(info.value(QLatin1String("max_hairs")).toInt(), maxHairs);
        const QJsonObject group = info.value(QLatin1String("groups")).toArray().first().toObject();
        QVERIFY(group.contains(QLatin1String("limited_by")));
        QCOMPARE(group.value(QLatin1String("limited_by")), limitedBy);
        const Outcome text = runProgram({QStringLiteral("info"), m_folder.path("told.hairpaint")}, {}, "en_GB");
        QCOMPARE(text.output.contains(QStringLiteral("Fewer hairs")), !words.isEmpty());
        QVERIFY2(text.output.contains(words), qPrintable(text.output));
    }

    void brightnessIsTheValueWhereAnImageIsGreyOrItIsAskedFor()
    {
        const QString full = m_folder.filled("full.png", Qt::green);
        const QString grey = m_folder.filled("grey.png", QColor(64, 64, 64));
        const auto hairs = [&](const QString& map) {
            const QString project = m_folder.path("grey.hairpaint");
            const QStringList options{QStringLiteral("--map"), map, QStringLiteral("--max-candidates"),
                                      QStringLiteral("20000")};
            return make(project, options).isEmpty() ? hairsOf(infoOf(project)) : -1;
        };
        const auto all = static_cast<double>(hairs(QStringLiteral("density=") + full));
        QVERIFY(all > 15'000);
        for (const char* kind : {"density=", "density:grey="}) {
            const auto some = static_cast<double>(hairs(QString::fromLatin1(kind) + grey));
            QVERIFY2(std::abs(some / all - 64.0 / 255.0) < 0.005, qPrintable(QString::number(some / all)));
        }
        const auto bright = static_cast<double>(hairs(QStringLiteral("density:grey=") + full));
        QVERIFY2(bright < 0.9 * all, qPrintable(QString::number(bright / all)));
    }

    void aMapGoesToTheGroupThatItNames()
    {
        model::Project two = model::newProject();
        two.groups.push_back(model::makeGroup(two, QStringLiteral("Beard/left"), 256));
        QVERIFY(
            model::savePreset(model::presetFrom(thinned(two), QStringLiteral("Two")), m_folder.path("two.hairpreset")));

        const QString full = QStringLiteral("density=") + m_folder.filled("full.png", Qt::green);
        const auto hairs = [&](const QString& map) {
            const QString project = m_folder.path("groups.hairpaint");
            std::pair<qint64, qint64> found(-1, -1);
            if (!make(project,
                      {QStringLiteral("--preset"), m_folder.path("two.hairpreset"), QStringLiteral("--map"), map})
                     .isEmpty())
                return found;
            const QJsonArray groups = infoOf(project).value(QLatin1String("groups")).toArray();
            return groups.size() == 2 ? std::pair(hairsOf(groups[0].toObject()), hairsOf(groups[1].toObject())) : found;
        };
        for (const QString& first : {full, QStringLiteral("Scalp/") + full}) {
            const auto [scalp, beard] = hairs(first);
            QVERIFY(scalp > 5'000);
            QCOMPARE(beard, 0);
        }
        const auto [scalp, beard] = hairs(QStringLiteral("Beard/left/") + full);
        QCOMPARE(scalp, 0);
        QVERIFY(beard > 5'000);
    }

    void aMapForAGroupThatIsNotThereFails()
    {
        const Outcome outcome = runProgram({QStringLiteral("new"), QStringLiteral("-o"),
                                            m_folder.path("none.hairpaint"), QStringLiteral("--map"),
                                            QStringLiteral("Beard/density=") + m_folder.filled("bald.png", Qt::white)});
        QCOMPARE(outcome.code, 1);
        QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
        QVERIFY2(outcome.error.contains(QStringLiteral("'Beard'")), qPrintable(outcome.error));
        QVERIFY(!QFile::exists(m_folder.path("none.hairpaint")));
    }

    void aFolderOfImagesGoesToTheMapsThatTheirNamesTell()
    {
        const QDir folder(m_folder.path("maps"));
        QVERIFY(folder.mkpath(QStringLiteral(".")));
        const QString bald = m_folder.filled("bald.png", Qt::white);
        QVERIFY(!m_folder.filled("maps/head_density.0001.png", Qt::green).isEmpty());
        QVERIFY(!m_folder.filled("maps/Scalp-length.png", QColor(128, 128, 128)).isEmpty());
        QVERIFY(!m_folder.filled("maps/holiday.png", Qt::red).isEmpty()); // It names no map, so it is left out.
        const QString project = m_folder.path("of_folder.hairpaint");
        QCOMPARE(make(project, {QStringLiteral("--maps"), folder.path()}), QString());
        const auto layersOf = [&project](model::MapKind kind) {
            QStringList names;
            const model::Result<model::Project> read = model::loadProject(project);
            for (const model::Layer& layer : read ? read->groups.front().map(kind).layers : std::vector<model::Layer>())
                names += layer.name;
            return names;
        };
        QCOMPARE(layersOf(model::MapKind::Density), QStringList{QStringLiteral("head_density")});
        QCOMPARE(layersOf(model::MapKind::Length), QStringList{QStringLiteral("Scalp-length")});
        QVERIFY(!layersOf(model::MapKind::Colour).contains(QStringLiteral("holiday")));
        QVERIFY(hairsOf(infoOf(project)) > 50'000);
        // One that is named by itself counts more.
        QCOMPARE(make(project, {QStringLiteral("--map"), QStringLiteral("density=") + bald, QStringLiteral("--maps"),
                                folder.path()}),
                 QString());
        QCOMPARE(layersOf(model::MapKind::Density), QStringList{QStringLiteral("bald")});
        QCOMPARE(layersOf(model::MapKind::Length), QStringList{QStringLiteral("Scalp-length")});
        QCOMPARE(hairsOf(infoOf(project)), 0);
    }

    void imagesOfUvTilesComeBackAsTheyWentOut()
    {
        // A ball whose layout goes on in the tile at the right.
        const sim::HeadMesh ball = makeBallHead(24, 0.12F);
        QByteArray obj;
        for (const glm::vec3& p : ball.positionsHd)
            obj += QStringLiteral("v %1 %2 %3\n").arg(p.x).arg(p.y).arg(p.z).toLatin1();
        for (const glm::vec2& uv : ball.uvs)
            obj += QStringLiteral("vt %1 %2\n").arg(2.0F * uv.x).arg(uv.y).toLatin1();
        for (const glm::uvec3& t : ball.triangles)
            obj += QStringLiteral("f %1/%1 %2/%2 %3/%3\n").arg(t.x + 1).arg(t.y + 1).arg(t.z + 1).toLatin1();
        writeBytes(m_folder.path("udim.obj"), obj);
        const QStringList head{QStringLiteral("--head"), m_folder.path("udim.obj")};
        const QDir folder(m_folder.path("udim"));
        const QDir again(m_folder.path("udim2"));
        QVERIFY(folder.mkpath(QStringLiteral(".")));
        QVERIFY(!m_folder.filled("udim/head_density.1001.png", QColor(200, 255, 200)).isEmpty());
        QVERIFY(!m_folder.filled("udim/head_density.1002.png", Qt::green).isEmpty());
        QVERIFY(!m_folder.filled("udim/head_density.1005.png", Qt::red).isEmpty());
        const QString project = m_folder.path("udim.hairpaint");
        const Outcome made = runProgram(QStringList{QStringLiteral("new"), QStringLiteral("-o"), project} + head +
                                        QStringList{QStringLiteral("--maps"), folder.path()});
        QVERIFY2(made.code == 0 && made.output.contains(QStringLiteral("1005")), qPrintable(made.output + made.error));
        const Outcome out = runProgram(
            {QStringLiteral("export"), project, QStringLiteral("--maps"), again.path(), QStringLiteral("--udim")});
        QVERIFY2(out.code == 0, qPrintable(out.error));
        for (const char* number : {"1001", "1002"}) {
            const QImage before(folder.filePath(QStringLiteral("head_density.%1.png").arg(QLatin1StringView(number))));
            const QImage after(again.filePath(QStringLiteral("Scalp-density.%1.png").arg(QLatin1StringView(number))));
            QCOMPARE(after.size(), QSize(256, 256));
            QCOMPARE(after.pixel(0, 0), before.pixel(0, 0));
            QCOMPARE(after.pixel(255, 255), before.pixel(255, 255));
        }
        // By one map, and a pattern that no file has.
        const QString pattern = QStringLiteral("density=") + again.filePath(QStringLiteral("Scalp-density.<UDIM>.png"));
        QCOMPARE(make(m_folder.path("one.hairpaint"), head + QStringList{QStringLiteral("--map"), pattern}), QString());
        const model::Result<model::Project> first = model::loadProject(project);
        const model::Result<model::Project> second = model::loadProject(m_folder.path("one.hairpaint"));
        QVERIFY(first && second);
        const auto rasterOf = [](const model::Project& of) {
            return of.groups.front().map(model::MapKind::Density).layers.front().raster;
        };
        QVERIFY(rasterOf(*first) == rasterOf(*second));
        const Outcome none =
            runProgram(QStringList{QStringLiteral("new"), QStringLiteral("-o"), project} + head +
                       QStringList{QStringLiteral("--map"), QStringLiteral("density=none.<UDIM>.png")});
        QCOMPARE(none.code, 1);
        QVERIFY2(none.error.contains(QStringLiteral("none.1001.png")), qPrintable(none.error));
    }

    void aFolderWithoutImagesOfMapsFails()
    {
        const QDir folder(m_folder.path("holidays"));
        QVERIFY(folder.mkpath(QStringLiteral(".")));
        QVERIFY(!m_folder.filled("holidays/beach.png", Qt::yellow).isEmpty());
        const QString project = m_folder.path("of_holidays.hairpaint");
        const Outcome outcome =
            runProgram({QStringLiteral("new"), QStringLiteral("-o"), project, QStringLiteral("--maps"), folder.path()});
        QCOMPARE(outcome.code, 1);
        QCOMPARE(outcome.error.count(QLatin1Char('\n')), 1);
        QVERIFY2(outcome.error.contains(QStringLiteral("holidays")), qPrintable(outcome.error));
        QVERIFY(!QFile::exists(project));
    }
};

HAIRPAINT_TEST(TestNewCommand, Core)
#include "test_new_command.moc"
