// Skinned bodies through the real helper.
#include "model/files/glb_writing.h"
#include "model/files/importer_client.h"
#include "model/heads/humanoid_bones.h"
#include "tests/model/archive_maker.h"
#include "tests/support/glb_json.h"
#include "tests/support/locations.h"
#include "tests/support/mannequin.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;
using test::addNode;
using test::changeNode;
using test::withJson;

namespace {

constexpr int kFirstJoint = 1; // Index of the first joint among a head.glb's nodes.

/// The name of a joint of the mannequin that is missing or misplaced, and how; empty where all are right.
QString strayJoint(const HeadSkeleton& skeleton, float scale = 1.0F)
{
    const std::vector<JointPose> poses = posesOf(skeleton);
    for (const test::MannequinJoint& wanted : test::kMannequin) {
        const auto found = std::ranges::find(skeleton.joints, std::string(wanted.name), &HeadJoint::name);
        if (found == skeleton.joints.end())
            return QStringLiteral("%1 is missing").arg(QLatin1StringView(wanted.name));
        const glm::vec3 at = poses[static_cast<std::size_t>(found - skeleton.joints.begin())].position;
        if (glm::distance(at, scale * wanted.position) > 1e-4F * scale)
            return QStringLiteral("%1 is at %2 %3 %4")
                .arg(QLatin1StringView(wanted.name))
                .arg(at.x)
                .arg(at.y)
                .arg(at.z);
    }
    return {};
}

/// The joint that the vertex nearest to a position follows most.
QString followedAt(const RiggedMesh& mesh, const glm::vec3& positionHd)
{
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < mesh.positionsHd.size(); ++i)
        if (glm::distance(mesh.positionsHd[i], positionHd) < glm::distance(mesh.positionsHd[nearest], positionHd))
            nearest = i;
    return QString::fromStdString(mesh.skeleton.joints[mesh.skeleton.weights[nearest].joints[0]].name);
}

void addToScene(QJsonObject& json, const QJsonArray& nodes)
{
    json[QLatin1String("scenes")] = QJsonArray{QJsonObject{{QStringLiteral("nodes"), nodes}}};
}

} // namespace

class TestImportSkeleton : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    ImporterClient m_client{test::importProgram(), 60'000};

