// Shoulders stay in the world while the head turns: hair meets them there.
#include "sim/motion/group_dynamics.h"
#include "sim/motion/head_motion.h"
#include "sim/motion/simulation.h"
#include "sim/motion/wind_field.h"
#include "tests/support/hand_made_groom.h"
#include "tests/support/painted_ball.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr float kBallM = 0.1F;

/// All of a ball about the origin is shoulders; the neck stands beside it.
Neck neckBesideTheBall()
{
    return {.pivotHd = {0.25F, 0.0F, 0.0F}, .headY = 0.2F, .shouldersY = 0.15F};
}

HeadPose turnedAbout(const Neck& neck, float radians)
{
    HeadPose pose;
    pose.rotation = glm::angleAxis(radians, glm::vec3(0.0F, 1.0F, 0.0F));
    pose.positionWo = neck.pivotHd - pose.rotation * neck.pivotHd;
    return pose;
}

/// Strands that hang from above over a square of the world around the ball, told in the frame of the turned head.
std::vector<HandStrand> strandsOver(const HeadPose& pose)
{
    std::vector<HandStrand> strands;
    for (int x = -6; x <= 6; ++x)
        for (int z = -6; z <= 6; ++z) {
            const glm::vec3 rootWo(0.018F * static_cast<float>(x) + 0.003F, 0.25F, 0.018F * static_cast<float>(z));
            strands.push_back({.rootHd = glm::conjugate(pose.rotation) * (rootWo - pose.positionWo),
                               .directionHd = {0.0F, -1.0F, 0.0F},
                               .lengthM = 0.35F});
        }
    return strands;
}

} // namespace

class TestShoulders : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hairStaysOutsideThemInTheWorld_data();
    void hairStaysOutsideThemInTheWorld();
    void hairOnThemTurnsThemAlong();
    void aStraightHeadIsNotTurned();
    void theyBeginBelowTheChin();
};

void TestShoulders::hairStaysOutsideThemInTheWorld_data()
{
    QTest::addColumn<bool>("asSkin");
    QTest::newRow("skin") << true;
    QTest::newRow("ellipsoid") << false;
}

void TestShoulders::hairStaysOutsideThemInTheWorld()
{
    QFETCH(bool, asSkin);
    const std::vector<Ellipsoid> ball{{glm::vec3(0.0F), glm::vec3(kBallM), glm::quat(1.0F, 0.0F, 0.0F, 0.0F)}};
    const ColliderSet colliders =
        asSkin ? prepareColliders({}, DistanceGrid::make(makeBallHead(64, kBallM))) : prepareColliders(ball);
    const Neck neck = neckBesideTheBall();
    const HeadPose pose = turnedAbout(neck, 1.0F);
    const auto deepestM = [&](const Neck& of) {
        StepForces forces = WindField::calm(pose);
        forces.neck = neckTurn(of, pose);
        GroupDynamics hair;
        hair.setGroom(groomOf(strandsOver(pose), 12, PhysicsSettings{}), colliders, forces);
        for (int i = 0; i < 240; ++i)
            hair.step(std::span(&forces, 1));
        const StrandState& state = hair.state();
        float depth = 0.0F;
        for (std::size_t strand = 0; strand < 13 * 13; ++strand)
            for (std::size_t node = 1; node < 12; ++node) {
                const glm::vec3 nodeHd = state.shape().node(state.now(), strand, node);
                depth = std::max(depth, kBallM - glm::length(pose.rotation * nodeHd + pose.positionWo));
            }
        return depth;
    };
    QVERIFY2(deepestM(neck) < 0.002F, qPrintable(QString::number(deepestM(neck))));
    QVERIFY(deepestM({}) > 0.05F);
}

void TestShoulders::hairOnThemTurnsThemAlong()
{
    GroomInput input = paintedBall(500, 100);
    Simulation simulation;
    StrandFrame frame;
    input.neck = {.headY = -1.0F, .shouldersY = -1.1F};
    simulation.setInput(input);
    simulation.writeFrame(frame);
    QCOMPARE(frame.neck, input.neck);
    input.neck = {.headY = 1.0F, .shouldersY = 0.9F};
    simulation.setInput(input);
    simulation.writeFrame(frame);
    QVERIFY(!frame.neck.hasShoulders());
}

void TestShoulders::aStraightHeadIsNotTurned()
{
    const Neck neck = neckBesideTheBall();
    QVERIFY(!neckTurn(neck, {}).turned);
    QVERIFY(neckTurn(neck, turnedAbout(neck, 0.1F)).turned);
    QVERIFY(!neckTurn({}, turnedAbout(neck, 0.1F)).turned);
    // The shorter way about, however the quaternion is written.
    HeadPose pose = turnedAbout(neck, 0.1F);
    pose.rotation = -pose.rotation;
    QVERIFY(neckTurn(neck, pose).turn[3] > 0.9F);
}

void TestShoulders::theyBeginBelowTheChin()
{
    HeadLandmarks landmarks;
    landmarks[HeadLandmark::EarLeft] = {0.07F, 0.0F, 0.0F};
    landmarks[HeadLandmark::EarRight] = {-0.07F, 0.0F, 0.0F};
    landmarks[HeadLandmark::Nape] = {0.0F, -0.06F, -0.08F};
    landmarks[HeadLandmark::Chin] = {0.0F, -0.1F, 0.08F};
    const Neck neck = neckOf(landmarks, {});
    QVERIFY(neck.hasShoulders());
    QVERIFY(neck.headY < -0.1F && neck.headY > neck.pivotHd.y);
    QVERIFY(neck.shouldersY < neck.pivotHd.y);
    QVERIFY(!neckOf({}, makeBallHead(16, kBallM)).hasShoulders());
}

HAIRPAINT_TEST(TestShoulders, None)
#include "test_shoulders.moc"
