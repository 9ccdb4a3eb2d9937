// A head's skeleton: its limits, its joints' positions, and head.glb and projects that hold it.
#include "model/exporting/avatar.h"
#include "model/files/glb.h"
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "tests/support/glb_json.h"
#include "tests/support/mannequin.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <limits>

using namespace hairpaint;
using namespace hairpaint::model;
using test::changeNode;
using test::withJson;

namespace {

bool isNear(const glm::vec3& a, const glm::vec3& b)
{
    return glm::distance(a, b) < 1e-5F;
}

} // namespace

class TestHeadSkeleton : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatIsNoSkeletonIsOutsideTheLimits_data()
    {
        QTest::addColumn<std::function<void(HeadSkeleton&)>>("spoil");
        using Spoil = std::function<void(HeadSkeleton&)>;
        const float nan = std::numeric_limits<float>::quiet_NaN();
        QTest::newRow("a second root") << Spoil([](auto& s) { s.joints[3].parent = -1; });
        QTest::newRow("a root with a parent") << Spoil([](auto& s) { s.joints[0].parent = 1; });
        QTest::newRow("a child before its parent") << Spoil([](auto& s) { s.joints[3].parent = 3; });
        QTest::newRow("no position") << Spoil([nan](auto& s) { s.joints[3].translation.y = nan; });
        QTest::newRow("a position light years away") << Spoil([](auto& s) { s.joints[3].translation.y = 1e20F; });
        QTest::newRow("a rotation of no length") << Spoil([](auto& s) { s.joints[3].rotation = {0, 0, 0, 0}; });
        QTest::newRow("a rotation that is no number") << Spoil([nan](auto& s) { s.joints[3].rotation.x = nan; });
        QTest::newRow("a line in its name") << Spoil([](auto& s) { s.joints[3].name = "a\nb"; });
        QTest::newRow("half a character") << Spoil([](auto& s) { s.joints[3].name = "\xC3"; });
        QTest::newRow("an endless name") << Spoil([](auto& s) { s.joints[3].name.assign(65, 'x'); });
        QTest::newRow("too many joints") << Spoil([](auto& s) { s.joints.resize(1025, {.name = {}, .parent = 0}); });
        QTest::newRow("a weight too few") << Spoil([](auto& s) { s.weights.pop_back(); });
        QTest::newRow("a weight of no joint") << Spoil([](auto& s) { s.weights[7].joints[3] = 21; });
        QTest::newRow("a negative weight") << Spoil([](auto& s) { s.weights[7].weights = {1.5F, -0.5F, 0, 0}; });
        QTest::newRow("weights of 2") << Spoil([](auto& s) { s.weights[7].weights = {1, 1, 0, 0}; });
        QTest::newRow("weights that are none") << Spoil([nan](auto& s) { s.weights[7].weights.x = nan; });
        QTest::newRow("weights without joints") << Spoil([](auto& s) { s.joints.clear(); });
    }
    void whatIsNoSkeletonIsOutsideTheLimits()
    {
        QFETCH(std::function<void(HeadSkeleton&)>, spoil);
        const RiggedMesh body = test::makeMannequin();
        RiggedMesh spoilt = body;
        QVERIFY(withinLimits(spoilt.skeleton, body.positionsHd.size()));
        spoil(spoilt.skeleton);
        QVERIFY(!withinLimits(spoilt.skeleton, body.positionsHd.size()));
        if (spoilt.skeleton.joints == body.skeleton.joints) // Others are not written.
            QVERIFY(!skeletonFromGlb(glbFromMesh(spoilt)));
    }

    void foreignNamesAreMended_data()
    {
        QTest::addColumn<QByteArray>("foreign");
        QTest::addColumn<QByteArray>("mended");
        QTest::newRow("plain") << QByteArray("Kopf ä") << QByteArray("Kopf ä");
        QTest::newRow("control characters") << QByteArray("a\tb\x7F") << QByteArray("a_b_");
        QTest::newRow("control characters of two bytes") << QByteArray("a\xC2\x85") << QByteArray("a_");
        QTest::newRow("Latin-1") << QByteArray("\xE4rm") << QByteArray("_rm");
        QTest::newRow("overlong") << QByteArray("\xC0\xAF") << QByteArray("__");
        QTest::newRow("a half of a pair") << QByteArray("\xED\xA0\x80") << QByteArray("___");
        QTest::newRow("beyond the last") << QByteArray("\xF5\x80\x80\x80") << QByteArray("____");
        QTest::newRow("four bytes") << QByteArray("\xF0\x9F\x98\x80") << QByteArray("\xF0\x9F\x98\x80");
        QTest::newRow("long") << QByteArray(63, 'x') + "ä" << QByteArray(63, 'x');
    }
    void foreignNamesAreMended()
    {
        QFETCH(QByteArray, foreign);
        QFETCH(QByteArray, mended);
        const std::string name = jointNameOf(foreign.toStdString());
        QCOMPARE(QByteArray::fromStdString(name), mended);
        QVERIFY(isJointName(name));
    }

    void posesComeBackFromTheJoints()
    {
        HeadSkeleton skeleton = test::makeMannequin().skeleton;
        std::vector<JointPose> poses = posesOf(skeleton);
        for (std::size_t i = 0; i < poses.size(); ++i) {
            QVERIFY(isNear(poses[i].position, test::kMannequin[i].position));
            poses[i].rotation = glm::angleAxis(0.3F * static_cast<float>(i), glm::normalize(glm::vec3(1, 2, 3)));
        }
        setPoses(skeleton, poses);
        const std::vector<JointPose> again = posesOf(skeleton);
        for (std::size_t i = 0; i < poses.size(); ++i) {
            QVERIFY(isNear(again[i].position, poses[i].position));
            QVERIFY(std::abs(glm::dot(again[i].rotation, poses[i].rotation)) > 0.9999F);
            const glm::vec3 own = glm::vec3(inverseBind(again[i]) * glm::vec4(again[i].position, 1.0F));
            QVERIFY(isNear(own, glm::vec3(0.0F)));
        }
    }

    void aSkeletonComesBackFromHeadGlb()
    {
        RiggedMesh body = test::makeMannequin(0.7F);
        body.skeleton.joints[4].rotation = glm::angleAxis(0.4F, glm::vec3(0.0F, 1.0F, 0.0F));
        body.skeleton.joints[5].name = "Kopf ä \"1\"";
        body.skeleton.weights[3] = {.joints = {5, 4, 0, 0}, .weights = {0.75F, 0.25F, 0.0F, 0.0F}};
        const QByteArray glb = glbFromMesh(body);
        const Checked<sim::HeadMesh> mesh = meshFromGlb(glb);
        QVERIFY(mesh && mesh->positionsHd == body.positionsHd && mesh->uvs == body.uvs);
        const Checked<HeadSkeleton> skeleton = skeletonFromGlb(glb);
        QVERIFY(skeleton);
        QVERIFY(*skeleton == body.skeleton);
        RiggedMesh again(*mesh);
        again.skeleton = *skeleton;
        QVERIFY(glbFromMesh(again) == glb);
    }

    void aMeshWithoutASkeletonIsWrittenAsEver()
    {
        const QByteArray glb = glbFromMesh(test::makeBallHead(8));
        QVERIFY(!glb.contains("skin") && !glb.contains("JOINTS_0"));
        const Checked<HeadSkeleton> skeleton = skeletonFromGlb(glb);
        QVERIFY(skeleton && skeleton->empty() && skeleton->weights.empty());
    }

    void aBrokenSkinIsRefused_data()
    {
        QTest::addColumn<std::function<void(QJsonObject&)>>("change");
        using Change = std::function<void(QJsonObject&)>;
        const auto row = [](const char* name, const Change& change) { QTest::newRow(name) << change; };
        row("a node that is not there", [](QJsonObject& json) {
            QJsonArray nodes = json[QLatin1String("nodes")].toArray();
            nodes.removeLast();
            json[QLatin1String("nodes")] = nodes;
        });
        row("a child that comes before",
            [](QJsonObject& json) { changeNode(json, 3, QStringLiteral("children"), QJsonArray{1}); });
        row("a child that is none", [](QJsonObject& json) {
            changeNode(json, 3, QStringLiteral("children"), QJsonArray{4, 5000});
        });
        row("no rotation", [](QJsonObject& json) { changeNode(json, 3, QStringLiteral("rotation"), QJsonArray{0}); });
        row("a rotation of words", [](QJsonObject& json) {
            changeNode(json, 3, QStringLiteral("rotation"), QJsonArray{0, 0, QStringLiteral("x"), 1});
        });
        row("two skins", [](QJsonObject& json) {
            const QJsonValue skin = json[QLatin1String("skins")][0];
            json[QLatin1String("skins")] = QJsonArray{skin, skin};
        });
        row("no joints", [](QJsonObject& json) { json[QLatin1String("skins")] = QJsonArray{QJsonObject{}}; });
        row("joints of another order", [](QJsonObject& json) {
            json[QLatin1String("skins")] = QJsonArray{QJsonObject{{QStringLiteral("joints"), QJsonArray{2, 1}}}};
        });
        row("no weights", [](QJsonObject& json) {
            QJsonObject mesh = json[QLatin1String("meshes")][0].toObject();
            QJsonObject primitive = mesh[QLatin1String("primitives")][0].toObject();
            QJsonObject attributes = primitive[QLatin1String("attributes")].toObject();
            attributes.remove(QLatin1String("WEIGHTS_0"));
            primitive[QLatin1String("attributes")] = attributes;
            mesh[QLatin1String("primitives")] = QJsonArray{primitive};
            json[QLatin1String("meshes")] = QJsonArray{mesh};
        });
    }
    void aBrokenSkinIsRefused()
    {
        QFETCH(std::function<void(QJsonObject&)>, change);
        const RiggedMesh body = test::makeMannequin();
        const QByteArray good = glbFromMesh(body);
        QVERIFY(skeletonFromGlb(withJson(good, [](QJsonObject&) {})));
        const QByteArray bad = withJson(good, change);
        QVERIFY(!skeletonFromGlb(bad));
        QVERIFY(!makeHead(QStringLiteral("body"), bad, 1.0F, UpAxis::Y));
    }

    void scaleAndAxisAreThoseOfTheMesh()
    {
        RiggedMesh body = test::makeMannequin();
        // As Blender has it, in centimetres.
        std::vector<JointPose> poses = posesOf(body.skeleton);
        for (JointPose& pose : poses)
            pose.position = 100.0F * glm::vec3(pose.position.x, -pose.position.z, pose.position.y);
        setPoses(body.skeleton, poses);
        for (glm::vec3& p : body.positionsHd)
            p = 100.0F * glm::vec3(p.x, -p.z, p.y);
        for (glm::vec3& n : body.normalsHd)
            n = glm::vec3(n.x, -n.z, n.y);
        // A body of 1.7 m, and no head of 17 cm.
        const HeadGuess guess = guessHead(body);
        QCOMPARE(guess.unitScale, 0.01F);
        QVERIFY(guess.upAxis == UpAxis::Z);
        QCOMPARE(guessHead(sim::HeadMesh(body)).unitScale, 0.01F); // It is as slender without its joints.
        const auto head = makeHead(QStringLiteral("body"), glbFromMesh(body), 0.01F, UpAxis::Z);
        QVERIFY(head);
        const Checked<HeadSkeleton> skeleton = skeletonOf(**head);
        QVERIFY(skeleton && withinLimits(*skeleton, body.positionsHd.size()));
        const std::vector<JointPose> found = posesOf(*skeleton);
        for (std::size_t i = 0; i < found.size(); ++i)
            QVERIFY(isNear(found[i].position, test::kMannequin[i].position));
        // What pointed up in the file still does.
        QVERIFY(isNear(found[0].rotation * glm::vec3(0.0F, 0.0F, 1.0F), glm::vec3(0.0F, 1.0F, 0.0F)));
    }

    void aProjectKeepsIt()
    {
        const QTemporaryDir folder;
        const RiggedMesh body = test::makeMannequin();
        Project project = newProject();
        project.head = *makeHead(QStringLiteral("body"), glbFromMesh(body), 1.0F, UpAxis::Y);
        const QString path = folder.filePath(QStringLiteral("body.hairpaint"));
        QVERIFY(saveProject(project, path, {}));
        const Result<Project> back = loadProject(path);
        QVERIFY(back);
        QVERIFY(*skeletonOf(*back->head) == body.skeleton);
        const auto avatar = avatarOf(*back->head, QStringLiteral("  Ann\n of Body "), {});
        QVERIFY(avatar);
        QCOMPARE((*avatar)->name, QStringLiteral("Ann of Body"));
        QCOMPARE((*avatar)->author, QStringLiteral("Unknown"));
        QCOMPARE((*avatar)->bones[HumanBone::Head], test::kMannequinHead);
        QVERIFY(!avatarOf(*newProject().head, {}, {}));
    }
};

HAIRPAINT_TEST(TestHeadSkeleton, Core)
#include "test_head_skeleton.moc"
