// Hair with a whole body, as VRM 1.0.
#include "model/cards/avatar_body.h"
#include "tests/model/archive_maker.h"
#include "tests/model/exported_hair.h"
#include "tests/support/glb_json.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <numbers>

using namespace hairpaint;
using namespace hairpaint::model;
using test::frameOf;
using test::hairGroup;
using test::mannequinAvatar;

namespace {

constexpr float kHandM = 0.7F; // How far to the side the mannequin's are.

glm::vec3 positionOf(const Avatar& avatar, const AvatarBody& body, HumanBone bone)
{
    return body.poses[static_cast<std::size_t>(avatar.bones[bone])].position;
}

/// The same body, seen from another side, and its mesh likewise.
Avatar turnedAvatar(const Avatar& avatar, float angle)
{
    const glm::quat turn = glm::angleAxis(angle, glm::vec3(0.0F, 1.0F, 0.0F));
    Avatar turned = avatar;
    std::vector<JointPose> poses = posesOf(turned.skeleton);
    for (JointPose& pose : poses)
        pose = {.position = turn * pose.position, .rotation = turn * pose.rotation};
    setPoses(turned.skeleton, poses);
    sim::HeadMesh mesh = avatar.skin->mesh();
    for (glm::vec3& position : mesh.positionsHd)
        position = turn * position;
    for (glm::vec3& normal : mesh.normalsHd)
        normal = turn * normal;
    turned.skin = std::make_shared<const sim::Skin>(std::move(mesh));
    return turned;
}

/// On the crown of the mannequin.
Worn bead()
{
    sim::SurfacePoint point;
    point.positionHd = {0.02F, 1.75F, 0.03F};
    Worn worn = makeWorn(wornSpec(WornKind::Ball), point);
    worn.id = 9;
    worn.sheen = 0.0F;
    return worn;
}

/// nodes.end() where none has the name.
QJsonArray::const_iterator namedNode(const QJsonArray& nodes, QLatin1String name)
{
    return std::ranges::find_if(
        nodes, [name](const QJsonValue& node) { return node[QLatin1String("name")].toString() == name; });
}

} // namespace

