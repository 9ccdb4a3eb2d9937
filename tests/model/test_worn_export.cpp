// What is worn leaves with the hair.
#include "model/cards/worn_springs.h"
#include "model/formats/export_format.h"
#include "tests/model/archive_maker.h"
#include "tests/model/exported_hair.h"
#include "tests/support/glb_json.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

Worn onTopOfAll(WornKind kind, Id id)
{
    sim::SurfacePoint point;
    point.positionHd = {0.0F, 0.1F, 0.0F};
    Worn worn = makeWorn(wornSpec(kind), point);
    worn.id = id;
    worn.shape.rotation = glm::quat(0.5F, 0.5F, -0.5F, 0.5F);
    return worn;
}

std::vector<Worn> oneOfEachKind()
{
    std::vector<Worn> all;
    all.reserve(wornSpecs().size());
    for (const WornSpec& spec : wornSpecs())
        all.push_back(onTopOfAll(spec.kind, static_cast<Id>(all.size() + 1)));
    return all;
}

} // namespace

class TestWornExport : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatIsDrawnGoesOutWithTheCards_data()
    {
        QTest::addColumn<bool>("withHead");
        QTest::newRow("with the head") << true;
        QTest::newRow("hair alone") << false;
    }
    void whatIsDrawnGoesOutWithTheCards()
    {
        QFETCH(bool, withHead);
        const std::vector<Worn> all = oneOfEachKind();
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("hair.glb"));
        const auto frame = test::frameOf({test::hairGroup(1, 20'000, 65535, 0)});
        const Result<void> written =
            exportHair(frame,
                       {.format = &cardFormat(),
                        .target = findExportTarget(QLatin1StringView("any")),
                        .curves = test::allOf(*frame),
                        .cards = {.triangles = 1000, .atlasPx = test::kTinyAtlasPx, .withHead = withHead},
                        .worn = all},
                       path);
        QVERIFY2(written, written ? "" : qPrintable(written.error().message));
        const QJsonObject json = test::jsonOf(test::readBytes(path));
        const QJsonArray meshes = json[QLatin1String("meshes")].toArray();
        for (const Worn& worn : all) {
            const WornSpec& spec = wornSpec(worn.kind);
            const QString name = QStringLiteral("Worn %1 %2").arg(QLatin1StringView(spec.id)).arg(worn.id);
            const auto mesh = std::ranges::find_if(
                meshes, [&name](const QJsonValue& one) { return one[QLatin1String("name")].toString() == name; });
            QCOMPARE(mesh != meshes.end(), spec.drawn());
            if (mesh == meshes.end())
                continue;
            const QJsonValue attributes = (*mesh)[QLatin1String("primitives")][0][QLatin1String("attributes")];
            const QJsonValue positions =
                json[QLatin1String("accessors")][attributes[QLatin1String("POSITION")].toInt()];
            for (int axis = 0; axis < 3; ++axis) {
                const auto centre = static_cast<double>(worn.shape.centreHd[axis]);
                const auto radius = static_cast<double>(worn.shape.semiAxesM.x * spec.reach);
                const double below = centre - positions[QLatin1String("min")][axis].toDouble();
                const double above = positions[QLatin1String("max")][axis].toDouble() - centre;
                if (worn.kind == WornKind::Ball)
                    QVERIFY(std::abs(below - radius) < 1e-4 && std::abs(above - radius) < 1e-4);
                QVERIFY(below < 1.2 * radius && above < 1.2 * radius);
            }
        }
    }

    /// Neither file is replaced where one cannot be; hair alone needs no materials.
    void onlyItsTailsFollowTheSpringsOfABow_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("make");
        QTest::newRow("a bow") << static_cast<int>(WornKind::Bow) << 0;
        QTest::newRow("the bow of a ribbon") << static_cast<int>(WornKind::Ponytail) << 1;
    }
    void onlyItsTailsFollowTheSpringsOfABow()
    {
        QFETCH(int, kind);
        QFETCH(int, make);
        Worn bow = onTopOfAll(static_cast<WornKind>(kind), 1);
        bow.make = static_cast<std::uint8_t>(make);
        const auto frame = test::frameOf({test::hairGroup(1, 20'000, 65535, 0)});
        const std::optional<CurveSet> curves = CurveSet::of(frame, test::allOf(*frame));
        QVERIFY(curves.has_value());
        const WornBody body = wornBodies(*curves, std::span(&bow, 1)).front();
        const std::vector<SpringChain> springs = springsOf(body);
        QCOMPARE(springs.size(), std::size_t{2});
        const std::vector<BoneWeights> weights = springWeights(body, springs, 11);
        QCOMPARE(weights.size(), body.mesh.vertices.size());
        std::size_t swinging = 0;
        for (const BoneWeights& one : weights) {
            QVERIFY(std::abs(one.weights.x + one.weights.y - 1.0F) < 1e-5F);
            QVERIFY(one.joints[0] == 0 || (one.joints[0] >= 11 && one.joints[0] < 19));
            swinging += one.joints[0] != 0 ? 1 : 0;
        }
        QVERIFY(swinging > weights.size() / 8 && swinging < weights.size() / 2);
        // Each tail's own end follows its own last but one joint.
        for (std::size_t i = 0; i < springs.size(); ++i) {
            const HangingPart& part = body.hanging[i];
            const BoneWeights& end = weights[part.first + part.sections * part.corners - 1];
            QCOMPARE(static_cast<std::size_t>(end.joints[0]), 11 + 4 * i + (end.weights.y > 0.0F ? 1 : 2));
        }
        bow.make = 0;
        bow.kind = WornKind::Hairpin;
        QVERIFY(springsOf(wornBodies(*curves, std::span(&bow, 1)).front()).empty());
    }

    void materialsLieBesideALineFileOrNothingDoes()
    {
        QTemporaryDir folder;
        const auto frame = test::frameOf({test::hairGroup(1, 20'000, 65535, 0)});
        const QString path = folder.filePath(QStringLiteral("hair.obj"));
        const auto write = [&](const std::vector<Worn>& worn) {
            return exportHair(frame,
                              {.format = findExportFormat(path),
                               .target = findExportTarget(QLatin1StringView("any")),
                               .curves = test::allOf(*frame),
                               .worn = worn},
                              path);
        };
        QVERIFY(write({}));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
        const QByteArray alone = test::readBytes(path);
        QVERIFY(!alone.contains("mtllib"));
        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("hair.mtl")));
        const Result<void> refused = write({onTopOfAll(WornKind::Ball, 7)});
        QVERIFY(!refused && refused.error().message.contains(QStringLiteral("hair.mtl")));
        QCOMPARE(test::readBytes(path), alone);
        QVERIFY(QDir(folder.path()).rmdir(QStringLiteral("hair.mtl")));
        QVERIFY(write({onTopOfAll(WornKind::Ball, 7)}));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
    }

    void whatIsDrawnGoesOutWithTheHair()
    {
        const Worn ball = onTopOfAll(WornKind::Ball, 7);
        const std::size_t faces = wornSurfaces(ball, nullptr).front().mesh->triangles.size();
        QTemporaryDir folder;
        const auto frame = test::frameOf({test::hairGroup(1, 20'000, 65535, 0)});
        const auto write = [&](const QString& name) {
            const QString path = folder.filePath(name);
            const auto written = exportHair(frame,
                                            {.format = findExportFormat(path),
                                             .target = findExportTarget(QLatin1StringView("any")),
                                             .curves = test::allOf(*frame),
                                             .worn = {ball}},
                                            path);
            return written ? QString::fromUtf8(test::readBytes(path)) : QString();
        };

        const QString name = QStringLiteral("Worn_ball_%1").arg(ball.id);
        const QString obj = write(QStringLiteral("hair.obj"));
        const QString object = obj.mid(obj.indexOf(QStringLiteral("\no %1\n").arg(name)) + 1);
        QVERIFY(object.startsWith(QStringLiteral("o %1\nusemtl %1\n").arg(name)));
        QVERIFY(obj.contains(QLatin1String("\nmtllib hair.mtl\n")));
        const QString materials = QString::fromUtf8(test::readBytes(folder.filePath(QStringLiteral("hair.mtl"))));
        const QString diffuse = QStringLiteral("newmtl %1\nKd ").arg(name);
        const QStringList channels =
            materials.mid(materials.indexOf(diffuse) + diffuse.size()).section(QLatin1Char('\n'), 0, 0).split(u' ');
        QCOMPARE(channels.size(), 3);
        QCOMPARE(qRgb(qRound(255.0 * channels[0].toDouble()), qRound(255.0 * channels[1].toDouble()),
                      qRound(255.0 * channels[2].toDouble())),
                 ball.colour);
        QCOMPARE(object.count(QLatin1String("\nf ")), static_cast<qsizetype>(faces));
        // The last face names the last vertices, counted through all objects, and the last uv and normals, which are
        // its own alone.
        const qsizetype vertices = obj.count(QLatin1String("\nv "));
        const qsizetype own = object.count(QLatin1String("\nvn "));
        QCOMPARE(own, static_cast<qsizetype>(wornSurfaces(ball, nullptr).front().mesh->positionsHd.size()));
        QVERIFY(object.contains(QStringLiteral(" %1/%2/%2").arg(vertices).arg(own)));
        QVERIFY(!object.contains(QStringLiteral(" %1/").arg(vertices + 1)));
        for (const QString& line : object.split(QLatin1Char('\n'))) {
            const QStringList words = line.split(QLatin1Char(' '));
            if (words.front() != QLatin1String("v"))
                continue;
            const glm::vec3 point(words[1].toFloat(), words[2].toFloat(), words[3].toFloat());
            QVERIFY(std::abs(glm::distance(point, ball.shape.centreHd) - ball.shape.semiAxesM.x) < 1e-4F);
            QCOMPARE(qRound(255.0 * words[4].toDouble()), qRed(ball.colour));
        }

        const QString usd = write(QStringLiteral("hair.usda"));
        const QString prim = usd.mid(usd.indexOf(QStringLiteral("def Mesh \"%1\"").arg(name)));
        QVERIFY(prim.startsWith(QLatin1String("def Mesh")));
        const auto list = [&prim](const char* of) {
            const qsizetype at = prim.indexOf(QLatin1StringView(of)) + static_cast<qsizetype>(qstrlen(of));
            return prim.mid(at, prim.indexOf(QLatin1Char(']'), at) - at);
        };
        QCOMPARE(list("faceVertexCounts = [").count(QLatin1Char('3')), static_cast<qsizetype>(faces));
        QCOMPARE(list("faceVertexIndices = [").count(QLatin1Char(',')) + 1, static_cast<qsizetype>(3 * faces));
        QCOMPARE(list("points = [").count(QLatin1Char('(')), own);
        QVERIFY(prim.contains(QStringLiteral("rel material:binding = </Hair/%1/Material>").arg(name)));
        QVERIFY(prim.contains(QLatin1String("info:id = \"UsdPreviewSurface\"")));
        QCOMPARE(usd.count(QLatin1Char('{')), usd.count(QLatin1Char('}')));

        QVERIFY(!write(QStringLiteral("hair.glb")).isEmpty()); // Ribbons.
        const QByteArray glb = test::readBytes(folder.filePath(QStringLiteral("hair.glb")));
        const QJsonObject json = test::jsonOf(glb);
        const QJsonValue mesh = json[QLatin1String("meshes")].toArray().last();
        QCOMPARE(mesh[QLatin1String("name")].toString(), QStringLiteral("Worn ball %1").arg(ball.id));
        const QJsonValue primitive = mesh[QLatin1String("primitives")][0];
        const QJsonValue indices = json[QLatin1String("accessors")][primitive[QLatin1String("indices")].toInt()];
        QCOMPARE(indices[QLatin1String("count")].toInt(), static_cast<int>(3 * faces));
        // The chunk is as long as the buffer says.
        const QJsonValue view = json[QLatin1String("bufferViews")].toArray().last();
        QCOMPARE(view[QLatin1String("byteOffset")].toInt() + view[QLatin1String("byteLength")].toInt(),
                 json[QLatin1String("buffers")][0][QLatin1String("byteLength")].toInt());
        QVERIFY(glb.size() >= json[QLatin1String("buffers")][0][QLatin1String("byteLength")].toInt());
    }
};

HAIRPAINT_TEST(TestWornExport, Core)
#include "test_worn_export.moc"
