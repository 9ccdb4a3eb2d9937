// A braid is as thick as its wisps make it where it meets the skin and other braids.
#include "sim/base/deterministic.h"
#include "sim/base/parallel.h"
#include "sim/groom/strand_curve.h"
#include "tests/sim/hanging_hair.h"
#include "tests/sim/small_groom.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr float kBallM = 0.1F;
constexpr int kNodes = 16;
constexpr float kLengthM = 0.3F;

/// Strands that leave the ball's upper half and fall down its sides, each the skeleton of a braid.
std::vector<HandStrand> strandsOnBall(float girthM)
{
    std::vector<HandStrand> strands;
    for (int i = 0; i < 32; ++i) {
        const float around = 0.2F * static_cast<float>(i);
        const float fromTop = 0.3F + 0.03F * static_cast<float>(i);
        const glm::vec3 out(std::sin(fromTop) * std::cos(around), std::cos(fromTop),
                            std::sin(fromTop) * std::sin(around));
        strands.push_back({.rootHd = out * kBallM, .directionHd = out, .lengthM = kLengthM, .girthM = girthM});
    }
    return strands;
}

/// How near to the ball a node is that the braid's girth has fully reached.
float nearestM(float girthM, int steps)
{
    const ColliderSet colliders = prepareColliders({}, DistanceGrid::make(makeBallHead(64, kBallM)));
    GroupDynamics hair;
    hair.setGroom(groomOf(strandsOnBall(girthM), kNodes, PhysicsSettings{}), colliders, WindField::calm({}));
    fall(hair, steps);
    constexpr float kSegmentM = kLengthM / static_cast<float>(kNodes - 1);
    float nearest = 1.0F;
    for (std::size_t strand = 0; strand < 32; ++strand)
        for (int node = 1; node < kNodes; ++node) {
            if (kGirthSlope * kSegmentM * static_cast<float>(node) >= girthM)
                nearest = std::min(nearest, glm::length(nodeOf(hair, strand, node)) - kBallM);
        }
    return nearest;
}

constexpr float kGirthM = 0.007F;

ColliderSet ballOfSkin()
{
    static const ColliderSet ball = prepareColliders({}, DistanceGrid::make(makeBallHead(64, kBallM)));
    return ball;
}

/// Braids that stand on the ball's upper half, evenly, and fall down its sides.
std::vector<HandStrand> braidsOnBall(int count)
{
    constexpr float kGoldenAngle = 2.3999632F;
    std::vector<HandStrand> strands;
    for (int i = 0; i < count; ++i) {
        const float up = 1.0F - (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        const float side = std::sqrt(1.0F - up * up);
        const float around = kGoldenAngle * static_cast<float>(i);
        const glm::vec3 out(side * cosDet(around), up, side * sinDet(around));
        strands.push_back({.rootHd = out * kBallM, .directionHd = out, .lengthM = 0.3F, .girthM = kGirthM});
    }
    return strands;
}

GroupDynamics braidGroup(const std::vector<HandStrand>& strands, const PhysicsSettings& physics = {})
{
    GroupDynamics hair;
    hair.setGroom(groomOf(strands, kNodes, physics), ballOfSkin(), WindField::calm({}));
    return hair;
}

/// As in a program: a few steps at a time.
void restBraids(GroupDynamics& hair, double seconds)
{
    const std::vector<StepForces> steps(8, WindField::calm({}));
    for (int i = 0; i < static_cast<int>(seconds / (8.0 * kStepSeconds)); ++i)
        hair.step(steps);
}

std::vector<glm::vec3> braidTips(const GroupDynamics& hair, std::size_t count)
{
    std::vector<glm::vec3> tips;
    for (std::size_t strand = 0; strand < count; ++strand)
        tips.push_back(nodeOf(hair, strand, kNodes - 1));
    return tips;
}

/// How near the axes of two strands come to each other from node `from` on, by sampling each segment.
float axesApartM(const GroupDynamics& hair, std::size_t a, std::size_t b, int from)
{
    constexpr int kSamples = 8;
    float nearest = 1.0F;
    const auto at = [&](std::size_t strand, int sample) {
        const int node = from + sample / kSamples;
        const glm::vec3 p = nodeOf(hair, strand, node);
        return node + 1 == kNodes ? p
                                  : p + (nodeOf(hair, strand, node + 1) - p) *
                                            (static_cast<float>(sample % kSamples) / static_cast<float>(kSamples));
    };
    const int samples = (kNodes - 1 - from) * kSamples;
    std::vector<glm::vec3> ofB;
    for (int i = 0; i <= samples; ++i)
        ofB.push_back(at(b, i));
    for (int i = 0; i <= samples; ++i) {
        const glm::vec3 p = at(a, i);
        for (const glm::vec3 q : ofB)
            nearest = std::min(nearest, glm::length(p - q));
    }
    return nearest;
}

/// Two that stand on opposite sides of the ball's top, at right angles, and fall over it.
std::vector<HandStrand> crossedRopes()
{
    const glm::vec3 left = glm::vec3(-0.5F, 0.8660254F, 0.0F) * kBallM;
    const glm::vec3 front = glm::vec3(0.0F, 0.8660254F, 0.5F) * kBallM;
    return {{.rootHd = left, .directionHd = {0.8660254F, 0.5F, 0.0F}, .lengthM = 0.3F, .girthM = kGirthM},
            {.rootHd = front, .directionHd = {0.0F, 0.5F, -0.8660254F}, .lengthM = 0.3F, .girthM = kGirthM}};
}

bool areFinite(const GroupDynamics& hair)
{
    return std::ranges::all_of(hair.state().now(), [](float f) { return std::isfinite(f); });
}

} // namespace

