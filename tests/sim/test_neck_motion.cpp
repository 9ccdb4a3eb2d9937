// The head on its neck: motions against what they promise, the return, and the pose about the neck's base.
#include "sim/motion/neck_motion.h"
#include "sim/solver/solver_layout.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace hairpaint::sim;

namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180.0F;

glm::vec3 posed(const HeadPose& pose, glm::vec3 positionHd)
{
    return pose.rotation * positionHd + pose.positionWo;
}

HeadLandmarks someLandmarks()
{
    HeadLandmarks landmarks;
    landmarks[HeadLandmark::Nape] = {0.0F, -0.07F, -0.08F};
    landmarks[HeadLandmark::EarLeft] = {0.07F, -0.02F, 0.0F};
    landmarks[HeadLandmark::EarRight] = {-0.07F, -0.02F, 0.0F};
    landmarks[HeadLandmark::Chin] = {0.0F, -0.11F, 0.08F};
    return landmarks;
}

} // namespace

class TestNeckMotion : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aMotionIsKnownByItsName()
    {
        QCOMPARE(neckMotionNamed("nod"), NeckMotion::Nod);
        QCOMPARE(neckMotionNamed("shake"), NeckMotion::Shake);
        QCOMPARE(neckMotionNamed("turn"), NeckMotion::Turn);
        QVERIFY(!neckMotionNamed("bow") && !neckMotionNamed(""));
    }

    void aMotionTakesItsTimeAndReachesItsAngles_data()
    {
        QTest::addColumn<int>("motion");
        QTest::addColumn<double>("seconds");
        QTest::addColumn<float>("yawDegrees");
        QTest::addColumn<float>("pitchDegrees");
        QTest::addColumn<int>("turningPoints");
        QTest::newRow("nod") << static_cast<int>(NeckMotion::Nod) << 1.6 << 0.0F << 20.0F << 4;
        QTest::newRow("shake") << static_cast<int>(NeckMotion::Shake) << 1.6 << 35.0F << 0.0F << 4;
        QTest::newRow("turn") << static_cast<int>(NeckMotion::Turn) << 4.0 << 60.0F << 0.0F << 2;
    }

    void aMotionTakesItsTimeAndReachesItsAngles()
    {
        QFETCH(int, motion);
        QFETCH(double, seconds);
        QFETCH(float, yawDegrees);
        QFETCH(float, pitchDegrees);
        QFETCH(int, turningPoints);
        const auto at = [motion](double t) { return anglesAt(static_cast<NeckMotion>(motion), t); };
        QCOMPARE(secondsOf(static_cast<NeckMotion>(motion)), seconds);
        for (const double outside : {-1.0, 0.0, seconds, seconds + 1.0})
            QCOMPARE(at(outside), NeckAngles{});

        NeckAngles least;
        NeckAngles greatest;
        int turns = 0;
        float lastVelocity = 0.0F;
        float direction = 0.0F;
        constexpr double kStep = 1e-3;
        constexpr float kSeen = 1e-2F; // rad/s
        const int steps = static_cast<int>(seconds / kStep) + 10;
        for (int i = -10; i < steps; ++i) {
            const double t = i * kStep;
            const NeckAngles a = at(t);
            const NeckAngles b = at(t + kStep);
            least = {std::min(least.yawRad, a.yawRad), std::min(least.pitchRad, a.pitchRad)};
            greatest = {std::max(greatest.yawRad, a.yawRad), std::max(greatest.pitchRad, a.pitchRad)};
            const auto rate = static_cast<float>(1.0 / kStep);
            const float velocity = (b.yawRad - a.yawRad + b.pitchRad - a.pitchRad) * rate;
            // 35 degrees in 0.2 s by minimum jerk: 88 rad/s2 at most; no jump of speed anywhere.
            QVERIFY2(std::abs(velocity - lastVelocity) < 0.1F, qPrintable(QString::number(t)));
            if (std::abs(velocity) > kSeen) {
                turns += direction * velocity < 0.0F ? 1 : 0;
                direction = velocity;
            }
            lastVelocity = velocity;
        }
        QVERIFY(lastVelocity == 0.0F);
        QCOMPARE(turns, turningPoints);
        QVERIFY(std::abs(greatest.yawRad - yawDegrees * kDegree) < 1e-4F);
        QVERIFY(std::abs(least.yawRad + yawDegrees * kDegree) < 1e-4F);
        QVERIFY(std::abs(greatest.pitchRad - pitchDegrees * kDegree) < 1e-4F);
        QVERIFY(std::abs(least.pitchRad + pitchDegrees * kDegree) < 1e-4F);
    }

    /// So that it can be repeated in a film without drifting against the frames.
    void aMotionTakesWholeStepsOfTheSimulation()
    {
        for (const NeckMotion motion : {NeckMotion::Nod, NeckMotion::Shake, NeckMotion::Turn}) {
            const double steps = secondsOf(motion) / kStepSeconds;
            QVERIFY(std::abs(steps - std::round(steps)) < 1e-9);
        }
    }

    void aHeadThatIsLetGoComesBackWithoutSwingingPast()
    {
        const NeckAngles from{1.2F, -0.4F};
        QCOMPARE(returning(from, 0.0), from);
        QCOMPARE(returning(from, kReturnSeconds), NeckAngles{});
        NeckAngles before = from;
        for (int i = 1; i < 100; ++i) {
            const NeckAngles now = returning(from, kReturnSeconds * i / 100.0);
            QVERIFY(now.yawRad >= 0.0F && now.yawRad < before.yawRad);
            QVERIFY(now.pitchRad <= 0.0F && now.pitchRad > before.pitchRad);
            QVERIFY(before.yawRad - now.yawRad < 0.06F); // 12/e of the distance a second at its fastest
            before = now;
        }
        QVERIFY(before.yawRad < 2e-4F); // What is dropped at the end is not seen.
        QVERIFY(returning(from, 0.01).yawRad > 1.19F);
        const float half = returning(from, 0.5).yawRad / from.yawRad;
        QVERIFY2(std::abs(half - 7.0F * std::exp(-6.0F)) < 1e-5F, qPrintable(QString::number(half)));
    }

    void aNeckTurnsSoFarAndNoFarther()
    {
        QCOMPARE(withinReach({0.3F, -0.2F}), (NeckAngles{0.3F, -0.2F}));
        const NeckAngles most = withinReach({9.0F, 9.0F});
        QVERIFY(std::abs(most.yawRad - 80.0F * kDegree) < 1e-6F);
        QVERIFY(std::abs(most.pitchRad - 45.0F * kDegree) < 1e-6F);
        QCOMPARE(withinReach({-9.0F, -9.0F}), (NeckAngles{-most.yawRad, -most.pitchRad}));
        const float nan = std::numeric_limits<float>::quiet_NaN();
        QCOMPARE(withinReach({nan, nan}), NeckAngles{});
    }

    void thePoseTurnsAboutTheNeck()
    {
        const Neck neck{.pivotHd = {0.01F, -0.16F, -0.04F}};
        QCOMPARE(poseOn(neck, {}), HeadPose{});
        const glm::vec3 ahead(0.0F, 0.0F, 1.0F);
        const HeadPose left = poseOn(neck, {90.0F * kDegree, 0.0F});
        QVERIFY(glm::distance(left.rotation * ahead, glm::vec3(1.0F, 0.0F, 0.0F)) < 1e-5F);
        const HeadPose down = poseOn(neck, {0.0F, 45.0F * kDegree});
        QVERIFY(glm::distance(down.rotation * ahead, glm::vec3(0.0F, -1.0F, 1.0F) * std::sqrt(0.5F)) < 1e-5F);
        const HeadPose both = poseOn(neck, {90.0F * kDegree, 45.0F * kDegree});
        QVERIFY(glm::distance(both.rotation * ahead, glm::vec3(1.0F, -1.0F, 0.0F) * std::sqrt(0.5F)) < 1e-5F);
        for (const HeadPose& pose : {left, down, both}) {
            QVERIFY(glm::distance(posed(pose, neck.pivotHd), neck.pivotHd) < 1e-6F);
            QVERIFY(std::abs(glm::dot(pose.rotation, pose.rotation) - 1.0F) < 1e-5F);
        }
    }

    void theNecksBaseLiesBelowTheChinAndBehindTheEars()
    {
        const Neck neck = neckOf(someLandmarks(), {});
        QVERIFY(glm::distance(neck.pivotHd, glm::vec3(0.0F, -0.155F, -0.04F)) < 1e-5F);
        QVERIFY(glm::distance(neck.acrossHd, glm::vec3(1.0F, 0.0F, 0.0F)) < 1e-5F);
    }

    void aHeadThatLooksAsideNodsAboutItsOwnAxis()
    {
        HeadLandmarks landmarks = someLandmarks();
        for (glm::vec3& p : landmarks.positionsHd)
            p = {p.z, p.y, -p.x}; // It faces +x.
        const HeadPose down = poseOn(neckOf(landmarks, {}), {0.0F, 30.0F * kDegree});
        const glm::vec3 face = down.rotation * glm::vec3(1.0F, 0.0F, 0.0F);
        QVERIFY(std::abs(face.y + 0.5F) < 1e-5F && std::abs(face.z) < 1e-5F);
    }

    void withoutLandmarksTheNeckLiesInTheMeshBelowItsTop()
    {
        HeadMesh head;
        head.positionsHd = {{-0.1F, -0.1F, -0.1F}, {0.1F, 0.1F, 0.3F}};
        QVERIFY(glm::distance(neckOf({}, head).pivotHd, glm::vec3(0.0F, -0.1F, 0.1F)) < 1e-6F);
        HeadMesh body;
        body.positionsHd = {{-0.5F, -1.6F, -0.2F}, {0.5F, 0.12F, 0.2F}};
        QVERIFY(glm::distance(neckOf({}, body).pivotHd, glm::vec3(0.0F, -0.15F, 0.0F)) < 1e-6F);
        QCOMPARE(neckOf({}, {}).pivotHd, glm::vec3(0.0F));
    }
};

HAIRPAINT_TEST(TestNeckMotion, None)
#include "test_neck_motion.moc"