    [[nodiscard]] Result<RiggedMesh> read(const QByteArray& glb, const char* name = "body.glb")
    {
        const QString path = m_folder.filePath(QString::fromLatin1(name));
        test::writeBytes(path, glb);
        return m_client.readMesh(path);
    }

private Q_SLOTS:
    void jointsAndWeightsComeAlong_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("glTF") << QByteArray("body.glb");
        QTest::newRow("VRM, which is one") << QByteArray("body.vrm");
        QTest::newRow("VRM in capitals") << QByteArray("BODY.VRM");
    }
    void jointsAndWeightsComeAlong()
    {
        QFETCH(QByteArray, name);
        RiggedMesh body = test::makeMannequin();
        // Its crown follows the neck a little.
        const auto crown = static_cast<std::size_t>(std::ranges::max_element(body.positionsHd, {}, &glm::vec3::y) -
                                                    body.positionsHd.begin());
        for (std::size_t i = 0; i < body.positionsHd.size(); ++i)
            if (glm::distance(body.positionsHd[i], body.positionsHd[crown]) < 1e-5F)
                body.skeleton.weights[i] = {.joints = {4, 5, 0, 0}, .weights = {0.25F, 0.75F, 0.0F, 0.0F}};
        const Result<RiggedMesh> mesh = read(glbFromMesh(body), name.constData());
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        QCOMPARE(mesh->skeleton.joints.size(), test::kMannequin.size());
        QCOMPARE(strayJoint(mesh->skeleton), QString());
        QVERIFY(humanoidBones(mesh->skeleton.joints));
        QCOMPARE(mesh->skeleton.weights.size(), mesh->positionsHd.size());
        QCOMPARE(followedAt(*mesh, {0.1F, 0.1F, 0.0F}), QStringLiteral("mixamorig:LeftLeg"));
        QCOMPARE(followedAt(*mesh, {0.0F, 1.6F, 0.15F}), QStringLiteral("mixamorig:Head"));
        const auto top = static_cast<std::size_t>(std::ranges::max_element(mesh->positionsHd, {}, &glm::vec3::y) -
                                                  mesh->positionsHd.begin());
        const BoneWeights& weights = mesh->skeleton.weights[top]; // The heaviest first.
        QCOMPARE(mesh->skeleton.joints[weights.joints[0]].name, std::string("mixamorig:Head"));
        QCOMPARE(mesh->skeleton.joints[weights.joints[1]].name, std::string("mixamorig:Neck"));
        QVERIFY(std::abs(weights.weights.y - 0.25F) < 1e-5F);
    }

    void aSkinnedMeshStandsWhereItsJointsPutIt()
    {
        // Its own node's transform is not minded; the armature's is, centimetres in metres.
        const QByteArray glb = withJson(glbFromMesh(test::makeMannequin()), [](QJsonObject& json) {
            changeNode(json, 0, QStringLiteral("translation"), QJsonArray{3, 2, 1});
            const int armature = addNode(json, {{QStringLiteral("name"), QStringLiteral("Armature")},
                                                {QStringLiteral("scale"), QJsonArray{0.01, 0.01, 0.01}},
                                                {QStringLiteral("children"), QJsonArray{0, kFirstJoint}}});
            addToScene(json, {armature});
        });
        const Result<RiggedMesh> mesh = read(glb);
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        QCOMPARE(strayJoint(mesh->skeleton, 0.01F), QString());
        const auto highest = std::ranges::max_element(mesh->positionsHd, {}, &glm::vec3::y);
        QVERIFY(std::abs(highest->y - 0.0174F) < 1e-5F && std::abs(highest->x) < 1e-5F);
    }

    void aMeshUnderAJointFollowsIt()
    {
        // The body once more, small, as a hat.
        const QByteArray glb = withJson(glbFromMesh(test::makeMannequin()), [](QJsonObject& json) {
            const int hat = addNode(json, {{QStringLiteral("mesh"), 0},
                                           {QStringLiteral("scale"), QJsonArray{0.1, 0.1, 0.1}},
                                           {QStringLiteral("translation"), QJsonArray{0, 0.3, 0}}});
            const int head = kFirstJoint + test::kMannequinHead;
            QJsonArray children = json[QLatin1String("nodes")][head][QLatin1String("children")].toArray();
            children.append(hat);
            changeNode(json, head, QStringLiteral("children"), children);
        });
        const Result<RiggedMesh> mesh = read(glb);
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        QCOMPARE(mesh->skeleton.joints.size(), test::kMannequin.size());
        QCOMPARE(followedAt(*mesh, {0.0F, 1.81F, 0.0F}), QStringLiteral("mixamorig:Head")); // The hat's foot.
    }

    void foreignNamesAreMended()
    {
        const QByteArray glb = withJson(glbFromMesh(test::makeMannequin()), [](QJsonObject& json) {
            changeNode(json, kFirstJoint + test::kMannequinHead, QStringLiteral("name"),
                       QStringLiteral("a\tb") + QString(100, QLatin1Char('x')));
        });
        const Result<RiggedMesh> mesh = read(glb);
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        const bool isThere = std::ranges::any_of(
            mesh->skeleton.joints, [](const HeadJoint& joint) { return joint.name == "a_b" + std::string(61, 'x'); });
        QVERIFY(isThere);
    }

    void theBonesThatAVrmNamesAreTakenAtItsWord_data()
    {
        QTest::addColumn<bool>("isOld");
        QTest::addColumn<int>("twins");
        QTest::newRow("VRM 1.0") << false << 0;
        QTest::newRow("VRM 0.x") << true << 0;
        QTest::newRow("two nodes of one name") << false << 1;
    }
    void theBonesThatAVrmNamesAreTakenAtItsWord()
    {
        QFETCH(bool, isOld);
        QFETCH(int, twins);
        const RiggedMesh body = test::makeMannequin();
        const HumanoidBones known = *humanoidBones(body.skeleton.joints);
        const QByteArray glb = withJson(glbFromMesh(body), [&](QJsonObject& json) {
            QJsonObject now;
            QJsonArray before;
            for (std::size_t bone = 0; bone < kHumanBoneCount; ++bone) {
                if (known.joints.at(bone) < 0)
                    continue;
                const QString id = QLatin1StringView(humanBoneSpec(static_cast<HumanBone>(bone)).id);
                const int node = kFirstJoint + known.joints.at(bone);
                now[id] = QJsonObject{{QStringLiteral("node"), node}};
                before.append(QJsonObject{{QStringLiteral("bone"), id}, {QStringLiteral("node"), node}});
            }
            for (std::size_t i = 0; i < test::kMannequin.size(); ++i)
                changeNode(json, kFirstJoint + static_cast<int>(i), QStringLiteral("name"),
                           QStringLiteral("骨%1").arg(i));
            if (twins > 0)
                addNode(json, {{QStringLiteral("name"), QStringLiteral("骨5")}});
            json[QLatin1String("extensions")] =
                isOld ? QJsonObject{{QStringLiteral("VRM"),
                                     QJsonObject{{QStringLiteral("humanoid"),
                                                  QJsonObject{{QStringLiteral("humanBones"), before}}}}}}
                      : QJsonObject{{QStringLiteral("VRMC_vrm"),
                                     QJsonObject{{QStringLiteral("humanoid"),
                                                  QJsonObject{{QStringLiteral("humanBones"), now}}}}}};
        });
        const Result<RiggedMesh> mesh = read(glb, "body.vrm");
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        const Checked<HumanoidBones> bones = humanoidBones(mesh->skeleton.joints);
        QVERIFY(bones.has_value()); // A node is told by its number.
        const std::vector<JointPose> poses = posesOf(mesh->skeleton);
        for (std::size_t bone = 0; bone < kHumanBoneCount; ++bone) {
            QCOMPARE(bones->joints.at(bone) < 0, known.joints.at(bone) < 0);
            if (known.joints.at(bone) < 0)
                continue;
            const glm::vec3 at = poses[static_cast<std::size_t>(bones->joints.at(bone))].position;
            glm::vec3 wanted = test::kMannequin.at(static_cast<std::size_t>(known.joints.at(bone))).position;
            if (isOld) // It looks the other way.
                wanted = glm::vec3(-wanted.x, wanted.y, -wanted.z);
            QVERIFY2(glm::distance(at, wanted) < 1e-4F, humanBoneSpec(static_cast<HumanBone>(bone)).id);
        }
    }

    void aVrmThatNamesNonsenseHasItsOwnNames_data()
    {
        QTest::addColumn<QJsonValue>("bones");
        QTest::newRow("no object") << QJsonValue(3);
        QTest::newRow("no nodes") << QJsonValue(QJsonObject{{QStringLiteral("head"), 4}});
        QTest::newRow("nodes that are not there")
            << QJsonValue(QJsonObject{{QStringLiteral("head"), QJsonObject{{QStringLiteral("node"), 4'000}}},
                                      {QStringLiteral("hips"), QJsonObject{{QStringLiteral("node"), -1}}}});
    }
    void aVrmThatNamesNonsenseHasItsOwnNames()
    {
        QFETCH(QJsonValue, bones);
        const QByteArray glb = withJson(glbFromMesh(test::makeMannequin()), [&bones](QJsonObject& json) {
            json[QLatin1String("extensions")] = QJsonObject{
                {QStringLiteral("VRMC_vrm"),
                 QJsonObject{{QStringLiteral("humanoid"), QJsonObject{{QStringLiteral("humanBones"), bones}}}}}};
        });
        const Result<RiggedMesh> mesh = read(glb, "body.vrm");
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        QCOMPARE(strayJoint(mesh->skeleton), QString());
    }

    void severalRootsGetOne()
    {
        const QByteArray glb = withJson(glbFromMesh(test::makeMannequin()), [](QJsonObject& json) {
            // The left leg stands on its own.
            QJsonArray children = json[QLatin1String("nodes")][kFirstJoint][QLatin1String("children")].toArray();
            children.removeAt(1);
            changeNode(json, kFirstJoint, QStringLiteral("children"), children);
            changeNode(json, kFirstJoint + 14, QStringLiteral("translation"), QJsonArray{0.1, 0.9, 0});
            addToScene(json, {0, kFirstJoint, kFirstJoint + 14});
        });
        const Result<RiggedMesh> mesh = read(glb);
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        QCOMPARE(mesh->skeleton.joints.size(), test::kMannequin.size() + 1);
        QCOMPARE(strayJoint(mesh->skeleton), QString());
    }

    void tooManyNodesLeaveTheBones_data()
    {
        QTest::addColumn<bool>("areBones");
        QTest::newRow("others than bones") << false;
        QTest::newRow("bones, which are too many") << true;
    }
    void tooManyNodesLeaveTheBones()
    {
        QFETCH(bool, areBones);
        constexpr int kMore = 1100;
        RiggedMesh body = test::makeMannequin();
        for (int i = 0; areBones && i < kMore; ++i)
            body.skeleton.joints.push_back({.name = "more " + std::to_string(i), .parent = 0});
        const QByteArray glb = withJson(glbFromMesh(body), [areBones](QJsonObject& json) {
            QJsonArray children = json[QLatin1String("nodes")][kFirstJoint][QLatin1String("children")].toArray();
            for (int i = 0; !areBones && i < kMore; ++i)
                children.append(addNode(json, {{QStringLiteral("name"), QStringLiteral("more %1").arg(i)}}));
            changeNode(json, kFirstJoint, QStringLiteral("children"), children);
        });
        const Result<RiggedMesh> mesh = read(glb);
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        QCOMPARE(mesh->skeleton.joints.size(), areBones ? std::size_t{0} : test::kMannequin.size());
        QCOMPARE(mesh->skeleton.weights.size(), areBones ? std::size_t{0} : mesh->positionsHd.size());
    }

    void aBindMatrixOfNothingIsNoBind()
    {
        const QByteArray good = glbFromMesh(test::makeMannequin());
        const QByteArray glb = withJson(good, [](QJsonObject& json) {
            for (int i = 0; i < 3; ++i)
                changeNode(json, kFirstJoint + 3 + i, QStringLiteral("scale"), QJsonArray{0, 0, 0});
        });
        const Result<RiggedMesh> mesh = read(glb);
        QVERIFY2(mesh, mesh ? "" : qPrintable(mesh.error().message));
        QCOMPARE(strayJoint(mesh->skeleton), QString()); // The bind tells.
    }

    void aMeshWithoutSkinHasNoSkeleton()
    {
        const Result<RiggedMesh> mesh = read(glbFromMesh(test::makeBallHead(8)));
        QVERIFY(mesh && mesh->skeleton.empty() && mesh->skeleton.weights.empty());
    }
};

HAIRPAINT_TEST(TestImportSkeleton, Core)
#include "test_import_skeleton.moc"
