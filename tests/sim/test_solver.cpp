// The solver against what physics says, and the promises it makes about lengths, ellipsoids, gel and robustness.
#include "sim/base/deterministic.h"
#include "sim/motion/group_dynamics.h"
#include "sim/motion/head_motion.h"
#include "sim/motion/simulation.h"
#include "sim/motion/wind_field.h"
#include "tests/sim/hanging_hair.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr auto kStep = static_cast<float>(kStepSeconds);

/// Strands over the upper half of a ball of 0.1 m, evenly by the golden angle, pointing along the normal.
std::vector<HandStrand> ballStrands(std::size_t count, float lengthM)
{
    std::vector<HandStrand> strands(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float y = 1.0F - (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        const float turn = static_cast<float>(i) * 2.3999632F;
        const float across = std::sqrt(1.0F - y * y);
        const glm::vec3 normal(across * std::cos(turn), y, across * std::sin(turn));
        strands[i] = {normal * 0.1F, normal, lengthM, 0.0F, static_cast<float>(i % 7) / 7.0F, true};
    }
    return strands;
}

float worstLengthError(const GroupDynamics& hair)
{
    const Groom& groom = *hair.groom();
    float worst = 0.0F;
    for (std::size_t strand = 0; strand < (*groom.basis)[BasisQuantity::SegmentLength].size(); ++strand) {
        const float length = (*groom.basis)[BasisQuantity::SegmentLength][strand];
        if (length <= 0.0F)
            continue;
        for (int node = 1; node < groom.nodes; ++node) {
            const float distance = glm::distance(nodeOf(hair, strand, node - 1), nodeOf(hair, strand, node));
            worst = std::isfinite(distance) ? std::max(worst, std::abs(distance / length - 1.0F))
                                            : std::numeric_limits<float>::infinity();
        }
    }
    return worst;
}

} // namespace

class TestSolver : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aNodeFallsFreelyUntilItsSegmentIsTight();
    void aPendulumSwingsWithItsPeriod_data();
    void aPendulumSwingsWithItsPeriod();
    void dragLimitsTheSpeedOfAFall();
    void lengthsAreExactAfterAnyStep_data();
    void lengthsAreExactAfterAnyStep();
    void nodesStayOutsideTheEllipsoids_data();
    void nodesStayOutsideTheEllipsoids();
    void frictionHoldsHairOnASlope_data();
    void frictionHoldsHairOnASlope();
    void gelKeepsTheRestShapeAgainstGravityAndWind();
    void windBendsHairInItsDirection();
    void nothingExplodes_data();
    void nothingExplodes();
    void tenMinutesOfStormAndShakingStretchNothing();
    void gustsReachEachLockInItsOwnTime();
};

void TestSolver::aNodeFallsFreelyUntilItsSegmentIsTight()
{
    // A strand that points straight down is tight. The first step of a horizontal one is g dt^2 / 1, turned about the
    // root: free fall until the constraint, whose part along the segment is of second order.
    GroupDynamics hair;
    hair.setGroom(groomOf({{glm::vec3(0.0F), glm::vec3(1.0F, 0.0F, 0.0F), 1.0F}}, 2, barePhysics()), {},
                  WindField::calm({}));
    hair.reset();
    for (int steps = 1; steps <= 4; ++steps) {
        fall(hair, 1);
        const float expected = 0.5F * static_cast<float>(steps * (steps + 1)) * 9.81F * kStep * kStep;
        QVERIFY(std::abs(-nodeOf(hair, 0, 1).y - expected) < 0.01F * expected);
    }
}

void TestSolver::aPendulumSwingsWithItsPeriod_data()
{
    QTest::addColumn<float>("length");
    QTest::newRow("5 cm") << 0.05F;
    QTest::newRow("20 cm") << 0.2F;
    QTest::newRow("1 m") << 1.0F;
}

