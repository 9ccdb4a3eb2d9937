// Hair that is new falls before the shoulder or behind it by where it hangs, not by where the shoulder's crest is.
#include "sim/motion/first_fall.h"
#include "tests/sim/hanging_hair.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr int kNodes = 16;
constexpr float kLengthM = 0.45F;

/// The head ends at y = 0, the shoulders begin 6 cm below.
Neck neckAtOrigin()
{
    return {.pivotHd = {0.0F, 0.0F, 0.0F}, .headY = 0.0F, .shouldersY = -0.06F};
}

/// A strand that hangs straight down so far before the neck's pivot.
std::vector<glm::vec3> hangingAt(float z, float lengthM)
{
    std::vector<glm::vec3> nodes;
    nodes.reserve(kNodes);
    for (int i = 0; i < kNodes; ++i)
        nodes.emplace_back(0.1F, 0.1F - lengthM * static_cast<float>(i) / (kNodes - 1), z);
    return nodes;
}

float leanAt(float z, float lengthM, const Neck& neck)
{
    return leanOf(hangingAt(z, lengthM), lengthM / (kNodes - 1), neck);
}

/// A shoulder along x whose crest is at z.
ColliderSet shoulderAt(float z)
{
    const std::vector<Ellipsoid> shoulder{
        {glm::vec3(0.1F, -0.16F, z), glm::vec3(0.3F, 0.08F, 0.06F), glm::quat(1.0F, 0.0F, 0.0F, 0.0F)}};
    return prepareColliders(shoulder);
}

std::vector<HandStrand> strandsOverShoulder()
{
    std::vector<HandStrand> strands;
    for (int i = 0; i < 8; ++i) {
        const float z = i < 4 ? 0.02F + 0.003F * static_cast<float>(i) : -0.003F * static_cast<float>(i - 3);
        strands.push_back({.rootHd = {0.06F + 0.01F * static_cast<float>(i), 0.1F, z},
                           .directionHd = {0.0F, -1.0F, 0.0F},
                           .lengthM = kLengthM});
    }
    return strands;
}

/// Which of the strands have their tips before the crest once they came to rest.
std::array<bool, 8> fallenForward(float crestZ, const Neck& neck)
{
    GroupDynamics hair;
    hair.setGroom(groomOf(strandsOverShoulder(), kNodes, PhysicsSettings{}), shoulderAt(crestZ), WindField::calm({}),
                  neck);
    fall(hair, 300);
    std::array<bool, 8> forward{};
    for (std::size_t i = 0; i < forward.size(); ++i)
        forward[i] = nodeOf(hair, i, kNodes - 1).z > crestZ;
    return forward;
}

} // namespace

class TestFirstFall : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aStrandLeansToItsOwnSide();
    void shoulderLengthIsNeeded();
    void everyShoulderDividesHairAlike();
    void itEndsAndIsTheSameForAnyNumberOfStepsAtOnce();
    void shortHairFallsAsWithoutIt();
};

void TestFirstFall::aStrandLeansToItsOwnSide()
{
    const Neck neck = neckAtOrigin();
    QCOMPARE(leanAt(0.025F, kLengthM, neck), 1.0F);
    QCOMPARE(leanAt(-0.01F, kLengthM, neck), -1.0F);
    const float between = leanAt(0.0106F, kLengthM, neck);
    QVERIFY(between > 0.0F && between < 1.0F);
    // Nothing meets a shoulder there.
    QCOMPARE(leanAt(0.1F, kLengthM, neck), 0.0F);
    QCOMPARE(leanAt(-0.12F, kLengthM, neck), 0.0F);
    // To the side of another head.
    Neck turned = neck;
    turned.acrossHd = {0.0F, 0.0F, -1.0F}; // It faces +x.
    QCOMPARE(leanOf(hangingAt(0.0F, kLengthM), kLengthM / (kNodes - 1), turned), 0.0F);
    turned.pivotHd.x = 0.075F;
    QCOMPARE(leanOf(hangingAt(0.0F, kLengthM), kLengthM / (kNodes - 1), turned), 1.0F);
}

void TestFirstFall::shoulderLengthIsNeeded()
{
    const Neck neck = neckAtOrigin();
    QCOMPARE(leanAt(-0.01F, 0.15F, neck), 0.0F);
    QVERIFY(!reachesShoulders(hangingAt(-0.01F, 0.15F), 0.01F, neck));
    QVERIFY(reachesShoulders(hangingAt(-0.01F, 0.2F), 0.2F / (kNodes - 1), neck));
    QCOMPARE(leanAt(-0.01F, kLengthM, Neck{}), 0.0F); // Not known where they are.
}

void TestFirstFall::everyShoulderDividesHairAlike()
{
    constexpr std::array<bool, 8> kBySide{true, true, true, true, false, false, false, false};
    for (const float crestZ : {-0.012F, 0.01F, 0.032F})
        QVERIFY2(fallenForward(crestZ, neckAtOrigin()) == kBySide, qPrintable(QString::number(crestZ)));
    // The crest alone decides where nothing is known of the neck.
    QVERIFY(fallenForward(-0.012F, {}) != fallenForward(0.032F, {}));
}

void TestFirstFall::itEndsAndIsTheSameForAnyNumberOfStepsAtOnce()
{
    GroupGains gains;
    FirstFall fall;
    (void)fall.apply(neckAtOrigin(), gains);
    QVERIFY(!gains.leans); // Long over.
    fall.begin();
    float before = 1.0F;
    std::size_t steps = 0;
    for (std::size_t right = 0; steps < 240; steps += right) {
        right = fall.apply(neckAtOrigin(), gains);
        if (!gains.leans)
            break;
        QVERIFY(gains.lean[2] > 0.0F && gains.lean[2] < before && right > 0);
        before = gains.lean[2];
        fall.pass(right);
    }
    QVERIFY(steps > 60 && steps < 200);

    const StepForces calm = WindField::calm({});
    std::array<GroupDynamics, 2> hairs;
    for (GroupDynamics& hair : hairs)
        hair.setGroom(groomOf(strandsOverShoulder(), kNodes, PhysicsSettings{}), shoulderAt(0.0F), calm,
                      neckAtOrigin());
    const std::vector<StepForces> seven(7, calm);
    for (int i = 0; i < 30; ++i)
        hairs[0].step(seven);
    hairpaint::test::fall(hairs[1], 210);
    QVERIFY(hairs[0].state().now() == hairs[1].state().now());
}

void TestFirstFall::shortHairFallsAsWithoutIt()
{
    std::vector<HandStrand> strands = strandsOverShoulder();
    for (HandStrand& strand : strands)
        strand.lengthM = 0.15F;
    std::array<GroupDynamics, 2> hairs;
    for (std::size_t i = 0; i < 2; ++i) {
        hairs[i].setGroom(groomOf(strands, kNodes, PhysicsSettings{}), shoulderAt(0.0F), WindField::calm({}),
                          i == 0 ? Neck{} : neckAtOrigin());
        hairs[i].reset();
        hairpaint::test::fall(hairs[i], 60);
    }
    QVERIFY(hairs[0].state().now() == hairs[1].state().now());
}

HAIRPAINT_TEST(TestFirstFall, None)
#include "test_first_fall.moc"