class TestBraidContact : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { setThreadCount(0); }
    void itLiesOnTheSkinWithItsSide();
    void itStartsOnTheSkinWithItsSide();
    void theGirthIsThatOfTheDrawnBraid();
    void crossedRopesLieOnEachOther();
    void aHundredKeepOffEachOther();
    void theyLieStillAndSleep();
    void rootsMayBeNearer();
    void heldInOneShapeTheyStay();
    void aStormLeavesThemFinite();
    void threadsMakeNoDifference();
    void otherHairHasNone();
};

void TestBraidContact::itLiesOnTheSkinWithItsSide()
{
    const float thickM = nearestM(0.015F, 240);
    QVERIFY2(thickM > 0.0145F, qPrintable(QString::number(thickM)));
    QVERIFY(thickM < 0.018F); // And it does lie there.
    QVERIFY(nearestM(0.0F, 240) < 0.003F);
    // Thicker than the skin's distances are known: as far as these go.
    QVERIFY(nearestM(0.05F, 240) > 0.02F);
}

void TestBraidContact::itStartsOnTheSkinWithItsSide()
{
    QVERIFY(nearestM(0.015F, 0) > 0.0125F);
}

void TestBraidContact::theGirthIsThatOfTheDrawnBraid()
{
    GroomInput input = inputOf(patch(), smallGroup());
    GroomBuilder builder;
    const auto free = builder.update(input).grooms.front();
    QVERIFY(std::ranges::all_of((*free->basis)[BasisQuantity::Girth], [](float girthM) { return girthM == 0.0F; }));

    auto& maps = input.groups[0].maps;
    maps[MapSlot::Braid] =
        withDab(maps[MapSlot::Braid], {0.4F, 0.6F}, 0.25F, {static_cast<std::uint16_t>(BraidKind::Plait)});
    const auto plait = builder.update(input).grooms.front();
    const auto thickest = std::ranges::max((*plait->basis)[BasisQuantity::Girth]);
    QVERIFY(thickest > 0.0F);
    QVERIFY(std::ranges::min((*plait->basis)[BasisQuantity::Girth]) == 0.0F); // Hair beside it.
    for (std::uint32_t slot = 0; slot < plait->roots->count(); ++slot) {
        const StrandStyle style = plait->style(slot);
        if (style.braid != BraidKind::None)
            QVERIFY(thickest >= style.braidRadiusM * (1.25F + kWispRadiusFraction) * 0.999F);
    }

    input.groups[0].settings.braidRadiusM *= 0.5F;
    const auto thin = builder.update(input).grooms.front();
    QCOMPARE(std::ranges::max((*thin->basis)[BasisQuantity::Girth]), thickest * 0.5F);
}

void TestBraidContact::crossedRopesLieOnEachOther()
{
    GroupDynamics hair = braidGroup(crossedRopes());
    restBraids(hair, 4.0);
    const float apart = axesApartM(hair, 0, 1, 2);
    QVERIFY2(apart > 0.9F * 2.0F * kGirthM, qPrintable(QString::number(apart)));
    QVERIFY2(apart < 1.3F * 2.0F * kGirthM, qPrintable(QString::number(apart)));
}

void TestBraidContact::aHundredKeepOffEachOther()
{
    constexpr std::size_t kCount = 100;
    GroupDynamics hair = braidGroup(braidsOnBall(kCount));
    restBraids(hair, 6.0);
    int near = 0;
    int deep = 0;
    float worst = 1.0F;
    for (std::size_t a = 0; a < kCount; ++a)
        for (std::size_t b = a + 1; b < kCount; ++b) {
            const float apart = axesApartM(hair, a, b, 2) / (2.0F * kGirthM);
            near += apart < 1.1F ? 1 : 0;
            deep += apart < 0.9F ? 1 : 0;
            worst = std::min(worst, apart);
        }
    qInfo() << "pairs that touch" << near << "deeper than a tenth" << deep << "nearest, of the girths' sum" << worst;
    QVERIFY(near > 100); // They do hang beside each other.
    QVERIFY2(deep <= near / 20, qPrintable(QString::number(deep)));
    QVERIFY2(worst > 0.5F, qPrintable(QString::number(worst)));
}