void TestSolver::aPendulumSwingsWithItsPeriod()
{
    QFETCH(float, length);
    constexpr float kAngle = 0.1F; // small: the period differs from 2 pi sqrt(l/g) by 0.06 %
    const glm::vec3 direction(std::sin(kAngle), -std::cos(kAngle), 0.0F);
    GroupDynamics hair;
    hair.setGroom(groomOf({{glm::vec3(0.0F), direction, length}}, 2, barePhysics()), {}, WindField::calm({}));
    hair.reset();
    const double period = 2.0 * std::numbers::pi * std::sqrt(static_cast<double>(length) / 9.81);
    // Time of the second, third ... passage through the vertical is a quarter and then halves of the period.
    double first = 0.0;
    double last = 0.0;
    int passages = 0;
    float before = nodeOf(hair, 0, 1).x;
    for (int step = 1; step * kStepSeconds < 5.2 * period; ++step) {
        fall(hair, 1);
        const float x = nodeOf(hair, 0, 1).x;
        if ((x < 0.0F) != (before < 0.0F)) {
            const double at = (step - 1 + static_cast<double>(before / (before - x))) * kStepSeconds;
            first = passages == 0 ? at : first;
            last = at;
            ++passages;
        }
        before = x;
    }
    QVERIFY(passages >= 9);
    const double measured = 2.0 * (last - first) / (passages - 1);
    QVERIFY2(std::abs(measured / period - 1.0) < 0.03, qPrintable(QString::number(measured / period)));
}

void TestSolver::dragLimitsTheSpeedOfAFall()
{
    // Terminal speed g/damping; the segment is long enough that the fall stays nearly vertical.
    PhysicsSettings physics = barePhysics();
    physics.damping = 8.0F;
    GroupDynamics hair;
    hair.setGroom(groomOf({{glm::vec3(0.0F), glm::vec3(1.0F, 0.0F, 0.0F), 20.0F}}, 2, physics), {},
                  WindField::calm({}));
    hair.reset();
    fall(hair, 150);
    const float before = nodeOf(hair, 0, 1).y;
    fall(hair, 12);
    const float speed = (before - nodeOf(hair, 0, 1).y) / (12.0F * kStep);
    QVERIFY2(std::abs(speed / (9.81F / 8.0F) - 1.0F) < 0.05F, qPrintable(QString::number(speed)));
}

void TestSolver::lengthsAreExactAfterAnyStep_data()
{
    QTest::addColumn<int>("nodes");
    QTest::addColumn<float>("gel");
    QTest::addColumn<float>("wind");
    QTest::newRow("two nodes") << 2 << 0.0F << 0.0F;
    QTest::newRow("eight nodes falling") << 8 << 0.0F << 0.0F;
    QTest::newRow("gelled in a storm") << 5 << 0.4F << 30.0F;
    QTest::newRow("many nodes in wind") << 32 << 0.0F << 8.0F;
}

void TestSolver::lengthsAreExactAfterAnyStep()
{
    QFETCH(int, nodes);
    QFETCH(float, gel);
    QFETCH(float, wind);
    std::vector<HandStrand> strands = ballStrands(40, 0.3F);
    for (HandStrand& strand : strands)
        strand.gel = gel;
    GroupDynamics hair;
    hair.setGroom(groomOf(strands, nodes, PhysicsSettings{}), ballCollider(), WindField::calm({}));
    hair.reset();
    WindField air;
    air.setWind({true, glm::vec3(wind, 0.0F, 0.5F * wind), 0.5F, 0.5F});
    for (int i = 0; i < 200; ++i) {
        const StepForces forces = air.nextStep({}, {});
        hair.step(std::span(&forces, 1));
        QVERIFY2(worstLengthError(hair) < 1e-4F, qPrintable(QString::number(worstLengthError(hair))));
    }
}

void TestSolver::nodesStayOutsideTheEllipsoids_data()
{
    QTest::addColumn<float>("wind");
    QTest::newRow("hanging") << 0.0F;
    QTest::newRow("pressed on by wind") << 15.0F;
}

void TestSolver::nodesStayOutsideTheEllipsoids()
{
    QFETCH(float, wind);
    GroupDynamics hair;
    hair.setGroom(groomOf(ballStrands(200, 0.25F), 8, PhysicsSettings{}), ballCollider(), WindField::calm({}));
    WindField air;
    air.setWind({true, glm::vec3(0.0F, 0.0F, -wind), 0.5F, 0.3F});
    float deepest = 0.0F;
    for (int i = 0; i < 300; ++i) {
        const StepForces forces = air.nextStep({}, {});
        hair.step(std::span(&forces, 1));
        for (std::size_t strand = 0; strand < 200; ++strand) {
            for (int node = 1; node < 8; ++node)
                deepest = std::max(deepest, 0.1F - glm::length(nodeOf(hair, strand, node)));
        }
    }
    QVERIFY2(deepest < 0.001F, qPrintable(QString::number(deepest)));
}

