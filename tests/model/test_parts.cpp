// Characters of several parts: which of them grow hair, their layouts on one map, and the file that keeps them.
#include "model/files/glb.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/files/part_selection.h"
#include "model/heads/layout_packing.h"
#include "model/heads/part_choice.h"
#include "tests/support/character.h"
#include "tests/support/glb_json.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

constexpr glm::vec3 kUp(0.0F, 1.0F, 0.0F);

QStringList namesOf(const RiggedMesh& mesh, PartUse use)
{
    QStringList names;
    for (const MeshPart& part : mesh.parts)
        if (part.use == use)
            names.append(QString::fromStdString(part.name));
    return names;
}

RiggedMesh chosenCharacter(const HeadChoice& choice = {})
{
    RiggedMesh mesh = makeCharacter();
    const Checked<void> chosen = choosePartsBy(mesh, choice, {});
    return chosen ? mesh : RiggedMesh();
}

/// A ball cut in two along x = 0; each half lies on the whole square, or on the halves of it.
RiggedMesh halves(bool shareTexels)
{
    RiggedMesh mesh(makeBallHead(32, 0.1F));
    sim::HeadMesh made;
    for (const glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3 p = mesh.positionsHd[t[corner]];
            const float x = (mesh.positionsHd[t.x].x + mesh.positionsHd[t.y].x + mesh.positionsHd[t.z].x) / 3.0F;
            made.positionsHd.push_back(p);
            made.normalsHd.push_back(mesh.normalsHd[t[corner]]);
            const glm::vec2 at(0.25F + 2.0F * p.z, 0.5F + 4.0F * p.y);
            made.uvs.push_back(shareTexels || x > 0.0F ? at : at + glm::vec2(0.5F, 0.0F));
        }
    for (std::uint32_t i = 0; i + 2 < made.positionsHd.size(); i += 3)
        made.triangles.emplace_back(i, i + 1, i + 2);
    return RiggedMesh(made);
}

} // namespace

