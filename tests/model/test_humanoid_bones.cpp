// Which joints are which bones, by the names that programs give them.
#include "model/heads/humanoid_bones.h"
#include "model/heads/joint_names.h"
#include "tests/support/mannequin.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <map>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// A line a joint, "name < parent", parents before their children.
std::vector<HeadJoint> jointsOf(const QString& lines)
{
    std::vector<HeadJoint> joints;
    const QStringList rows = lines.split(QLatin1Char(';'), Qt::SkipEmptyParts);
    for (const QString& row : rows) {
        const QStringList names = row.split(QLatin1Char('<'));
        const std::string parent = names.value(1).trimmed().toStdString();
        HeadJoint joint{.name = names[0].trimmed().toStdString()};
        for (std::size_t i = 0; i < joints.size(); ++i)
            if (joints[i].name == parent)
                joint.parent = static_cast<int>(i);
        joints.push_back(joint);
    }
    return joints;
}

/// Both sides: what stands between % is one for the left and one for the right.
QString bothSides(const QString& lines, const QString& left, const QString& right)
{
    QString both;
    const QStringList rows = lines.split(QLatin1Char(';'), Qt::SkipEmptyParts);
    for (const QString& row : rows) {
        if (!row.contains(QLatin1Char('%'))) {
            both += row + QLatin1Char(';');
            continue;
        }
        both += QString(row).replace(QLatin1Char('%'), left) + QLatin1Char(';');
        both += QString(row).replace(QLatin1Char('%'), right) + QLatin1Char(';');
    }
    return both;
}

} // namespace

