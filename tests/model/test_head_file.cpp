// Heads: the built-in one, our subset of binary glTF, and unit and axis of a foreign mesh.
#include "model/files/glb.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/files/json_fields.h"
#include "sim/groom/direction_texel.h"
#include "sim/skin/mesh_openings.h"
#include "sim/skin/skin_frame.h"
#include "tests/model/sample_project.h"
#include "tests/support/glb_json.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QJsonDocument>
#include <QTest>
#include <QtEndian>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <tuple>

using namespace hairpaint;
using namespace hairpaint::model;
using test::withJson;

namespace {

bool sameBytes(const sim::HeadMesh& a, const sim::HeadMesh& b)
{
    return a.positionsHd == b.positionsHd && a.normalsHd == b.normalsHd && a.uvs == b.uvs && a.triangles == b.triangles;
}

/// Changes one number of an accessor or buffer view.
std::function<void(QJsonObject&)> setting(const char* list, int index, const char* key, const QJsonValue& value)
{
    return [=](QJsonObject& root) {
        QJsonArray array = root.value(QLatin1String(list)).toArray();
        QJsonObject object = array.at(index).toObject();
        object.insert(QLatin1String(key), value);
        array.replace(index, object);
        root.insert(QLatin1String(list), array);
    };
}

} // namespace