class TestParts : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void thePartWithTheScalpGrowsHairUnasked()
    {
        const RiggedMesh mesh = chosenCharacter();
        QCOMPARE(namesOf(mesh, PartUse::Grows), QStringList{QStringLiteral("Head")});
        QCOMPARE(namesOf(mesh, PartUse::Seen).size(), 5);
    }

    void namesDecideWhereShapesWouldNot()
    {
        RiggedMesh mesh = makeCharacter();
        mesh.parts[1].name = "HairBack"; // Now the head is hair, and the body is the topmost skin.
        QVERIFY(choosePartsBy(mesh, {}, {}));
        QVERIFY(!namesOf(mesh, PartUse::Grows).contains(QStringLiteral("HairBack")));
    }

    void aHeadInTwoObjectsIsOneSkin()
    {
        // The ball's triangles above and below its middle as parts that share a ring of positions.
        const sim::HeadMesh ball = makeBallHead(24, 0.1F);
        RiggedMesh mesh;
        for (const bool upper : {true, false}) {
            for (const glm::uvec3& t : ball.triangles) {
                const float y = ball.positionsHd[t.x].y + ball.positionsHd[t.y].y + ball.positionsHd[t.z].y;
                if ((y > 0.0F) != upper)
                    continue;
                for (int corner = 0; corner < 3; ++corner) {
                    mesh.positionsHd.push_back(ball.positionsHd[t[corner]]);
                    mesh.normalsHd.push_back(ball.normalsHd[t[corner]]);
                    mesh.uvs.push_back(ball.uvs[t[corner]]);
                }
                const auto end = static_cast<std::uint32_t>(mesh.positionsHd.size());
                mesh.triangles.emplace_back(end - 3, end - 2, end - 1);
            }
            closePart(mesh, upper ? "Object_7" : "Object_9", "");
        }
        QCOMPARE(likelyUses(mesh, kUp, 1.0F), (std::vector<PartUse>{PartUse::Grows, PartUse::Grows}));
        const RiggedMesh made = arranged(mesh);
        QCOMPARE(made.parts.size(), std::size_t{1});
        QVERIFY(partsFit(made));
        QCOMPARE(made.uvs, mesh.uvs); // They lie beside each other already.
    }

    void aBodyThatHangsTogetherWithTheHeadIsSeen()
    {
        // Tube and ball share a ring of positions at the neck, as objects cut there do.
        const sim::HeadMesh ball = makeBallHead(24, 0.12F);
        RiggedMesh mesh;
        const auto add = [&mesh, &ball](glm::vec3 stretch, glm::vec3 moved) {
            const auto first = static_cast<std::uint32_t>(mesh.positionsHd.size());
            for (std::size_t i = 0; i < ball.positionsHd.size(); ++i) {
                mesh.positionsHd.push_back(ball.positionsHd[i] * stretch + moved);
                mesh.normalsHd.push_back(ball.normalsHd[i]);
                mesh.uvs.push_back(ball.uvs[i]);
            }
            for (const glm::uvec3& t : ball.triangles)
                mesh.triangles.push_back(t + first);
        };
        // The ball's lowest point, a whole row of vertices, is the body's topmost.
        add(glm::vec3(1.0F), {0.0F, 1.68F, 0.0F});
        closePart(mesh, "Head", "Skin");
        add({2.0F, 6.5F, 1.0F}, {0.0F, 0.78F, 0.0F});
        closePart(mesh, "Body", "Skin");
        QCOMPARE(likelyUses(mesh, kUp, 1.0F), (std::vector<PartUse>{PartUse::Grows, PartUse::Seen}));
        mesh.parts[1].name = "Neck";
        for (std::size_t i = ball.positionsHd.size(); i < mesh.positionsHd.size(); ++i)
            mesh.positionsHd[i].y = 1.56F - 0.1F * (1.56F - mesh.positionsHd[i].y); // As high as a neck.
        QCOMPARE(likelyUses(mesh, kUp, 1.0F), (std::vector<PartUse>{PartUse::Grows, PartUse::Grows}));
    }

    void aPartNamedHeadIsBeforeOneWithBroaderShoulders()
    {
        RiggedMesh mesh;
        addBall(mesh, {0.0F, 0.8F, 0.0F}, 0.12F, 16); // A puppet's body, as broad as its head is not.
        for (glm::vec3& position : mesh.positionsHd)
            position.x *= 2.0F;
        closePart(mesh, "Body", "");
        addBall(mesh, {0.0F, 0.95F, 0.0F}, 0.09F, 16);
        closePart(mesh, "Face", "");
        mesh.skeleton = {};
        QCOMPARE(likelyUses(mesh, kUp, 1.0F), (std::vector<PartUse>{PartUse::Seen, PartUse::Grows}));
        mesh.parts[1].name = "Headphones";
        QCOMPARE(likelyUses(mesh, kUp, 1.0F).front(), PartUse::Grows);
    }

    void namesAreThoseOfPartsAndMaterialsAndUnknownOnesAreToldOf()
    {
        const RiggedMesh mesh = chosenCharacter({.comingIn = {QStringLiteral("head"), QStringLiteral("iris")}});
        QCOMPARE(namesOf(mesh, PartUse::Grows), QStringList{QStringLiteral("Head")});
        QCOMPARE(namesOf(mesh, PartUse::Seen), (QStringList{QStringLiteral("Eye_L"), QStringLiteral("Eye_R")}));
        RiggedMesh whole = makeCharacter();
        const Checked<void> unknown = choosePartsBy(whole, {.growing = {QStringLiteral("Scalp")}}, {});
        QVERIFY(!unknown);
        QVERIFY2(unknown.error().text.contains(QStringLiteral("Body, Head")), qPrintable(unknown.error().text));
        const Checked<void> bare = choosePartsBy(whole, {.growing = {QStringLiteral("Glasses")}}, {});
        QVERIFY(!bare && bare.error().text.contains(QStringLiteral("Glasses")));
    }

    /// Each part has one point of the layout for all of its surface.
    void partsWithoutLayoutsAreRefusedOrLaidOutAnew()
    {
        RiggedMesh flat = makeCharacter();
        const std::vector<PartRange> ranges = rangesOf(flat);
        for (std::size_t i = 0; i < flat.parts.size(); ++i) {
            flat.parts[i].hasLayout = false;
            for (std::size_t v = 0; v < ranges[i].vertices; ++v)
                flat.uvs[ranges[i].firstVertex + v] = glm::vec2(0.1F * static_cast<float>(i));
        }
        RiggedMesh chosen = flat;
        QVERIFY(choosePartsBy(chosen, {}, {}));
        const Checked<ChosenHead> refused = headOfParts(chosen, false);
        QVERIFY(!refused && refused.error().cure == Clause::Cure::OtherFile);
        QVERIFY2(refused.error().text.contains(QStringLiteral("uv coordinates")), qPrintable(refused.error().text));
        chosen = flat;
        QVERIFY(choosePartsBy(chosen, {.ownLayout = true}, {}));
        QCOMPARE(namesOf(chosen, PartUse::Grows), QStringList{QStringLiteral("Head")});
        const Checked<ChosenHead> laidOut = headOfParts(chosen, true);
        QVERIFY2(laidOut, laidOut ? "" : qPrintable(laidOut.error().text));
    }

    void layoutsOverEachOtherLieSideBySide()
    {
        const RiggedMesh mesh = arranged(chosenCharacter({.growing = {QStringLiteral("Head"), QStringLiteral("Bag")}}));
        QVERIFY(partsFit(mesh));
        const PartRange head = rangesOf(mesh).front();
        sim::HeadMesh grown;
        grown.positionsHd.assign(mesh.positionsHd.begin(),
                                 mesh.positionsHd.begin() + static_cast<std::ptrdiff_t>(head.vertices));
        grown.uvs.assign(mesh.uvs.begin(), mesh.uvs.begin() + static_cast<std::ptrdiff_t>(head.vertices));
        grown.triangles.assign(mesh.triangles.begin(),
                               mesh.triangles.begin() + static_cast<std::ptrdiff_t>(head.triangles));
        QVERIFY(overlapOf(grown).fraction < kNotableOverlap);
        for (const glm::vec2& uv : grown.uvs)
            QVERIFY(uv.x >= 0.0F && uv.x <= 1.0F && uv.y >= 0.0F && uv.y <= 0.5F); // Two cells of four.
    }

    void halvesThatShareTexelsAreToldOf()
    {
        const LayoutOverlap shared = overlapOf(halves(true));
        QVERIFY2(shared.fraction > 0.9 && shared.isMirrored, qPrintable(QString::number(shared.fraction)));
        QVERIFY(overlapOf(halves(false)).fraction < kNotableOverlap);
        const Checked<ChosenHead> head = headOfParts(halves(true), false);
        QVERIFY(head && head->remarks.size() == 1);
        QVERIFY2(head->remarks.first().contains(QStringLiteral("left and right")), qPrintable(head->remarks.first()));
    }

    void aLayoutOfOurOwnSharesNoTexels()
    {
        const Checked<ChosenHead> head = headOfParts(halves(true), true);
        QVERIFY(head && head->remarks.isEmpty());
        QVERIFY(overlapOf(head->mesh).fraction < 0.005);
        QCOMPARE(head->mesh.triangles.size(), halves(true).triangles.size());
        for (const glm::vec2& uv : head->mesh.uvs)
            QVERIFY(uv.x >= 0.0F && uv.x <= 1.0F && uv.y >= 0.0F && uv.y <= 1.0F);
        // A character's head alone is laid out anew; the other parts stay.
        RiggedMesh character = chosenCharacter();
        const Checked<ChosenHead> ofParts = headOfParts(character, true);
        QVERIFY(ofParts && partsFit(ofParts->mesh));
        QCOMPARE(ofParts->mesh.parts.size(), std::size_t{6});
    }

    void aCharacterComesBackFromItsFile()
    {
        const RiggedMesh mesh = arranged(chosenCharacter());
        const QByteArray glb = glbFromMesh(mesh);
        const Checked<GlbParts> parts = partsFromGlb(glb);
        QVERIFY(parts);
        QCOMPARE(parts->parts.size(), std::size_t{5});
        QCOMPARE(parts->parts.front().name, std::string("Body"));
        QVERIFY(parts->parts.front().texture);
        QCOMPARE(*parts->parts.front().texture, makeCharacter().textures.front());
        QCOMPARE(parts->parts[1].texture, parts->parts[2].texture); // Both eyes show one.
        QCOMPARE(parts->parts[3].colour, glm::vec3(0.2F, 0.1F, 0.05F));
        QCOMPARE(parts->weights.front().size(), parts->parts.front().mesh->positionsHd.size());
        const Checked<sim::HeadMesh> head = meshFromGlb(glb);
        QVERIFY(head);
        QCOMPARE(head->positionsHd.size(), std::size_t{mesh.parts.front().vertices});
        QVERIFY(skeletonFromGlb(glb));
        QCOMPARE(glbFromMesh(mesh), glb);
    }

    void partsAreSeenAndTouchedAndGrowNothing()
    {
        const auto head = makeHead(QStringLiteral("Ann"), glbFromMesh(arranged(chosenCharacter())), 1.0F, UpAxis::Y);
        QVERIFY(head);
        QCOMPARE((*head)->parts.size(), std::size_t{5});
        for (const glm::vec3& position : (*head)->skin->mesh().positionsHd)
            QVERIFY(glm::distance(position, kCharacterHead) < 0.13F);
        // The bag hangs half a metre below the head, and hair does not go through it.
        QVERIFY((*head)->distances);
        const auto inside = (*head)->distances->at(kCharacterHead + glm::vec3(0.0F, -0.5F, 0.1F));
        QVERIFY(inside && inside->distanceM < 0.0F);
    }

    void hostilePartsAreRefused_data()
    {
        QTest::addColumn<QString>("what");
        for (const char* what : {"colour", "material", "texture", "view", "name", "joints"})
            QTest::newRow(what) << QString::fromLatin1(what);
    }
    void hostilePartsAreRefused()
    {
        QFETCH(QString, what);
        const QByteArray glb = withJson(glbFromMesh(arranged(chosenCharacter())), [&what](QJsonObject& root) {
            QJsonArray meshes = root[QLatin1String("meshes")].toArray();
            QJsonArray materials = root[QLatin1String("materials")].toArray();
            QJsonObject mesh = meshes[1].toObject();
            QJsonObject primitive = mesh[QLatin1String("primitives")][0].toObject();
            QJsonObject surface = materials[1].toObject()[QLatin1String("pbrMetallicRoughness")].toObject();
            if (what == QLatin1String("name"))
                mesh[QLatin1String("name")] = QStringLiteral("a\nb");
            else if (what == QLatin1String("material"))
                primitive[QLatin1String("material")] = 99;
            else if (what == QLatin1String("joints"))
                primitive[QLatin1String("attributes")] = [&] {
                    QJsonObject attributes = primitive[QLatin1String("attributes")].toObject();
                    attributes.remove(QLatin1String("WEIGHTS_0"));
                    return attributes;
                }();
            else if (what == QLatin1String("colour"))
                surface[QLatin1String("baseColorFactor")] = QJsonArray{1e9, 0, 0, 1};
            else if (what == QLatin1String("texture"))
                surface[QLatin1String("baseColorTexture")] = QJsonObject{{QStringLiteral("index"), -3}};
            else
                root[QLatin1String("images")] =
                    QJsonArray{QJsonObject{{QStringLiteral("bufferView"), 0}}, QJsonObject{}};
            QJsonObject material = materials[1].toObject();
            material[QLatin1String("pbrMetallicRoughness")] = surface;
            materials[1] = material;
            mesh[QLatin1String("primitives")] = QJsonArray{primitive};
            meshes[1] = mesh;
            root[QLatin1String("meshes")] = meshes;
            root[QLatin1String("materials")] = materials;
        });
        QVERIFY(!partsFromGlb(glb));
        QVERIFY(!makeHead(QStringLiteral("Eve"), glb, 1.0F, UpAxis::Y));
    }
};

HAIRPAINT_TEST(TestParts, Core)
#include "test_parts.moc"
