// Hair exported from the command line: every format, one group or all, for a program.
#include "model/document/group_commands.h"
#include "model/files/project_file.h"
#include "model/formats/export_format.h"
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/test_program.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::test;

class TestExportCommand : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_project;
    std::size_t m_hairs = 0;                   ///< That are exported.
    std::vector<std::vector<glm::vec3>> m_all; ///< As exported without options.

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    [[nodiscard]] Outcome exported(const char* name, const QStringList& options = {}) const
    {
        return runProgram(QStringList{QStringLiteral("export"), m_project, QStringLiteral("-o"), path(name)} + options);
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_project = path("two.hairpaint");
        QCOMPARE(runProgram({QStringLiteral("new"), QStringLiteral("-o"), m_project, QStringLiteral("--preset"),
                             QStringLiteral("Two plaits")})
                     .code,
                 0);
        const model::Result<model::Project> project = model::loadProject(m_project);
        QVERIFY(project);
        model::Document document(thinned(*project));
        model::HairGroup other = document.committed().groups.front();
        other.name = QStringLiteral("Other");
        document.push(model::addGroupCommand(document, other));
        QVERIFY(model::saveProject(document.committed(), m_project, {}));
        m_hairs = static_cast<std::size_t>(infoOf(m_project)[QLatin1String("exported")].toInt());
        QVERIFY2(m_hairs > 1000, qPrintable(QString::number(m_hairs)));
        QCOMPARE(exported("all.hair").code, 0);
        m_all = readHair(path("all.hair"));
        QCOMPARE(m_all.size(), m_hairs);
    }

    void everyFormatIsWritten_data()
    {
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<QStringList>("options");
        for (const model::ExportFormat& format : model::exportFormats())
            if (!format.isAvatar) // Avatars need another head.
                QTest::newRow(format.id) << QString::fromLatin1(format.suffix)
                                         << (format.hasCards
                                                 ? QStringList{QStringLiteral("--cards"), QStringLiteral("--triangles"),
                                                               QStringLiteral("2000"), QStringLiteral("--atlas"),
                                                               QStringLiteral("1024")}
                                                 : QStringList{});
    }
    void everyFormatIsWritten()
    {
        QFETCH(QString, suffix);
        QFETCH(QStringList, options);
        const QByteArray name = "format." + suffix.toLatin1();
        const Outcome outcome =
            exported(name.constData(), options + QStringList{QStringLiteral("--target"), QStringLiteral("blender")});
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.code, 0);
        QVERIFY(contentOf(path(name.constData())).size() > 10'000);
    }

    void cardsAreAsManyAndAsLargeAsAsked()
    {
        const Outcome outcome =
            exported("cards.glb", {QStringLiteral("--cards"), QStringLiteral("--triangles"), QStringLiteral("2000"),
                                   QStringLiteral("--atlas"), QStringLiteral("1024")});
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.code, 0);
        const QByteArray glb = contentOf(path("cards.glb"));
        const qsizetype length = qFromLittleEndian<quint32>(glb.constData() + 12);
        const QJsonObject json = QJsonDocument::fromJson(glb.sliced(20, length)).object();
        QCOMPARE(json[QLatin1String("meshes")].toArray().size(), qsizetype{2}); // A group each.
        const QJsonArray accessors = json[QLatin1String("accessors")].toArray();
        qint64 triangles = 0;
        for (const QJsonValue mesh : json[QLatin1String("meshes")].toArray())
            triangles += accessors[mesh[QLatin1String("primitives")][0][QLatin1String("indices")].toInt()]
                             .toObject()[QLatin1String("count")]
                             .toInteger() /
                         3;
        QVERIFY2(triangles > 1800 && triangles <= 2000, qPrintable(QString::number(triangles)));
        for (const char* kind : {"rootToTip", "strandId", "occlusion", "depth", "flow"}) {
            const QImage image(path(("cards-" + QByteArray(kind) + ".png").constData()));
            QCOMPARE(image.size(), QSize(1024, 1024));
        }
    }

    void bonesLetCardsSwing()
    {
        const Outcome outcome =
            exported("bones.glb", {QStringLiteral("--cards"), QStringLiteral("--bones"), QStringLiteral("--triangles"),
                                   QStringLiteral("2000"), QStringLiteral("--atlas"), QStringLiteral("1024")});
        QCOMPARE(outcome.error, QString());
        const QByteArray glb = contentOf(path("bones.glb"));
        const qsizetype length = qFromLittleEndian<quint32>(glb.constData() + 12);
        const QJsonObject json = QJsonDocument::fromJson(glb.sliced(20, length)).object();
        const QJsonObject springBone = json[QLatin1String("extensions")][QLatin1String("VRMC_springBone")].toObject();
        QCOMPARE(springBone[QLatin1String("specVersion")].toString(), QStringLiteral("1.0"));
        const QJsonArray nodes = json[QLatin1String("nodes")].toArray();
        const QJsonArray springs = springBone[QLatin1String("springs")].toArray();
        QVERIFY(springs.size() > 5 && springs.size() < 100);
        for (const QJsonValue spring : springs) {
            const QJsonArray joints = spring[QLatin1String("joints")].toArray();
            QCOMPARE(joints.size(), qsizetype{5});
            // Each is the child of the one before.
            for (qsizetype j = 1; j < joints.size(); ++j)
                QCOMPARE(nodes[joints[j - 1][QLatin1String("node")].toInt()][QLatin1String("children")][0],
                         joints[j][QLatin1String("node")]);
        }
        const model::Result<model::Project> project = model::loadProject(m_project);
        QCOMPARE(static_cast<std::size_t>(springBone[QLatin1String("colliders")].toArray().size()),
                 project->worn.size());
        const QJsonArray joints = json[QLatin1String("skins")][0][QLatin1String("joints")].toArray();
        QCOMPARE(joints.size(), 1 + 5 * springs.size());
    }

    void levelsAndTheHeadLieBesideTheCards_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("held by the scene") << QStringList{};
        QTest::newRow("held by bones") << QStringList{QStringLiteral("--bones")};
    }
    void levelsAndTheHeadLieBesideTheCards()
    {
        QFETCH(QStringList, options);
        const Outcome outcome =
            exported("levels.glb",
                     options + QStringList{QStringLiteral("--cards"), QStringLiteral("--lods"), QStringLiteral("3"),
                                           QStringLiteral("--with-head"), QStringLiteral("--triangles"),
                                           QStringLiteral("4000"), QStringLiteral("--atlas"), QStringLiteral("1024")});
        QCOMPARE(outcome.error, QString());
        const QByteArray glb = contentOf(path("levels.glb"));
        const qsizetype length = qFromLittleEndian<quint32>(glb.constData() + 12);
        const QJsonObject json = QJsonDocument::fromJson(glb.sliced(20, length)).object();
        const QJsonArray nodes = json[QLatin1String("nodes")].toArray();
        const QJsonArray shown = json[QLatin1String("scenes")][0][QLatin1String("nodes")].toArray();
        const auto trianglesOf = [&json](const QJsonValue& node) {
            const QJsonValue mesh = json[QLatin1String("meshes")][node[QLatin1String("mesh")].toInt()];
            const int indices = mesh[QLatin1String("primitives")][0][QLatin1String("indices")].toInt();
            return json[QLatin1String("accessors")][indices][QLatin1String("count")].toInt() / 3;
        };
        int cards = 0;
        for (const QJsonValue number : shown) {
            const QJsonValue node = nodes[number.toInt()];
            const QJsonArray coarser =
                node[QLatin1String("extensions")][QLatin1String("MSFT_lod")][QLatin1String("ids")].toArray();
            QVERIFY(!node[QLatin1String("mesh")].isDouble() ||
                    node[QLatin1String("skin")].isDouble() == !options.isEmpty());
            if (coarser.isEmpty())
                continue;
            ++cards;
            QCOMPARE(coarser.size(), qsizetype{2});
            QVERIFY(node[QLatin1String("name")].toString().endsWith(QLatin1String("_LOD0")));
            QVERIFY(!shown.contains(coarser[0]) && !shown.contains(coarser[1]));
            QCOMPARE(nodes[coarser[1].toInt()][QLatin1String("name")].toString().right(5), QStringLiteral("_LOD2"));
            QVERIFY(trianglesOf(nodes[coarser[0].toInt()]) < trianglesOf(node) * 6 / 10);
            QVERIFY(trianglesOf(nodes[coarser[1].toInt()]) < trianglesOf(node) * 4 / 10);
        }
        QCOMPARE(cards, 2); // A group each.
        const model::Result<model::Project> project = model::loadProject(m_project);
        const auto head = std::ranges::find_if(nodes, [](const QJsonValue& node) {
            return node[QLatin1String("name")].toString() == QLatin1String("Head mesh");
        });
        QVERIFY(head != nodes.end());
        QCOMPARE(static_cast<std::size_t>(trianglesOf(*head)), project->head->skin->mesh().triangles.size());
    }

    void cardsThatMakeNoSenseAreWrongUsage_data()
    {
        QTest::addColumn<QString>("options");
        QTest::addColumn<QString>("named");
        const auto row = [](const char* options, const char* named) {
            QTest::newRow(options) << QString::fromLatin1(options) << QString::fromLatin1(named);
        };
        row("-o a.glb --triangles 5000", "--cards");
        row("-o a.glb --atlas 2048", "--cards");
        row("-o a.glb --bones", "--cards");
        row("-o a.glb --lods 2", "--cards");
        row("-o a.glb --with-head", "--cards");
        row("-o a.hair --cards", ".glb");
        row("-o a.glb --cards --frames 1-2", "--frames");
        row("-o a.glb --cards --triangles 999", "1000 to 60000");
        row("-o a.glb --cards --triangles 60001", "1000 to 60000");
        row("-o a.glb --cards --triangles many", "many");
        row("-o a.glb --cards --atlas 2000", "1024, 2048, 4096");
        row("-o a.glb --cards --lods 4", "1 to 3");
        row("-o a.glb --cards --lods few", "few");
        row("--cards --maps .", "-o");
        row("-o a.hair --bones", ".glb with --cards");
    }
    void cardsThatMakeNoSenseAreWrongUsage()
    {
        QFETCH(QString, options);
        QFETCH(QString, named);
        const Outcome outcome =
            runProgram(QStringList{QStringLiteral("export"), m_project} + options.split(QLatin1Char(' ')));
        QCOMPARE(outcome.code, 2);
        QVERIFY2(outcome.error.contains(named), qPrintable(outcome.error));
    }

    void cardsThatCantAllBeWrittenLeaveNothing()
    {
        QVERIFY(QDir().mkpath(path("half-flow.png")));
        QCOMPARE(faultOf(m_folder.path(),
                         {QStringLiteral("export"), m_project, QStringLiteral("-o"), path("half.glb"),
                          QStringLiteral("--cards")},
                         QStringLiteral("half-flow.png")),
                 QString());
    }

    void oneGroupIsPartOfAll()
    {
        QCOMPARE(exported("one.hair", {QStringLiteral("--group"), QStringLiteral("Other")}).code, 0);
        QCOMPARE(exported("few.hair", {QStringLiteral("--hairs"), QStringLiteral("500")}).code, 0);
        const auto one = readHair(path("one.hair"));
        QVERIFY(one.size() > 1000 && one.size() < m_all.size());
        QVERIFY(std::equal(one.begin(), one.end(), m_all.end() - static_cast<std::ptrdiff_t>(one.size())));
        QCOMPARE(readHair(path("few.hair")).size(), std::size_t{500});
    }

    void toleranceMakesFilesSmaller()
    {
        QCOMPARE(exported("less.hair", {QStringLiteral("--tolerance"), QStringLiteral("1")}).code, 0);
        // The wisps of a plait swing by some 4 mm to each side, and every swing less than that may go.
        QCOMPARE(exported("least.hair", {QStringLiteral("--tolerance"), QStringLiteral("4")}).code, 0);
        QCOMPARE(readHair(path("less.hair")).size(), m_hairs);
        QCOMPARE(readHair(path("least.hair")).size(), m_hairs);
        const auto bytes = [this](const char* name) { return QFileInfo(path(name)).size(); };
        QVERIFY(bytes("less.hair") * 5 < bytes("all.hair") * 4);
        QVERIFY(bytes("least.hair") * 5 < bytes("all.hair") * 2);
    }

    void aProgramGetsItsUnitAndAxis()
    {
        QCOMPARE(exported("unreal.hair", {QStringLiteral("--target"), QStringLiteral("unreal")}).code, 0);
        const auto other = readHair(path("unreal.hair"));
        QCOMPARE(other.size(), m_all.size());
        for (std::size_t i = 0; i < m_all.size(); i += 100) {
            const glm::vec3 tip = m_all[i].back();
            QCOMPARE(other[i].back(), 100.0F * glm::vec3(tip.x, -tip.z, tip.y));
        }
        QVERIFY(contentOf(path("unreal.hair")).left(128).contains("centimetres, z up"));
    }

    void aFilmIsAFileAFrame()
    {
        const QStringList film{QStringLiteral("--frames"), QStringLiteral("2-4"),     QStringLiteral("--motion"),
                               QStringLiteral("turn"),     QStringLiteral("--hairs"), QStringLiteral("200")};
        const Outcome outcome = exported("film.hair", film);
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.code, 0);
        QCOMPARE(QDir(m_folder.path()).entryList({QStringLiteral("film*")}, QDir::Files),
                 (QStringList{QStringLiteral("film.0002.hair"), QStringLiteral("film.0003.hair"),
                              QStringLiteral("film.0004.hair")}));
        const auto first = readHair(path("film.0002.hair"));
        const auto last = readHair(path("film.0004.hair"));
        QCOMPARE(first.size(), std::size_t{200});
        QCOMPARE(last.size(), first.size());
        float moved = 0.0F;
        for (std::size_t i = 0; i < first.size(); ++i) {
            QCOMPARE(last[i].size(), first[i].size());
            moved = std::max(moved, glm::distance(first[i].back(), last[i].back()));
        }
        QVERIFY(moved > 1e-4F && moved < 0.5F);
    }

    void aFilmThatCantBeWrittenLeavesNothing()
    {
        QVERIFY(QDir().mkpath(path("blocked.0003.obj")));
        QCOMPARE(faultOf(m_folder.path(),
                         {QStringLiteral("export"), m_project, QStringLiteral("-o"), path("blocked.obj"),
                          QStringLiteral("--frames"), QStringLiteral("2-4")},
                         QStringLiteral("blocked.0003.obj")),
                 QString());
    }

    void everyMapGoesIntoAFolder()
    {
        const QString project = path("small.hairpaint"); // Whose maps are quickly written.
        model::Project two = smallProject();
        two.groups.push_back(model::makeGroup(two, QStringLiteral("Fringe"), 256));
        QVERIFY(model::saveProject(two, project, {}));
        const Outcome outcome = runProgram({QStringLiteral("export"), project, QStringLiteral("--maps"), path("maps"),
                                            QStringLiteral("--grey"), QStringLiteral("--uv-sheet"), path("sheet.svg")});
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.code, 0);
        QVERIFY(contentOf(path("sheet.svg")).startsWith("<svg"));
        const QStringList names = QDir(path("maps")).entryList(QDir::Files | QDir::Hidden);
        QCOMPARE(names.size(), 2 * static_cast<qsizetype>(model::mapSpecs().size()));
        // The density comes back as it was.
        QCOMPARE(runProgram({QStringLiteral("new"), QStringLiteral("-o"), path("back.hairpaint"),
                             QStringLiteral("--map"), QStringLiteral("density:grey=") + path("maps/Scalp-density.png")})
                     .code,
                 0);
        const auto density = [](const QString& file) {
            const model::Result<model::Project> project = model::loadProject(file);
            return model::Document(*project).resolvedNow(project->groups.front().id, model::MapKind::Density);
        };
        const auto before = density(project);
        const auto after = density(path("back.hairpaint"));
        QCOMPARE(after->size(), before->size());
        for (int x = 0; x < before->size(); x += 3)
            QCOMPARE(after->texel(x, before->size() / 2)[0], before->texel(x, before->size() / 2)[0]);
    }

    void aFolderThatCannotBeMadeIsToldOf()
    {
        QFile inTheWay(path("file"));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        QCOMPARE(faultOf(m_folder.path(),
                         {QStringLiteral("export"), m_project, QStringLiteral("--maps"), path("file/nowhere")},
                         QStringLiteral("nowhere")),
                 QString());
    }

    void aGroupThatIsNotThereIsToldOf()
    {
        QCOMPARE(faultOf(m_folder.path(),
                         {QStringLiteral("export"), m_project, QStringLiteral("-o"), path("none.hair"),
                          QStringLiteral("--group"), QStringLiteral("Moustache")},
                         QStringLiteral("Moustache")),
                 QString());
    }
};

HAIRPAINT_TEST(TestExportCommand, Core)
#include "test_export_command.moc"