class TestHeadFile : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theBuiltInHeadIsLoadedOnceAndIsAHead()
    {
        const std::shared_ptr<const Head> head = defaultHead();
        QCOMPARE(head, defaultHead());
        QCOMPARE(head->name, QStringLiteral("bust-2"));
        QVERIFY(head->shownMesh->positionsHd.size() > 3 * head->skin->mesh().positionsHd.size());
        QVERIFY(sim::openEdges(*head->shownMesh).empty());
        const HeadGuess guess = guessHead(head->skin->mesh());
        QCOMPARE(guess.unitScale, 1.0F);
        QVERIFY(guess.upAxis == UpAxis::Y);
        QVERIFY(builtInEllipsoids().size() >= 3 && builtInEllipsoids().size() <= 8);
    }

    void theNewBustsSkinIsMarked()
    {
        const std::shared_ptr<const Head> head = defaultHead();
        const sim::HeadMesh& shown = *head->shownMesh;
        const sim::HeadMesh& coarse = head->skin->mesh();
        QCOMPARE(shown.marks.size(), shown.positionsHd.size());
        QCOMPARE(coarse.marks.size(), coarse.positionsHd.size());
        const sim::Skin skin(shown);
        const auto at = [&](const glm::vec3& positionHd) {
            return shown.marks[shown.triangles[skin.nearest(positionHd).face].x];
        };
        QVERIFY(at({0.0F, 0.12F, -0.03F}).sky > 250);      // The crown sees all of it,
        QVERIFY(at({0.0F, -0.120F, 0.045F}).sky < 190);    // so does the skin under the chin.
        QVERIFY(at({0.0F, -0.0750F, 0.1F}).lips > 200);    // The lower lip,
        QCOMPARE(at({0.0F, -0.0540F, 0.1F}).lips, 0);      // the philtrum,
        QVERIFY(at({0.032F, -0.002F, 0.09F}).lids > 150);  // a closed eye,
        QCOMPARE(at({0.032F, 0.030F, 0.09F}).lids, 0);     // the brow.
        QVERIFY(at({0.042F, -0.030F, 0.07F}).blush > 120); // A cheek.
        QVERIFY(std::ranges::none_of(shown.marks, [](const sim::SkinMarks& m) { return m.lips > 0 && m.lids > 0; }));

        // The hollow of the ear is the darkest beside the head.
        std::uint8_t inEar = 255;
        for (std::size_t i = 0; i < shown.positionsHd.size(); ++i)
            if (shown.positionsHd[i].x > 0.06F && std::abs(shown.positionsHd[i].y + 0.012F) < 0.03F)
                inEar = std::min(inEar, shown.marks[i].sky);
        QVERIFY2(inEar < 120, qPrintable(QString::number(inEar)));

        const Checked<std::shared_ptr<const Head>> old = builtInHead(QStringLiteral("bust-1"));
        QVERIFY(old && (*old)->shownMesh->marks.empty());
        // Hair is kept off it by its surface, not by ellipsoids alone.
        QVERIFY((*old)->distances != nullptr);
    }

    void hairGrowsAwayFromTheCrown_data()
    {
        QTest::addColumn<glm::vec3>("positionHd");
        QTest::addColumn<glm::vec3>("grows");
        QTest::newRow("top") << glm::vec3(0.0F, 0.12F, 0.03F) << glm::vec3(0.0F, 0.0F, 1.0F);
        QTest::newRow("hairline") << glm::vec3(0.0F, 0.0728F, 0.0748F) << glm::vec3(0.0F, -0.6F, 0.8F);
        QTest::newRow("over the left ear") << glm::vec3(0.08F, 0.03F, 0.0F) << glm::vec3(0.0F, -1.0F, 0.0F);
        QTest::newRow("over the right ear") << glm::vec3(-0.08F, 0.03F, 0.0F) << glm::vec3(0.0F, -1.0F, 0.0F);
        QTest::newRow("nape") << glm::vec3(0.0F, -0.05F, -0.09F) << glm::vec3(0.0F, -1.0F, 0.0F);
        QTest::newRow("cheek") << glm::vec3(0.05F, -0.06F, 0.07F) << glm::vec3(0.0F, -1.0F, 0.0F);
    }
    void hairGrowsAwayFromTheCrown()
    {
        QFETCH(glm::vec3, positionHd);
        QFETCH(glm::vec3, grows);
        for (const char* name : {"bust-1", "bust-2"}) {
            const std::shared_ptr<const Head> head = builtInHead(QString::fromLatin1(name)).value();
            QVERIFY(head->naturalDirection != nullptr);
            QCOMPARE(head->naturalDirection->channels(), 2);
            const sim::SurfacePoint point = head->skin->nearest(positionHd);
            const glm::vec2 channels(head->naturalDirection->sampleBilinear(point.uv));
            const glm::vec3 direction = sim::SkinFrame::at(point).toHd(sim::directionOfChannels(channels * 65535.0F));
            QVERIFY2(glm::length(direction) > 0.5F && glm::dot(glm::normalize(direction), grows) > 0.8F,
                     qPrintable(QStringLiteral("%1: %2 %3 %4")
                                    .arg(QLatin1StringView(name))
                                    .arg(direction.x)
                                    .arg(direction.y)
                                    .arg(direction.z)));
        }
    }

    void theMarksAreSymmetric()
    {
        const sim::HeadMesh& mesh = defaultHead()->skin->mesh();
        std::map<std::tuple<float, float, float>, sim::SkinMarks> known;
        for (std::size_t i = 0; i < mesh.positionsHd.size(); ++i)
            known[{mesh.positionsHd[i].x, mesh.positionsHd[i].y, mesh.positionsHd[i].z}] = mesh.marks[i];
        for (const auto& [positionHd, marks] : known) {
            const auto mirrored =
                known.find({-std::get<0>(positionHd), std::get<1>(positionHd), std::get<2>(positionHd)});
            QVERIFY(mirrored != known.end());
            QCOMPARE(mirrored->second.sky, marks.sky);
            QCOMPARE(mirrored->second.lips, marks.lips);
            QCOMPARE(mirrored->second.lids, marks.lids);
            QCOMPARE(mirrored->second.blush, marks.blush);
        }
    }

    void aMeshComesBackBitForBit()
    {
        for (const sim::HeadMesh& mesh : {test::makeBallHead(16), defaultHead()->skin->mesh()}) {
            const QByteArray glb = glbFromMesh(mesh);
            const Checked<sim::HeadMesh> back = meshFromGlb(glb);
            QVERIFY(back);
            QVERIFY(sameBytes(mesh, *back));
            QVERIFY(glbFromMesh(*back) == glb);
        }
    }

    void uvsAreTakenFromTheTextureWhereOursAreMissing()
    {
        const sim::HeadMesh mesh = test::makeBallHead(8);
        const QByteArray glb = withJson(glbFromMesh(mesh), [](QJsonObject& root) {
            QByteArray text = QJsonDocument(root).toJson();
            text.replace("\"_UV\"", "\"_OTHER\"");
            root = QJsonDocument::fromJson(text).object();
        });
        const Checked<sim::HeadMesh> back = meshFromGlb(glb);
        QVERIFY(back);
        for (std::size_t i = 0; i < mesh.uvs.size(); ++i)
            QVERIFY(glm::distance(mesh.uvs[i], back->uvs[i]) < 1e-6F);
    }

    void aBrokenGlbIsRefused_data()
    {
        QTest::addColumn<QByteArray>("glb");
        const QByteArray good = glbFromMesh(test::makeBallHead(8));
        const auto row = [](const char* name, const QByteArray& glb) { QTest::newRow(name) << glb; };
        row("empty", {});
        row("a text", "glTF is a nice format");
        row("only a header", good.first(12));
        row("cut short", good.chopped(100));
        row("a byte too many", good + "x");
        row("no JSON", withJson(good, [](QJsonObject& root) { root = {}; }));
        row("an accessor that is not there",
            withJson(good, [](QJsonObject& root) { root.remove(QLatin1String("accessors")); }));
        row("a count above the buffer", withJson(good, setting("accessors", 1, "count", 1'000'000)));
        row("a count above the limit", withJson(good, setting("accessors", 1, "count", 4e9)));
        row("a negative count", withJson(good, setting("accessors", 1, "count", -1)));
        row("fewer normals", withJson(good, setting("accessors", 2, "count", 3)));
        row("16-bit indices", withJson(good, setting("accessors", 0, "componentType", 5123)));
        row("a view outside the buffer", withJson(good, setting("bufferViews", 1, "byteOffset", 1 << 30)));
        row("a view that overflows", withJson(good, setting("bufferViews", 1, "byteOffset", 9.2e18)));
        row("a negative view", withJson(good, setting("bufferViews", 1, "byteOffset", -4)));
        row("interleaved", withJson(good, setting("bufferViews", 1, "byteStride", 32)));
        row("lines", withJson(good, [](QJsonObject& root) {
                QByteArray text = QJsonDocument(root).toJson();
                text.replace("\"mode\": 4", "\"mode\": 1");
                root = QJsonDocument::fromJson(text).object();
            }));
        sim::HeadMesh mesh = test::makeBallHead(8);
        mesh.triangles[3].y = 100'000;
        row("an index out of range", glbFromMesh(mesh));
        mesh = test::makeBallHead(8);
        mesh.positionsHd[2].z = std::numeric_limits<float>::quiet_NaN();
        row("a position that is no number", glbFromMesh(mesh));
        mesh.positionsHd[2].z = 1e20F;
        row("a position light years away", glbFromMesh(mesh));
        mesh = test::makeBallHead(8);
        mesh.uvs[2].x = std::numeric_limits<float>::infinity();
        row("an endless uv", glbFromMesh(mesh));
        mesh.uvs[2].x = 3e38F;
        row("a uv light years away", glbFromMesh(mesh));
        mesh.uvs[2].x = -1001.0F;
        row("a uv a little beyond the limit", glbFromMesh(mesh));
    }
    void aBrokenGlbIsRefused()
    {
        QFETCH(QByteArray, glb);
        QVERIFY(!meshFromGlb(glb));
        const auto head = makeHead(QStringLiteral("ball"), glb, 1.0F, UpAxis::Y);
        QVERIFY(!head);
        QVERIFY(test::isOneSentenceNaming(head.error().message, QStringLiteral("ball")));
    }

    void flippedBitsOfAGlbNeverCrash()
    {
        const QByteArray good = glbFromMesh(test::makeBallHead(8));
        std::mt19937 random(99);
        for (int round = 0; round < 3000; ++round) {
            QByteArray glb = good;
            // Mostly in the JSON, which says where everything lies.
            const auto range = static_cast<quint32>(round % 4 == 0 ? glb.size() : 1400);
            for (int flips = 0; flips < 3; ++flips) {
                const auto at = static_cast<qsizetype>(random() % range);
                glb[at] = static_cast<char>(glb[at] ^ (1 << (random() % 8)));
            }
            const auto mesh = meshFromGlb(glb);
            QVERIFY(mesh || !mesh.error().text.isEmpty());
        }
    }

    void unitAndAxisAreGuessed_data()
    {
        QTest::addColumn<glm::vec3>("size");
        QTest::addColumn<float>("unitScale");
        QTest::addColumn<int>("upAxis");
        const auto row = [](const char* name, glm::vec3 size, float scale, UpAxis axis) {
            QTest::newRow(name) << size << scale << static_cast<int>(axis);
        };
        row("a head in metres", {0.16F, 0.23F, 0.2F}, 1.0F, UpAxis::Y);
        row("a head in centimetres", {16.0F, 23.0F, 20.0F}, 0.01F, UpAxis::Y);
        row("a head in millimetres", {160.0F, 230.0F, 200.0F}, 0.001F, UpAxis::Y);
        row("a head in inches", {6.3F, 9.0F, 7.9F}, 0.0254F, UpAxis::Y);
        row("a head in metres, z up", {0.16F, 0.2F, 0.23F}, 1.0F, UpAxis::Z);
        row("a head in centimetres, z up", {16.0F, 20.0F, 23.0F}, 0.01F, UpAxis::Z);
        row("a bust in metres", {0.45F, 0.55F, 0.25F}, 1.0F, UpAxis::Y);
        row("a bust in centimetres, z up", {45.0F, 25.0F, 60.0F}, 0.01F, UpAxis::Z);
        row("a whole figure in metres", {0.6F, 1.8F, 0.3F}, 1.0F, UpAxis::Y);
        row("a whole figure in centimetres", {140.0F, 175.0F, 30.0F}, 0.01F, UpAxis::Y);
        row("a whole figure in millimetres, z up", {600.0F, 300.0F, 1800.0F}, 0.001F, UpAxis::Z);
        row("a child in inches", {20.0F, 45.0F, 8.0F}, 0.0254F, UpAxis::Y);
        row("nothing", {0.0F, 0.0F, 0.0F}, 1.0F, UpAxis::Y);
    }
    void unitAndAxisAreGuessed()
    {
        QFETCH(glm::vec3, size);
        QFETCH(float, unitScale);
        QFETCH(int, upAxis);
        sim::HeadMesh mesh = test::makeBallHead(12, 0.5F);
        for (glm::vec3& p : mesh.positionsHd)
            p *= size;
        const HeadGuess guess = guessHead(mesh);
        QCOMPARE(guess.unitScale, unitScale);
        QCOMPARE(static_cast<int>(guess.upAxis), upAxis);
    }

    void whatAFileTellsIsNotGuessed()
    {
        RiggedMesh mesh(test::makeBallHead(12, 0.5F));
        for (glm::vec3& p : mesh.positionsHd)
            p *= glm::vec3(1.5F, 0.9F, 1.9F);
        mesh.told = {.metresPerUnit = 0.1F, .up = ToldAxis::Y};
        HeadGuess guess = guessHead(mesh);
        QCOMPARE(guess.unitScale, 0.1F);
        QVERIFY(guess.upAxis == UpAxis::Y);
        mesh.told.metresPerUnit = 0.0F;
        QCOMPARE(guessHead(mesh).unitScale, 1.0F);
        guess = chosen(guess, {.metresPerUnit = 0.01F, .upAxis = UpAxis::Z});
        QCOMPARE(guess.unitScale, 0.01F);
        QVERIFY(guess.upAxis == UpAxis::Z);
    }

    void aScalpIsOpenBelow()
    {
        // The upper half of a ball, deeper than it is high.
        RiggedMesh scalp(test::makeBallHead(24, 0.1F));
        std::erase_if(scalp.triangles, [&scalp](const glm::uvec3& t) {
            return std::min({scalp.positionsHd[t.x].y, scalp.positionsHd[t.y].y, scalp.positionsHd[t.z].y}) < -0.01F;
        });
        for (glm::vec3& p : scalp.positionsHd)
            p.y = std::max(p.y, 0.0F);
        QVERIFY(guessHead(scalp).upAxis == UpAxis::Y);
    }

    void aFaceIsTurnedToTheFront_data()
    {
        QTest::addColumn<int>("upAxis");
        QTest::addColumn<glm::ivec3>("facing");
        QTest::addColumn<bool>("canBe");
        const auto row = [](const char* name, UpAxis up, glm::ivec3 facing, bool canBe) {
            QTest::newRow(name) << static_cast<int>(up) << facing << canBe;
        };
        row("as it is", UpAxis::Y, {0, 0, 1}, true);
        row("seen from behind", UpAxis::Y, {0, 0, -1}, true);
        row("to the side", UpAxis::Y, {1, 0, 0}, true);
        row("to the other side", UpAxis::Y, {-1, 0, 0}, true);
        row("upward", UpAxis::Y, {0, 1, 0}, false);
        row("z up, as it is", UpAxis::Z, {0, -1, 0}, true);
        row("z up, from behind", UpAxis::Z, {0, 1, 0}, true);
        row("z up, to the side", UpAxis::Z, {1, 0, 0}, true);
        row("z up, downward", UpAxis::Z, {0, 0, -1}, false);
    }
    void aFaceIsTurnedToTheFront()
    {
        QFETCH(int, upAxis);
        QFETCH(glm::ivec3, facing);
        QFETCH(bool, canBe);
        const bool isZ = static_cast<UpAxis>(upAxis) == UpAxis::Z;
        const glm::vec3 up = isZ ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
        RiggedMesh mesh;
        mesh.positionsHd = {glm::vec3(facing) * 0.1F, up, glm::cross(up, glm::vec3(facing))};
        mesh.normalsHd = mesh.positionsHd;
        mesh.skeleton.joints = {{.name = "a", .translation = glm::vec3(facing)}};
        const RiggedMesh before = mesh;
        QCOMPARE(turnToFront(mesh, static_cast<UpAxis>(upAxis), facing), canBe);
        if (!canBe) {
            QCOMPARE(mesh.positionsHd, before.positionsHd);
            return;
        }
        const glm::vec3 front = isZ ? glm::vec3(0, -1, 0) : glm::vec3(0, 0, 1);
        QCOMPARE(mesh.positionsHd[0], front * 0.1F);
        QCOMPARE(mesh.positionsHd[1], up);
        QCOMPARE(mesh.positionsHd[2], glm::vec3(1, 0, 0)); // The face's left stays its left.
        QCOMPARE(mesh.skeleton.joints[0].translation, front);
        QVERIFY(glm::distance(mesh.skeleton.joints[0].rotation * glm::vec3(facing), front) < 1e-6F);
    }

    void scaleAndAxisAreAppliedAndNothingIsCentred()
    {
        sim::HeadMesh source = test::makeBallHead(12, 10.0F);
        for (glm::vec3& p : source.positionsHd)
            p += glm::vec3(1.0F, 2.0F, 150.0F);
        const auto head = makeHead(QStringLiteral("ball"), glbFromMesh(source), 0.01F, UpAxis::Z);
        QVERIFY(head);
        const sim::HeadMesh& mesh = (*head)->skin->mesh();
        for (std::size_t i = 0; i < mesh.positionsHd.size(); ++i) {
            const glm::vec3 p = source.positionsHd[i];
            QCOMPARE(mesh.positionsHd[i], glm::vec3(p.x, p.z, -p.y) * 0.01F);
        }
        QVERIFY(!(*head)->builtIn);
        QCOMPARE((*head)->shownMesh.get(), &(*head)->skin->mesh());
    }

    void aHeadFarFromTheOriginIsRefused()
    {
        sim::HeadMesh mesh = test::makeBallHead(8);
        for (glm::vec3& p : mesh.positionsHd)
            p.x += 900.0F;
        QVERIFY(makeHead(QStringLiteral("ball"), glbFromMesh(mesh), 1.0F, UpAxis::Y));
        for (glm::vec3& p : mesh.positionsHd)
            p.x += 200.0F;
        const auto head = makeHead(QStringLiteral("ball"), glbFromMesh(mesh), 1.0F, UpAxis::Y);
        QVERIFY(!head);
        QVERIFY(test::isOneSentenceNaming(head.error().message, QStringLiteral("ball")));
    }

    void aHeadOfAnImpossibleSizeIsRefused_data()
    {
        QTest::addColumn<float>("unitScale");
        QTest::newRow("a kilometre") << 10'000.0F;
        QTest::newRow("an atom") << 1e-6F;
    }
    void aHeadOfAnImpossibleSizeIsRefused()
    {
        QFETCH(float, unitScale);
        const auto head = makeHead(QStringLiteral("ball"), glbFromMesh(test::makeBallHead(8)), unitScale, UpAxis::Y);
        QVERIFY(!head);
        QVERIFY(test::isOneSentenceNaming(head.error().message, QStringLiteral("ball")));
    }
};

HAIRPAINT_TEST(TestHeadFile, Core)
#include "test_head_file.moc"