void TestSolver::frictionHoldsHairOnASlope_data()
{
    QTest::addColumn<float>("friction");
    QTest::addColumn<bool>("holds");
    // Where the node lies the ball has a slope of 30 degrees: tan is 0.58.
    QTest::newRow("none") << 0.0F << false;
    QTest::newRow("little") << 0.2F << false;
    QTest::newRow("enough") << 0.5F << true;
    QTest::newRow("all") << 1.0F << true;
}

void TestSolver::frictionHoldsHairOnASlope()
{
    QFETCH(float, friction);
    QFETCH(bool, holds);
    // A segment that lies across the slope of a ball, its free end 30 degrees from the top, sideways of the root.
    PhysicsSettings physics = barePhysics();
    physics.friction = friction;
    const glm::vec3 root(0.0F, 0.1F * std::cos(0.5236F), 0.1F * std::sin(0.5236F));
    const glm::vec3 sideways = root + glm::vec3(0.03F, 0.0F, 0.0F);
    const glm::vec3 end = sideways * (0.1F / glm::length(sideways));
    const glm::vec3 extent = end - root;
    GroupDynamics hair;
    hair.setGroom(groomOf({{root, extent / glm::length(extent), glm::length(extent)}}, 2, physics), ballCollider(),
                  WindField::calm({}));
    hair.reset();
    const glm::vec3 before = nodeOf(hair, 0, 1);
    fall(hair, 120);
    const float slid = glm::distance(before, nodeOf(hair, 0, 1));
    QVERIFY2(holds ? slid < 0.002F : slid > 0.005F, qPrintable(QString::number(slid)));
}

void TestSolver::gelKeepsTheRestShapeAgainstGravityAndWind()
{
    std::vector<HandStrand> strands = ballStrands(64, 0.2F);
    for (HandStrand& strand : strands)
        strand.gel = 1.0F;
    GroupDynamics hair;
    hair.setGroom(groomOf(strands, 8, PhysicsSettings{}), ballCollider(), WindField::calm({}));
    WindField air;
    air.setWind({true, glm::vec3(20.0F, 0.0F, 0.0F), 0.5F, 0.5F});
    for (int i = 0; i < 120; ++i) {
        const StepForces forces = air.nextStep({}, {});
        hair.step(std::span(&forces, 1));
    }
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const glm::vec3 tip = strands[i].rootHd + strands[i].directionHd * strands[i].lengthM;
        QVERIFY(glm::distance(nodeOf(hair, i, 7), tip) < 1e-5F);
    }
}

void TestSolver::windBendsHairInItsDirection()
{
    PhysicsSettings physics = barePhysics();
    physics.damping = 2.0F;
    // On top of the coat, where nothing shelters it.
    const HandStrand strand{
        .rootHd = glm::vec3(0.0F), .directionHd = glm::vec3(0.0F, -1.0F, 0.0F), .lengthM = 0.3F, .height = 1.0F};
    GroupDynamics hair;
    hair.setGroom(groomOf({strand}, 6, physics), {}, WindField::calm({}));
    WindField air;
    air.setWind({true, glm::vec3(4.0F, 0.0F, 0.0F), 0.0F, 0.0F});
    for (int i = 0; i < 480; ++i) {
        const StepForces forces = air.nextStep({}, {});
        hair.step(std::span(&forces, 1));
    }
    const glm::vec3 tip = nodeOf(hair, 0, 5);
    QVERIFY(tip.x > 0.1F);
    QVERIFY(tip.y < -0.05F);
    QVERIFY(std::abs(tip.z) < 0.01F);
}

void TestSolver::nothingExplodes_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 6; ++seed)
        QTest::newRow(qPrintable(QStringLiteral("seed %1").arg(seed))) << seed;
}