void TestBraidContact::theyLieStillAndSleep()
{
    constexpr std::size_t kCount = 100;
    GroupDynamics hair = braidGroup(braidsOnBall(kCount));
    restBraids(hair, 12.0);
    const std::vector<glm::vec3> before = braidTips(hair, kCount);
    restBraids(hair, 16.0);
    const std::vector<glm::vec3> after = braidTips(hair, kCount);
    float moved = 0.0F;
    for (std::size_t i = 0; i < kCount; ++i)
        moved = std::max(moved, glm::length(after[i] - before[i]));
    QVERIFY2(moved < 0.0005F, qPrintable(QString::number(moved)));
    QVERIFY(hair.asleep());
}

void TestBraidContact::rootsMayBeNearer()
{
    // Two that grow 2 mm apart, side by side.
    std::vector<HandStrand> strands;
    for (const float x : {-0.001F, 0.001F})
        strands.push_back(
            {.rootHd = {x, 0.0F, kBallM}, .directionHd = {0.0F, 0.0F, 1.0F}, .lengthM = 0.3F, .girthM = kGirthM});
    GroupDynamics hair = braidGroup(strands);
    restBraids(hair, 8.0);
    QVERIFY(hair.asleep());
    QVERIFY(glm::length(nodeOf(hair, 0, 1) - nodeOf(hair, 1, 1)) < kGirthM);
    QVERIFY(axesApartM(hair, 0, 1, 4) > 0.9F * 2.0F * kGirthM);
    QVERIFY(glm::length(nodeOf(hair, 0, kNodes - 1) - nodeOf(hair, 1, kNodes - 1)) < 4.0F * kGirthM);
}

void TestBraidContact::heldInOneShapeTheyStay()
{
    // Gel holds them where they were styled, one in the other.
    std::vector<HandStrand> strands;
    for (const float x : {-0.002F, 0.002F})
        strands.push_back({.rootHd = {x, kBallM, 0.0F},
                           .directionHd = {0.0F, 1.0F, 0.0F},
                           .lengthM = 0.2F,
                           .gel = 1.0F,
                           .girthM = kGirthM});
    GroupDynamics hair = braidGroup(strands);
    hair.reset();
    restBraids(hair, 2.0);
    QVERIFY(glm::length(nodeOf(hair, 0, kNodes - 1) - nodeOf(hair, 1, kNodes - 1)) < 0.006F);
}

void TestBraidContact::aStormLeavesThemFinite()
{
    GroupDynamics hair = braidGroup(braidsOnBall(24));
    WindField air;
    air.setWind({true, glm::vec3(13.0F, 3.0F, 7.0F), 0.8F, 0.6F});
    HeadPose before;
    for (int i = 0; i < 10000; ++i) {
        HeadPose pose;
        if (i % 600 < 200) // A nod.
            pose.rotation = glm::quat(1.0F, 0.3F * sinDet(0.03F * static_cast<float>(i % 600)), 0.0F, 0.0F);
        pose.rotation = glm::normalize(pose.rotation);
        const StepForces step = air.nextStep(before, pose);
        hair.step(std::span(&step, 1));
        before = pose;
    }
    QVERIFY(areFinite(hair));
    hair.wake();
    restBraids(hair, 16.0);
    QVERIFY(hair.asleep());
    for (std::size_t strand = 0; strand < 24; ++strand)
        QVERIFY(glm::length(nodeOf(hair, strand, kNodes - 1)) < 0.5F);
}

void TestBraidContact::threadsMakeNoDifference()
{
    AlignedFloats first;
    for (const int threads : {1, 2, 8}) {
        setThreadCount(threads);
        GroupDynamics hair = braidGroup(braidsOnBall(100));
        WindField air;
        air.setWind({true, glm::vec3(6.0F, 0.0F, 2.0F), 0.5F, 0.3F});
        for (int i = 0; i < 60; ++i) {
            const StepForces step = air.nextStep({}, {});
            hair.step(std::span(&step, 1));
        }
        restBraids(hair, 0.5);
        if (threads == 1)
            first = hair.state().now();
        else
            QVERIFY(first == hair.state().now());
    }
}

void TestBraidContact::otherHairHasNone()
{
    std::vector<HandStrand> strands = braidsOnBall(3);
    QVERIFY(braidGroup(strands).braids() != nullptr);
    for (HandStrand& strand : strands)
        strand.girthM = 0.0F;
    QVERIFY(braidGroup(strands).braids() == nullptr);
}

HAIRPAINT_TEST(TestBraidContact, None)
#include "test_braid_contact.moc"