class TestAvatarFile : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    /// `worn`: besides a part of the head.
    [[nodiscard]] QJsonObject exported(const std::shared_ptr<const sim::StrandFrame>& frame,
                                       const std::shared_ptr<const Avatar>& avatar, std::vector<Worn> worn = {}) const
    {
        worn.push_back({.shape = {.centreHd = {0.0F, 1.6F, 0.0F}}});
        const QString path = m_folder.filePath(QStringLiteral("a.vrm"));
        const Result<void> written = exportHair(frame,
                                                {.format = findExportFormat(path),
                                                 .target = &exportTargets().front(),
                                                 .curves = test::allOf(*frame),
                                                 .cards = {.triangles = 1'000, .atlasPx = 1024, .levels = 3},
                                                 .worn = std::move(worn),
                                                 .avatar = avatar},
                                                path);
        return written ? test::jsonOf(test::readBytes(path)) : QJsonObject{};
    }

private Q_SLOTS:
    void theFileSaysWhatVrmAsksFor()
    {
        const QJsonObject json = exported(frameOf({hairGroup(1, 30'000, 65535, 0)}), mannequinAvatar());
        const QJsonValue vrm = json[QLatin1String("extensions")][QLatin1String("VRMC_vrm")];
        QCOMPARE(vrm[QLatin1String("specVersion")].toString(), QStringLiteral("1.0"));
        QCOMPARE(vrm[QLatin1String("meta")][QLatin1String("name")].toString(), QStringLiteral("Mannequin"));
        QCOMPARE(vrm[QLatin1String("meta")][QLatin1String("authors")].toArray(), QJsonArray{QStringLiteral("Ann")});
        QCOMPARE(vrm[QLatin1String("meta")][QLatin1String("licenseUrl")].toString(),
                 QStringLiteral("https://vrm.dev/licenses/1.0/"));
        QCOMPARE(json[QLatin1String("extensionsUsed")].toArray(),
                 (QJsonArray{QStringLiteral("VRMC_springBone"), QStringLiteral("VRMC_vrm")}));
        const QJsonArray nodes = json[QLatin1String("nodes")].toArray();
        const QJsonObject bones = vrm[QLatin1String("humanoid")][QLatin1String("humanBones")].toObject();
        const auto nodeOf = [&bones](const char* id) {
            return bones[QLatin1String(id)][QLatin1String("node")].toInt();
        };
        QCOMPARE(nodes[nodeOf("head")][QLatin1String("name")].toString(), QStringLiteral("mixamorig:Head"));
        QCOMPARE(nodes[nodeOf("leftLowerLeg")][QLatin1String("name")].toString(), QStringLiteral("mixamorig:LeftLeg"));
        for (std::size_t i = 0; i < kHumanBoneCount; ++i) {
            const HumanBoneSpec& spec = humanBoneSpec(static_cast<HumanBone>(i));
            QVERIFY2(!spec.required || bones.contains(QLatin1StringView(spec.id)), spec.id);
        }
    }

    void hairHangsFromTheHeadBone()
    {
        const QJsonObject json = exported(frameOf({hairGroup(1, 30'000, 65535, 0)}), mannequinAvatar());
        const QJsonObject extensions = json[QLatin1String("extensions")].toObject();
        const int head = extensions[QLatin1String("VRMC_vrm")][QLatin1String("humanoid")][QLatin1String("humanBones")]
                                   [QLatin1String("head")][QLatin1String("node")]
                                       .toInt();
        const QJsonArray nodes = json[QLatin1String("nodes")].toArray();
        const QJsonArray children = nodes[head][QLatin1String("children")].toArray();
        const QJsonValue springBone = extensions[QLatin1String("VRMC_springBone")];
        const QJsonArray springs = springBone[QLatin1String("springs")].toArray();
        QVERIFY(springs.size() > 3);
        for (const QJsonValue spring : springs)
            QVERIFY(children.contains(spring[QLatin1String("joints")][0][QLatin1String("node")]));
        QCOMPARE(springBone[QLatin1String("colliders")][0][QLatin1String("node")].toInt(), head);
        // Cards follow the chains, the body its own joints.
        const QJsonArray skins = json[QLatin1String("skins")].toArray();
        QCOMPARE(skins.size(), qsizetype{2});
        QCOMPARE(skins[0][QLatin1String("joints")].toArray().size(), 1 + 5 * springs.size());
        QCOMPARE(skins[0][QLatin1String("joints")][0].toInt(), head);
        QCOMPARE(skins[1][QLatin1String("joints")].toArray().size(), static_cast<qsizetype>(test::kMannequin.size()));
        int skinned = 0;
        for (const QJsonValue node : nodes)
            if (node[QLatin1String("mesh")].isDouble()) {
                const bool isBody = node[QLatin1String("name")].toString() == QLatin1String("Head mesh");
                QCOMPARE(node[QLatin1String("skin")].toInt(-1), isBody ? 1 : 0);
                ++skinned;
            }
        QCOMPARE(skinned, 2); // One level alone.
    }

    void theTailsOfABowSwing()
    {
        sim::SurfacePoint point;
        point.positionHd = {0.0F, 1.75F, -0.05F};
        point.normalHd = {0.0F, 0.0F, -1.0F};
        Worn bow = makeWorn(wornSpec(WornKind::Bow), point);
        bow.id = 5;
        const auto frame = frameOf({hairGroup(1, 30'000, 65535, 0)});
        const QJsonObject plain = exported(frame, mannequinAvatar());
        const QJsonObject json = exported(frame, mannequinAvatar(), {bow});
        const auto springsIn = [](const QJsonObject& file) {
            return file[QLatin1String("extensions")][QLatin1String("VRMC_springBone")][QLatin1String("springs")]
                .toArray();
        };
        const QJsonArray springs = springsIn(json);
        QCOMPARE(springs.size(), springsIn(plain).size() + 2);
        const QJsonArray nodes = json[QLatin1String("nodes")].toArray();
        qsizetype joints = 1;
        for (const QJsonValue spring : springs)
            joints += spring[QLatin1String("joints")].toArray().size();
        QCOMPARE(json[QLatin1String("skins")][0][QLatin1String("joints")].toArray().size(), joints);
        for (qsizetype i = springs.size() - 2; i < springs.size(); ++i) {
            QVERIFY(springs[i][QLatin1String("name")].toString().startsWith(QLatin1String("Worn bow 5 tail ")));
            // From joint to joint it goes down.
            const QJsonArray chain = springs[i][QLatin1String("joints")].toArray();
            QCOMPARE(chain.size(), qsizetype{4});
            for (qsizetype j = 1; j < chain.size(); ++j) {
                const QJsonValue node = nodes[chain[j][QLatin1String("node")].toInt()];
                QVERIFY(node[QLatin1String("translation")][1].toDouble() < 0.0);
            }
        }
        const auto body = namedNode(nodes, QLatin1String("Worn bow 5"));
        QVERIFY(body != nodes.end());
        QCOMPARE((*body)[QLatin1String("skin")].toInt(-1), 0);
    }

    void whatIsWornHangsFromTheHeadBone_data()
    {
        QTest::addColumn<bool>("hasHair");
        QTest::addColumn<float>("angle");
        QTest::newRow("with hair") << true << 0.0F;
        QTest::newRow("bald") << false << 0.0F;
        QTest::newRow("of a body that looked away") << true << std::numbers::pi_v<float>;
    }
    void whatIsWornHangsFromTheHeadBone()
    {
        QFETCH(bool, hasHair);
        QFETCH(float, angle);
        auto avatar = std::make_shared<Avatar>(turnedAvatar(*mannequinAvatar(), angle));
        const QJsonObject json =
            exported(hasHair ? frameOf({hairGroup(1, 30'000, 65535, 0)}) : frameOf({}), avatar, {bead()});
        const QJsonArray nodes = json[QLatin1String("nodes")].toArray();
        const auto node = namedNode(nodes, QLatin1String("Worn ball 9"));
        QVERIFY(node != nodes.end());
        // With the body's skin, whose joint of the head holds all of it.
        const QJsonValue skin = json[QLatin1String("skins")][(*node)[QLatin1String("skin")].toInt()];
        QCOMPARE(skin[QLatin1String("name")].toString(), QStringLiteral("Body"));
        const int head = json[QLatin1String("extensions")][QLatin1String("VRMC_vrm")][QLatin1String("humanoid")]
                             [QLatin1String("humanBones")][QLatin1String("head")][QLatin1String("node")]
                                 .toInt();
        QCOMPARE(skin[QLatin1String("joints")][avatar->bones[HumanBone::Head]].toInt(), head);
        const QJsonValue mesh = json[QLatin1String("meshes")][(*node)[QLatin1String("mesh")].toInt()];
        const QJsonValue primitive = mesh[QLatin1String("primitives")][0];
        const QJsonValue attributes = primitive[QLatin1String("attributes")];
        QVERIFY(!attributes[QLatin1String("WEIGHTS_0")].isUndefined());
        // Where it is on the body, whose face looks toward +z by then.
        const glm::vec3 expected = avatarBody(*avatar).turn * bead().shape.centreHd;
        const QJsonValue positions = json[QLatin1String("accessors")][attributes[QLatin1String("POSITION")].toInt()];
        for (int axis = 0; axis < 3; ++axis) {
            const double middle = 0.5 * (positions[QLatin1String("min")][axis].toDouble() +
                                         positions[QLatin1String("max")][axis].toDouble());
            QVERIFY(std::abs(middle - static_cast<double>(expected[axis])) < 1e-4);
        }
        const QJsonValue material = json[QLatin1String("materials")][primitive[QLatin1String("material")].toInt()];
        QCOMPARE(material[QLatin1String("pbrMetallicRoughness")][QLatin1String("roughnessFactor")].toDouble(), 1.0);
    }

    void anOwnMeshIsHeldByTheHeadBone()
    {
        const auto mesh = std::make_shared<const sim::HeadMesh>(test::makeBallHead(8, 1.0F));
        OwnSurface surface{.part = {}, .mirrored = mesh};
        surface.part.colour = glm::vec3(1.0F);
        surface.part.mesh = mesh;
        OwnSurface textured = surface;
        textured.part.texture = std::make_shared<const sim::MeshTexture>(
            sim::MeshTexture{.width = 1, .height = 1, .rgba = {255, 0, 0, 255}});
        Worn worn = bead();
        worn.kind = WornKind::Mesh;
        worn.colour = 0xFF00FF00;
        worn.ownMesh.own = std::make_shared<const OwnMesh>(
            OwnMesh{.name = QStringLiteral("hat"), .entry = 0, .glb = "x", .surfaces = {surface, textured}});
        const QJsonObject json =
            exported(frameOf({hairGroup(1, 30'000, 65535, 0)}), mannequinAvatar(), {std::move(worn)});
        const QJsonArray nodes = json[QLatin1String("nodes")].toArray();
        const auto node = namedNode(nodes, QLatin1String("Worn mesh 9 part 1"));
        QVERIFY(node != nodes.end());
        const QJsonValue skin = json[QLatin1String("skins")][(*node)[QLatin1String("skin")].toInt()];
        QCOMPARE(skin[QLatin1String("name")].toString(), QStringLiteral("Body"));
        const QJsonValue primitive =
            json[QLatin1String("meshes")][(*node)[QLatin1String("mesh")].toInt()][QLatin1String("primitives")][0];
        const QJsonValue indices = json[QLatin1String("accessors")][primitive[QLatin1String("indices")].toInt()];
        QCOMPARE(indices[QLatin1String("count")].toInteger(), static_cast<qint64>(3 * mesh->triangles.size()));
        // Its inside may be seen.
        const QJsonValue material = json[QLatin1String("materials")][primitive[QLatin1String("material")].toInt()];
        QVERIFY(material[QLatin1String("doubleSided")].toBool());
        const QJsonValue factor = material[QLatin1String("pbrMetallicRoughness")][QLatin1String("baseColorFactor")];
        QVERIFY(factor[0].toDouble() < 0.01 && factor[1].toDouble() > 0.99);
        QVERIFY(material[QLatin1String("pbrMetallicRoughness")][QLatin1String("baseColorTexture")].isUndefined());
        // Its other part shows its picture, which is the file's last.
        const QJsonValue other = json[QLatin1String("materials")].toArray().last();
        QCOMPARE(other[QLatin1String("name")].toString(), QStringLiteral("Worn mesh 9 part 2"));
        const QJsonArray textures = json[QLatin1String("textures")].toArray();
        QCOMPARE(other[QLatin1String("pbrMetallicRoughness")][QLatin1String("baseColorTexture")][QLatin1String("index")]
                     .toInt(),
                 static_cast<int>(textures.size()) - 1);
    }

    void aBaldAvatarIsOneToo()
    {
        const QJsonObject json = exported(frameOf({hairGroup(1, 0, 65535, 0)}), mannequinAvatar());
        QVERIFY(json[QLatin1String("extensions")][QLatin1String("VRMC_vrm")].isObject());
        QVERIFY(!json[QLatin1String("extensions")][QLatin1String("VRMC_springBone")].isObject());
        QCOMPARE(json[QLatin1String("skins")].toArray().size(), qsizetype{1});
    }

    void theHeadsPoseIsNoPartOfIt()
    {
        const auto grownUnder = [](const sim::HeadPose& pose) {
            sim::GroomInput input;
            input.skin = std::make_shared<const sim::Skin>(test::makeBallHead());
            input.groups = {hairGroup(1, 30'000, 65535, 0)};
            sim::Simulation simulation;
            simulation.setInput(input);
            simulation.setPose(pose);
            simulation.reset();
            auto frame = std::make_shared<sim::StrandFrame>();
            simulation.writeFrame(*frame);
            return frame;
        };
        const auto boundsOf = [](const QJsonObject& json, const char* key) {
            const QJsonValue accessor = json[QLatin1String("meshes")][0][QLatin1String("primitives")][0]
                                            [QLatin1String("attributes")][QLatin1String("POSITION")];
            const QJsonArray numbers = json[QLatin1String("accessors")][accessor.toInt()][QLatin1String(key)].toArray();
            return glm::dvec3(numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble());
        };
        const auto turn = glm::angleAxis(0.6F, glm::vec3(0.0F, 1.0F, 0.0F));
        const QJsonObject still = exported(grownUnder({}), mannequinAvatar());
        const QJsonObject moved =
            exported(grownUnder({.rotation = turn, .positionWo = {1.0F, 2.0F, 3.0F}}), mannequinAvatar());
        for (const char* key : {"min", "max"})
            QVERIFY(glm::distance(boundsOf(still, key), boundsOf(moved, key)) < 0.01);
    }

    void theFaceLooksForward_data()
    {
        QTest::addColumn<int>("quarters");
        for (const int quarters : {0, 1, 2, 3})
            QTest::newRow(qPrintable(QString::number(quarters))) << quarters;
    }
    void theFaceLooksForward()
    {
        QFETCH(int, quarters);
        const auto avatar = mannequinAvatar();
        const Avatar turned = turnedAvatar(*avatar, 1.5707963F * static_cast<float>(quarters));
        const AvatarBody body = avatarBody(turned);
        QVERIFY(glm::distance(positionOf(turned, body, HumanBone::LeftHand), {kHandM, 1.4F, 0.0F}) < 1e-4F);
        const std::vector<glm::vec3>& own = avatar->skin->mesh().positionsHd;
        for (std::size_t i = 0; i < own.size(); ++i)
            QVERIFY(glm::distance(body.mesh.vertices[i].position, own[i]) < 1e-4F);
        if (quarters == 0) // Nothing of it is changed.
            for (std::size_t i = 0; i < own.size(); ++i)
                QVERIFY(body.mesh.vertices[i].position == own[i]);
    }

    void hangingArmsAreHeldOut()
    {
        const auto avatar = mannequinAvatar(0.8F);
        const AvatarBody body = avatarBody(*avatar);
        QVERIFY(glm::distance(positionOf(*avatar, body, HumanBone::LeftHand), {kHandM, 1.4F, 0.0F}) < 1e-4F);
        QVERIFY(glm::distance(positionOf(*avatar, body, HumanBone::RightHand), {-kHandM, 1.4F, 0.0F}) < 1e-4F);
        QVERIFY(glm::distance(positionOf(*avatar, body, HumanBone::LeftFoot), {0.1F, 0.08F, 0.0F}) < 1e-4F);
        // The skin comes along, and keeps its shape.
        const std::vector<glm::vec3>& own = avatar->skin->mesh().positionsHd;
        float reach = 0.0F;
        for (std::size_t i = 0; i < own.size(); ++i) {
            const HeadVertexOut& vertex = body.mesh.vertices[i];
            reach = std::max(reach, vertex.position.x);
            QVERIFY(std::abs(glm::length(vertex.normal) - 1.0F) < 1e-4F);
            const std::size_t other = i ^ 1U; // A neighbour in the same box, if the vertex is one of a box's.
            if (other < own.size() && avatar->skeleton.weights[i] == avatar->skeleton.weights[other])
                QVERIFY(std::abs(glm::distance(vertex.position, body.mesh.vertices[other].position) -
                                 glm::distance(own[i], own[other])) < 1e-4F);
        }
        QVERIFY(reach > 0.68F);
    }
};

HAIRPAINT_TEST(TestAvatarFile, Core)
#include "test_avatar_file.moc"