void TestSolver::nothingExplodes()
{
    QFETCH(int, seed);
    std::vector<HandStrand> strands = ballStrands(48, 0.3F);
    GroupDynamics hair;
    hair.setGroom(groomOf(strands, 8, PhysicsSettings{}), ballCollider(), WindField::calm({}));
    WindField air;
    HeadPose pose;
    std::uint64_t counter = 0;
    const auto random = [&] { return unitFloat(hash64(static_cast<std::uint64_t>(seed), ++counter)) * 2.0F - 1.0F; };
    for (int i = 0; i < 600; ++i) {
        const float event = random();
        const HeadPose before = pose;
        if (event > 0.97F) { // a teleport
            pose = sanePose(
                {glm::quat(random(), random(), random(), random()), glm::vec3(random(), random(), random()) * 5.0F},
                pose);
        } else if (event > 0.8F) { // a jolt
            pose.positionWo += glm::vec3(random(), random(), random()) * 0.1F;
        } else if (event > 0.7F) {
            air.setWind({true, glm::vec3(random(), random(), random()) * 30.0F, 1.0F, 1.0F});
        } else if (event > 0.69F) {
            air.setWind({true, glm::vec3(std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F), 1.0F, 1.0F});
        } else if (event > 0.67F) {
            air.puff(glm::vec3(random(), random(), random()) * 0.2F, glm::vec3(1000.0F * random()), 0.1F);
        } else if (event > 0.65F) {
            hair.reset();
        }
        const StepForces forces = air.nextStep(before, pose);
        hair.step(std::span(&forces, 1));
        QVERIFY(worstLengthError(hair) < 1e-3F);
    }
    // And it comes to rest again.
    air = {};
    fall(hair, 1800);
    std::vector<glm::vec3> tips(strands.size());
    for (std::size_t s = 0; s < tips.size(); ++s)
        tips[s] = nodeOf(hair, s, 7);
    fall(hair, 12);
    for (std::size_t s = 0; s < tips.size(); ++s)
        QVERIFY(glm::distance(tips[s], nodeOf(hair, s, 7)) < 0.005F);
}

void TestSolver::tenMinutesOfStormAndShakingStretchNothing()
{
    GroupDynamics hair;
    hair.setGroom(groomOf(ballStrands(16, 0.3F), 8, PhysicsSettings{}), ballCollider(), WindField::calm({}));
    WindField air;
    HeadPose pose;
    constexpr int kSteps = 10 * 60 * 120;
    for (int i = 0; i < kSteps; ++i) {
        const float seconds = static_cast<float>(i) / 120.0F;
        if (i % 600 == 0) // From another side every five seconds.
            air.setWind({true, 25.0F * glm::vec3(std::sin(seconds), 0.3F, std::cos(seconds)), 1.0F, 1.0F});
        const HeadPose before = pose;
        pose.rotation = glm::angleAxis(1.3F * std::sin(12.0F * seconds), glm::vec3(0.0F, 1.0F, 0.0F)) *
                        glm::angleAxis(0.7F * std::sin(9.0F * seconds), glm::vec3(1.0F, 0.0F, 0.0F));
        pose.positionWo = 0.2F * glm::vec3(std::sin(7.0F * seconds), std::sin(11.0F * seconds), 0.0F);
        const StepForces forces = air.nextStep(before, pose);
        hair.step(std::span(&forces, 1));
        // Where something is not a number the error is none that is less.
        if (i % 60 == 0)
            QVERIFY(worstLengthError(hair) < 0.01F);
    }
}

void TestSolver::gustsReachEachLockInItsOwnTime()
{
    // Pairs of hairs: two beside each other, one some distance off.
    constexpr float kBesideM = 0.002F;
    constexpr float kApartM = 0.06F;
    constexpr std::size_t kPairs = 12;
    std::vector<HandStrand> strands;
    for (std::size_t pair = 0; pair < kPairs; ++pair)
        for (const float offsetM : {0.0F, kBesideM, kApartM})
            strands.push_back({.rootHd = {0.013F * static_cast<float>(pair) + offsetM, 1.0F, 0.0F},
                               .directionHd = {0.0F, -1.0F, 0.0F},
                               .lengthM = 0.3F});
    GroupDynamics hair;
    hair.setGroom(groomOf(strands, 8, PhysicsSettings{}), {}, WindField::calm({}));
    WindField air;
    air.setWind({true, glm::vec3(0.0F, 0.0F, 4.0F), 1.0F, 0.5F});
    float beside = 0.0F;
    float apart = 0.0F;
    for (int i = 0; i < 1200; ++i) {
        const StepForces forces = air.nextStep({}, {});
        hair.step(std::span(&forces, 1));
        for (std::size_t first = 0; first < strands.size(); first += 3) {
            const float z = nodeOf(hair, first, 7).z;
            beside += std::abs(z - nodeOf(hair, first + 1, 7).z);
            apart += std::abs(z - nodeOf(hair, first + 2, 7).z);
        }
    }
    QVERIFY2(apart > 2.5F * beside, qPrintable(QStringLiteral("%1 %2").arg(apart).arg(beside)));
}

HAIRPAINT_TEST(TestSolver, None)
#include "test_solver.moc"