class TestHumanoidBones : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void namesTellOfPartAndSide_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("part");
        QTest::addColumn<int>("side");
        const auto row = [](const char* name, const char* part, BodySide side) {
            QTest::newRow(name) << QString::fromLatin1(name) << QString::fromLatin1(part) << static_cast<int>(side);
        };
        row("mixamorig:LeftForeArm", "forearm", BodySide::Left);
        row("mixamorig_RightForeArm", "forearm", BodySide::Right);
        row("lowerarm_l", "lowerarm", BodySide::Left);
        row("DEF-upper_arm.R", "upperarm", BodySide::Right);
        row("J_Bip_C_Hips", "hips", BodySide::Middle);
        row("J_Bip_L_UpperArm", "upperarm", BodySide::Left);
        row("Bip01 R Calf", "calf", BodySide::Right);
        row("CC_Base_L_Thigh", "thigh", BodySide::Left);
        row("lShldrBend", "shldrbend", BodySide::Left);
        row("leftUpperArm", "upperarm", BodySide::Left);
        row("rightarm", "arm", BodySide::Right);
        row("spine_03", "spine", BodySide::Middle);
        row("HeadTop_End", "headtopend", BodySide::Middle);
        row("", "", BodySide::Middle);
        row(":", "", BodySide::Middle);
    }
    void namesTellOfPartAndSide()
    {
        QFETCH(QString, name);
        QFETCH(QString, part);
        QFETCH(int, side);
        const JointName read = readJointName(name.toStdString());
        QCOMPARE(QString::fromStdString(read.part), part);
        QCOMPARE(static_cast<int>(read.side), side);
    }

    void skeletonsOfProgramsAreKnown_data()
    {
        QTest::addColumn<QString>("joints");
        QTest::addColumn<QString>("bones"); ///< "vrm=joint", a few.
        const auto row = [](const char* name, const QString& joints, const char* bones) {
            QTest::newRow(name) << joints << QString::fromLatin1(bones);
        };
        row("VRM's own names",
            bothSides(QStringLiteral("hips;spine<hips;chest<spine;upperChest<chest;neck<upperChest;head<neck;"
                                     "%Eye<head;%Shoulder<upperChest;%UpperArm<%Shoulder;%LowerArm<%UpperArm;"
                                     "%Hand<%LowerArm;%UpperLeg<hips;%LowerLeg<%UpperLeg;%Foot<%LowerLeg;%Toes<%Foot"),
                      QStringLiteral("left"), QStringLiteral("right")),
            "chest=chest upperChest=upperChest neck=neck leftEye=leftEye rightToes=rightToes "
            "leftShoulder=leftShoulder");
        row("Mixamo",
            bothSides(QStringLiteral(
                          "mixamorig:Hips;mixamorig:Spine<mixamorig:Hips;mixamorig:Spine1<mixamorig:Spine;"
                          "mixamorig:Spine2<mixamorig:Spine1;mixamorig:Neck<mixamorig:Spine2;"
                          "mixamorig:Head<mixamorig:Neck;mixamorig:HeadTop_End<mixamorig:Head;"
                          "mixamorig:%Shoulder<mixamorig:Spine2;mixamorig:%Arm<mixamorig:%Shoulder;"
                          "mixamorig:%ForeArm<mixamorig:%Arm;mixamorig:%Hand<mixamorig:%ForeArm;"
                          "mixamorig:%HandThumb1<mixamorig:%Hand;mixamorig:%HandThumb2<mixamorig:%HandThumb1;"
                          "mixamorig:%HandThumb3<mixamorig:%HandThumb2;mixamorig:%HandThumb4<mixamorig:%HandThumb3;"
                          "mixamorig:%HandIndex1<mixamorig:%Hand;mixamorig:%HandIndex2<mixamorig:%HandIndex1;"
                          "mixamorig:%UpLeg<mixamorig:Hips;mixamorig:%Leg<mixamorig:%UpLeg;"
                          "mixamorig:%Foot<mixamorig:%Leg;mixamorig:%ToeBase<mixamorig:%Foot;"
                          "mixamorig:%Toe_End<mixamorig:%ToeBase"),
                      QStringLiteral("Left"), QStringLiteral("Right")),
            "hips=mixamorig:Hips spine=mixamorig:Spine chest=mixamorig:Spine1 upperChest=mixamorig:Spine2 "
            "leftUpperArm=mixamorig:LeftArm rightLowerLeg=mixamorig:RightLeg leftShoulder=mixamorig:LeftShoulder "
            "leftToes=mixamorig:LeftToeBase leftThumbMetacarpal=mixamorig:LeftHandThumb1 "
            "rightThumbDistal=mixamorig:RightHandThumb3 leftIndexIntermediate=mixamorig:LeftHandIndex2 "
            "leftIndexDistal=");
        row("Unreal's mannequin",
            bothSides(QStringLiteral("root;pelvis<root;spine_01<pelvis;spine_02<spine_01;spine_03<spine_02;"
                                     "spine_04<spine_03;spine_05<spine_04;neck_01<spine_05;neck_02<neck_01;"
                                     "head<neck_02;clavicle_%<spine_05;upperarm_%<clavicle_%;"
                                     "upperarm_twist_01_%<upperarm_%;lowerarm_%<upperarm_%;hand_%<lowerarm_%;"
                                     "index_metacarpal_%<hand_%;index_01_%<index_metacarpal_%;index_02_%<index_01_%;"
                                     "index_03_%<index_02_%;pinky_01_%<hand_%;thigh_%<pelvis;calf_%<thigh_%;"
                                     "calf_twist_01_%<calf_%;foot_%<calf_%;ball_%<foot_%;ik_foot_root<root;"
                                     "ik_foot_%<ik_foot_root"),
                      QStringLiteral("l"), QStringLiteral("r")),
            "hips=pelvis spine=spine_01 chest=spine_03 upperChest=spine_05 neck=neck_01 head=head "
            "leftShoulder=clavicle_l leftIndexProximal=index_01_l rightIndexDistal=index_03_r "
            "leftLittleProximal=pinky_01_l leftFoot=foot_l rightToes=ball_r");
        row("Blender's metarig",
            bothSides(QStringLiteral("spine;spine.001<spine;spine.002<spine.001;spine.003<spine.002;"
                                     "spine.004<spine.003;spine.005<spine.004;spine.006<spine.005;pelvis.%<spine;"
                                     "shoulder.%<spine.003;upper_arm.%<shoulder.%;forearm.%<upper_arm.%;"
                                     "hand.%<forearm.%;palm.01.%<hand.%;f_index.01.%<palm.01.%;"
                                     "f_index.02.%<f_index.01.%;thigh.%<spine;shin.%<thigh.%;foot.%<shin.%;"
                                     "toe.%<foot.%;heel.02.%<foot.%;breast.%<spine.003"),
                      QStringLiteral("L"), QStringLiteral("R")),
            "hips=spine spine=spine.001 chest=spine.002 upperChest=spine.003 neck=spine.004 head=spine.006 "
            "leftShoulder=shoulder.L leftIndexProximal=f_index.01.L rightToes=toe.R");
        row("VRoid and Unity",
            bothSides(QStringLiteral("Root;J_Bip_C_Hips<Root;J_Bip_C_Spine<J_Bip_C_Hips;J_Bip_C_Chest<J_Bip_C_Spine;"
                                     "J_Bip_C_UpperChest<J_Bip_C_Chest;J_Bip_C_Neck<J_Bip_C_UpperChest;"
                                     "J_Bip_C_Head<J_Bip_C_Neck;J_Adj_%_FaceEye<J_Bip_C_Head;"
                                     "J_Bip_%_Shoulder<J_Bip_C_UpperChest;J_Bip_%_UpperArm<J_Bip_%_Shoulder;"
                                     "J_Bip_%_LowerArm<J_Bip_%_UpperArm;J_Bip_%_Hand<J_Bip_%_LowerArm;"
                                     "J_Bip_%_Little1<J_Bip_%_Hand;J_Bip_%_UpperLeg<J_Bip_C_Hips;"
                                     "J_Bip_%_LowerLeg<J_Bip_%_UpperLeg;J_Bip_%_Foot<J_Bip_%_LowerLeg;"
                                     "J_Bip_%_ToeBase<J_Bip_%_Foot"),
                      QStringLiteral("L"), QStringLiteral("R")),
            "hips=J_Bip_C_Hips upperChest=J_Bip_C_UpperChest leftEye=J_Adj_L_FaceEye "
            "rightLittleProximal=J_Bip_R_Little1 leftToes=J_Bip_L_ToeBase");
        row("3ds Max' Biped, with legs under its spine",
            bothSides(QStringLiteral("Bip01;Bip01 Pelvis<Bip01;Bip01 Spine<Bip01 Pelvis;Bip01 % Thigh<Bip01 Spine;"
                                     "Bip01 % Calf<Bip01 % Thigh;Bip01 % Foot<Bip01 % Calf;Bip01 % Toe0<Bip01 % Foot;"
                                     "Bip01 Spine1<Bip01 Spine;Bip01 Neck<Bip01 Spine1;Bip01 Head<Bip01 Neck;"
                                     "Bip01 % Clavicle<Bip01 Spine1;Bip01 % UpperArm<Bip01 % Clavicle;"
                                     "Bip01 % Forearm<Bip01 % UpperArm;Bip01 % Hand<Bip01 % Forearm"),
                      QStringLiteral("L"), QStringLiteral("R")),
            "hips=Bip01|Pelvis spine=Bip01|Spine1 chest= neck=Bip01|Neck leftShoulder=Bip01|L|Clavicle");
        row("Collada, with the armature's name before each",
            bothSides(QStringLiteral("Figure;Figure_hips<Figure;Figure_spine<Figure_hips;Figure_chest<Figure_spine;"
                                     "Figure_head<Figure_chest;Figure_arm_%<Figure_chest;"
                                     "Figure_forearm_%<Figure_arm_%;Figure_hand_%<Figure_forearm_%;"
                                     "Figure_thigh_%<Figure_hips;Figure_shin_%<Figure_thigh_%;"
                                     "Figure_foot_%<Figure_shin_%"),
                      QStringLiteral("L"), QStringLiteral("R")),
            "hips=Figure_hips head=Figure_head leftUpperArm=Figure_arm_L neck=");
        row("a generic one",
            bothSides(QStringLiteral("Hips;Spine<Hips;Chest<Spine;Neck<Chest;Head<Neck;%UpArm<Chest;%Arm<%UpArm;"
                                     "%Hand<%Arm;%UpLeg<Hips;%Leg<%UpLeg;%Foot<%Leg"),
                      QStringLiteral("Left"), QStringLiteral("Right")),
            "leftUpperArm=LeftUpArm leftLowerArm=LeftArm leftShoulder= spine=Spine chest=Chest upperChest=");
        row("motion capture's",
            bothSides(QStringLiteral("Hips;%Hip<Hips;%Knee<%Hip;%Ankle<%Knee;%Toe<%Ankle;Chest<Hips;Neck<Chest;"
                                     "Head<Neck;%Collar<Chest;%Shoulder<%Collar;%Elbow<%Shoulder;%Wrist<%Elbow"),
                      QStringLiteral("Left"), QStringLiteral("Right")),
            "leftUpperArm=LeftShoulder leftShoulder=LeftCollar rightUpperLeg=RightHip rightFoot=RightAnkle "
            "spine=Chest");
    }
    void skeletonsOfProgramsAreKnown()
    {
        QFETCH(QString, joints);
        QFETCH(QString, bones);
        const std::vector<HeadJoint> skeleton = jointsOf(joints);
        const Checked<HumanoidBones> found = humanoidBones(skeleton);
        QVERIFY2(found, found ? "" : qPrintable(found.error().text));
        QStringList named;
        for (std::size_t i = 0; i < kHumanBoneCount; ++i) {
            const auto bone = static_cast<HumanBone>(i);
            const int joint = (*found)[bone];
            QVERIFY(joint >= 0 || !humanBoneSpec(bone).required);
            named += QLatin1StringView(humanBoneSpec(bone).id) + QLatin1Char('=') +
                     (joint < 0 ? QString() : QString::fromStdString(skeleton[static_cast<std::size_t>(joint)].name));
        }
        const QStringList wanted = bones.split(QLatin1Char(' '));
        for (QString pair : wanted) {
            pair.replace(QLatin1Char('|'), QLatin1Char(' '));
            QVERIFY2(named.contains(pair),
                     qPrintable(pair + QStringLiteral(" is not in ") + named.join(QLatin1Char(' '))));
        }
        // No joint is two bones.
        std::map<int, int> uses;
        for (const int joint : found->joints)
            QVERIFY(joint < 0 || ++uses[joint] == 1);
    }

    void bonesOfTheRightAreThoseOfTheLeft()
    {
        for (int i = 0; i < static_cast<int>(HumanBone::Count); ++i) {
            const QString id = QLatin1StringView(humanBoneSpec(static_cast<HumanBone>(i)).id);
            const QString parent = QLatin1StringView(humanBoneSpec(humanBoneSpec(static_cast<HumanBone>(i)).parent).id);
            QVERIFY(!id.startsWith(QLatin1String("right")) || !parent.startsWith(QLatin1String("left")));
            QVERIFY(!id.startsWith(QLatin1String("left")) || !parent.startsWith(QLatin1String("right")));
        }
        QCOMPARE(humanBoneSpec(HumanBone::RightLittleDistal).id, "rightLittleDistal");
        QCOMPARE(humanBoneSpec(humanBoneSpec(HumanBone::RightHand).parent).id, "rightLowerArm");
        QCOMPARE(humanBoneSpec(humanBoneSpec(HumanBone::RightEye).parent).id, "head");
    }

    void whatIsMissingIsNamed()
    {
        const Checked<HumanoidBones> none = humanoidBones({});
        QVERIFY(!none && none.error().text.contains(QLatin1String("skeleton")));
        std::vector<HeadJoint> joints = test::makeMannequin().skeleton.joints;
        QVERIFY(humanoidBones(joints));
        joints[9].name = "claw";  // The left hand.
        joints[19].name = "hoof"; // The right foot.
        const Checked<HumanoidBones> found = humanoidBones(joints);
        QVERIFY(!found);
        QVERIFY2(found.error().text.contains(QLatin1String(": leftHand, rightFoot; ")), qPrintable(found.error().text));
    }

    void aLimbThatHangsFromAnotherIsNone()
    {
        std::vector<HeadJoint> joints = test::makeMannequin().skeleton.joints;
        joints[14].parent = 9; // A leg on a hand.
        QVERIFY(!humanoidBones(joints));
    }
};

HAIRPAINT_TEST(TestHumanoidBones, Core)
#include "test_humanoid_bones.moc"
