// Hair against hair: it keeps out of denser hair and moves along with the hair around, and is still at rest.
#include "hanging_hair.h"

#include "sim/base/parallel.h"
#include "sim/groom/direction_texel.h"
#include "sim/motion/simulation.h"
#include "tests/support/painted_ball.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr int kLayerNodes = 10;

/// Basis hairs of which each stands for `hairs` drawn ones.
std::shared_ptr<const Groom> crowdOf(const std::vector<HandStrand>& strands, std::size_t hairs,
                                     const PhysicsSettings& physics)
{
    std::vector<HandStrand> all;
    for (std::size_t i = 0; i < hairs; ++i)
        all.insert(all.end(), strands.begin(), strands.end());
    const std::shared_ptr<Groom> groom = drawnGroomOf(all, kLayerNodes, physics);
    groom->basis = basisOf(strands, kLayerNodes);
    groom->basisCount = strands.size();
    auto roots = std::make_shared<RootSet>(*groom->roots);
    roots->basisSlot.resize(strands.size());
    for (std::size_t slot = 0; slot < all.size(); ++slot) {
        const auto nearest = static_cast<std::uint32_t>(slot % strands.size());
        roots->neighbours[slot] = {nearest, nearest, nearest};
    }
    groom->roots = std::move(roots);
    return groom;
}

/// Limp hair grows sideways just over thicker hair that gel holds: the first kHeld strands.
constexpr std::size_t kLimp = 64;
constexpr std::size_t kHeld = 4 * kLimp;
std::shared_ptr<const Groom> twoLayers(float body)
{
    PhysicsSettings physics;
    physics.stiffnessM = 0.08F;
    physics.volumeM = 0.0F;
    physics.body = body;
    std::vector<HandStrand> strands;
    for (const bool isHeld : {true, false})
        for (int y = 0; y < 4; ++y)
            for (int z = -8; z < 8; ++z)
                for (int i = 0; i < (isHeld ? 4 : 1); ++i)
                    strands.push_back({.rootHd = {0.0F, 0.004F * static_cast<float>(y) + (isHeld ? 0.0F : 0.022F),
                                                  0.004F * static_cast<float>(z)},
                                       .directionHd = {1.0F, 0.0F, 0.0F},
                                       .lengthM = 0.12F,
                                       .gel = isHeld ? 1.0F : 0.0F});
    return crowdOf(strands, 200, physics);
}

/// From the rest shape on.
std::unique_ptr<GroupDynamics> fallenLayers(float body, int steps)
{
    auto hair = std::make_unique<GroupDynamics>();
    hair->setGroom(twoLayers(body), prepareColliders({}), WindField::calm({}));
    hair->reset();
    fall(*hair, steps);
    return hair;
}

float heightOfLimp(const GroupDynamics& hair)
{
    float sum = 0.0F;
    for (std::size_t i = 0; i < kLimp; ++i)
        sum += nodeOf(hair, kHeld + i, kLayerNodes - 1).y;
    return sum / static_cast<float>(kLimp);
}

bool sameMotion(const GroupDynamics& a, const GroupDynamics& b)
{
    const AlignedFloats& left = a.state().now();
    const AlignedFloats& right = b.state().now();
    return left.size() == right.size() && std::memcmp(left.data(), right.data(), left.size() * sizeof(float)) == 0;
}

GroomInput coatedBall(float body)
{
    GroomInput input = paintedBall(8000, 1024);
    input.groups.front().settings.physics.body = body;
    input.groups.front().settings.physics.volumeM = 0.015F;
    input.groups.front().settings.greatestLengthM = 0.08F;
    input.groups.front().maps[MapSlot::Direction] = mapOfTexel(2, texelOfDirection({0.0F, -0.9F}));
    return input;
}

/// Height over the skin below which three quarters of the nodes on the ball's upper half lie, m.
float coatThickness(const Simulation& simulation)
{
    StrandFrame frame;
    simulation.writeFrame(frame);
    const GroupFrame& group = frame.groups.front();
    std::vector<float> heights;
    for (std::size_t slot = 0; slot < group.groom->chunks.size() * kChunkSlots; ++slot) {
        if (!group.isPositioned(slot))
            continue;
        for (std::size_t node = 1; node < static_cast<std::size_t>(group.groom->nodes); ++node) {
            const glm::vec3 p = group.groom->blocks().node(group.positions, group.groom->frameStrand(slot), node);
            if (p.y > 0.0F)
                heights.push_back(glm::length(p) - 0.1F);
        }
    }
    const auto at = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() * 3 / 4);
    std::nth_element(heights.begin(), at, heights.end());
    return *at;
}

} // namespace

class TestBody : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup();
    void withoutItThereIsNoGrid();
    void aLayerSinksLessIntoAnother();
    void aLockDragsItsNeighbours();
    void theCoatKeepsItsThickness();
    void besideAPartingTheCoatLiesAsAtRest();
    void onAShoulderItDoesNotStandOffToTheSide();
    void atRestNothingCreepsAndNoGridIsMade();
    void aStormOfTenMinutesStaysBounded();
    void threadsMakeNoDifference();
    void threadsMakeNoDifferenceToCoilsInLocksBesideAParting();
    void instructionSetsMakeNoDifference();
    void howManyStepsAreTakenAtOnceMakesNoDifference();
};

void TestBody::cleanup()
{
    setThreadCount(0);
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

void TestBody::withoutItThereIsNoGrid()
{
    GroupDynamics hair;
    hair.setGroom(twoLayers(0.5F), prepareColliders({}), WindField::calm({}));
    QVERIFY(hair.body() != nullptr);
    hair.setGroom(twoLayers(0.0F), prepareColliders({}), WindField::calm({}));
    QVERIFY(hair.body() == nullptr);
}

void TestBody::aLayerSinksLessIntoAnother()
{
    const auto sunk = fallenLayers(0.0F, 600);
    const auto lying = fallenLayers(0.5F, 600);
    // The limp layer begins 2.2 cm above the other, whose hairs lie up to 1.2 cm high.
    QVERIFY2(heightOfLimp(*sunk) < -0.017F, qPrintable(QString::number(heightOfLimp(*sunk))));
    QVERIFY2(heightOfLimp(*lying) > -0.0125F, qPrintable(QString::number(heightOfLimp(*lying))));
}

void TestBody::aLockDragsItsNeighbours()
{
    // A curtain of which the air moves one side.
    std::vector<HandStrand> strands;
    strands.reserve(32);
    for (int z = 0; z < 32; ++z)
        strands.push_back({.rootHd = {0.0F, 0.2F, 0.004F * static_cast<float>(z)},
                           .directionHd = {0.0F, -1.0F, 0.0F},
                           .lengthM = 0.2F});
    StepForces forces = WindField::calm({});
    forces.windy = true;
    forces.puffCount = 1;
    constexpr float kRadiusM = 0.06F;
    forces.puffs[0] = {
        .centre = {0.0F, 0.05F, 0.0F}, .velocity = {0.02F, 0.0F, 0.0F}, .inverseRadius2 = 1.0F / (kRadiusM * kRadiusM)};
    const auto movedBeside = [&](float body) {
        PhysicsSettings physics;
        physics.body = body;
        GroupDynamics hair;
        hair.setGroom(crowdOf(strands, 50, physics), prepareColliders({}), WindField::calm({}));
        float furthest = 0.0F;
        for (int i = 0; i < 120; ++i) {
            hair.step(std::span(&forces, 1));
            furthest = std::max(furthest, nodeOf(hair, 15, kLayerNodes - 1).x); // In still air.
        }
        return furthest;
    };
    QVERIFY2(movedBeside(0.0F) < 1e-5F, qPrintable(QString::number(movedBeside(0.0F))));
    QVERIFY2(movedBeside(0.5F) > 1.5e-4F, qPrintable(QString::number(movedBeside(0.5F))));
}

void TestBody::theCoatKeepsItsThickness()
{
    Simulation flat;
    flat.setInput(coatedBall(0.0F));
    flat.settle(4.0);
    Simulation simulation;
    simulation.setInput(coatedBall(0.5F));
    simulation.reset();
    const float restM = coatThickness(simulation);
    QVERIFY(coatThickness(flat) < 0.85F * restM);
    const auto keeps = [&] { return std::abs(coatThickness(simulation) / restM - 1.0F) < 0.1F; };
    simulation.settle(4.0);
    QVERIFY(keeps());
    for (int i = 1; i <= 60; ++i) {
        simulation.setPose({glm::angleAxis(0.4F * std::sin(0.1047F * static_cast<float>(i)), glm::vec3(1, 0, 0)), {}});
        simulation.advance(1.0 / 60.0);
    }
    simulation.setPose({});
    simulation.settle(3.0);
    QVERIFY(keeps());
    simulation.setWind({true, glm::vec3(8.0F, 0.0F, -12.0F), 0.5F, 0.4F});
    simulation.settle(4.0);
    simulation.setWind({});
    simulation.settle(4.0);
    QVERIFY(keeps());
}

void TestBody::besideAPartingTheCoatLiesAsAtRest()
{
    // Hair leaves the top of a ball to both sides: no hair lies beneath its first nodes, which were once held up by 7
    // mm.
    constexpr float kBallM = 0.1F;
    std::vector<HandStrand> strands;
    for (const float side : {-1.0F, 1.0F})
        for (int i = 0; i < 8; ++i)
            strands.push_back({.rootHd = {0.001F * side, kBallM, 0.004F * static_cast<float>(i - 4)},
                               .directionHd = {side, 0.0F, 0.0F},
                               .lengthM = 0.2F});
    PhysicsSettings physics;
    physics.body = 0.5F;
    physics.volumeM = 0.01F;
    physics.loft = 0.8F;
    physics.stiffnessM = 0.02F;
    GroupDynamics hair;
    hair.setGroom(crowdOf(strands, 1, physics), prepareColliders({}, DistanceGrid::make(makeBallHead(64, kBallM))),
                  WindField::calm({}));
    hair.reset();
    fall(hair, 240);
    constexpr float kSegmentM = 0.2F / (kLayerNodes - 1);
    const float restM = std::sqrt(kBallM * kBallM + kSegmentM * kSegmentM) - kBallM;
    for (std::size_t i = 0; i < strands.size(); ++i) {
        const float firstM = glm::length(nodeOf(hair, i, 1)) - kBallM;
        QVERIFY2(firstM < restM + 0.0035F, qPrintable(QString::number(firstM)));
        // Further on the hair of the sides carries it as before.
        const float secondM = glm::length(nodeOf(hair, i, 2)) - kBallM;
        QVERIFY2(secondM > 0.8F * 0.0085F, qPrintable(QString::number(secondM)));
    }
}

void TestBody::onAShoulderItDoesNotStandOffToTheSide()
{
    // Long hair comes down on one side of a ball that is a shoulder.
    std::vector<HandStrand> strands;
    strands.reserve(32);
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 8; ++i)
            strands.push_back(
                {.rootHd = {0.03F + 0.001F * static_cast<float>(i), 0.3F, 0.004F * static_cast<float>(row)},
                 .directionHd = {0.0F, -1.0F, 0.0F},
                 .lengthM = 0.4F});
    const ColliderSet shoulder = prepareColliders({}, DistanceGrid::make(makeBallHead(64, 0.1F)));
    const auto reach = [&](float body) {
        PhysicsSettings physics;
        physics.body = body;
        physics.friction = 0.1F;
        GroupDynamics hair;
        hair.setGroom(crowdOf(strands, 1, physics), shoulder, WindField::calm({}));
        hair.reset();
        fall(hair, 240);
        float sum = 0.0F;
        for (std::size_t i = 0; i < strands.size(); ++i)
            sum += nodeOf(hair, i, kLayerNodes - 1).x;
        return sum / static_cast<float>(strands.size());
    };
    QVERIFY2(reach(0.0F) > 0.07F, qPrintable(QString::number(reach(0.0F))));
    QVERIFY2(reach(0.5F) < 0.05F, qPrintable(QString::number(reach(0.5F))));
}

void TestBody::atRestNothingCreepsAndNoGridIsMade()
{
    auto hair = fallenLayers(0.5F, 600);
    std::vector<glm::vec3> tips;
    for (std::size_t i = 0; i < kHeld + kLimp; ++i)
        tips.push_back(nodeOf(*hair, i, kLayerNodes - 1));
    fall(*hair, 16 * 120);
    for (std::size_t i = 0; i < tips.size(); ++i)
        QVERIFY(glm::length(nodeOf(*hair, i, kLayerNodes - 1) - tips[i]) < 5e-4F);
    QVERIFY(hair->asleep());
    const std::uint64_t grids = hair->body()->gridsMade();
    fall(*hair, 120);
    QCOMPARE(hair->body()->gridsMade(), grids);
}

void TestBody::aStormOfTenMinutesStaysBounded()
{
    GroomInput input = paintedBall(2000, 256);
    input.groups.front().settings.physics.body = 1.0F;
    input.groups.front().settings.greatestDensityPerM2 = 4e6F;
    input.maxHairs = 2000;
    Simulation simulation;
    simulation.setInput(input);
    simulation.setWind({true, glm::vec3(14.0F, 3.0F, -12.0F), 1.0F, 1.0F});
#ifdef HAIRPAINT_TSAN
    simulation.settle(30.0); // Races show in less, and each step takes thirty times as long.
#else
    simulation.settle(600.0);
#endif
    StrandFrame frame;
    simulation.writeFrame(frame);
    for (const float x : frame.groups.front().positions)
        QVERIFY(std::abs(x) < 0.1F + 0.2F + 0.01F); // Not true of what is no number.
}

void TestBody::threadsMakeNoDifference()
{
    setThreadCount(1);
    const auto one = fallenLayers(0.5F, 60);
    for (const int threads : {2, 8}) {
        setThreadCount(threads);
        QVERIFY(sameMotion(*one, *fallenLayers(0.5F, 60)));
    }
}

void TestBody::threadsMakeNoDifferenceToCoilsInLocksBesideAParting()
{
    GroomInput input = coatedBall(0.5F);
    GroupSettings& settings = input.groups.front().settings;
    settings.turnsMode = TurnsMode::Coils;
    settings.lengthAsCut = true;
    settings.curl = {.inStepFromM = 0.015F, .switchbacksPerM = 5.0F, .skips = 0.06F, .uncoil = 0.15F, .gather = 0.85F};
    settings.locks = {
        .sizeM = 0.02F, .small = 0.4F, .flatness = 0.3F, .twistsPerM = 5.0F, .ragged = 0.5F, .parting = 0.3F};
    settings.variation = {
        .length = 0.08F, .curl = 0.12F, .width = 0.2F, .crossing = 0.08F, .flyaways = 0.012F, .parting = 0.004F};
    settings.physics.volumeRiseM = 0.05F;
    input.groups.front().maps[MapSlot::Curl] = mapOfTexel(1, {65535});
    // Away from the line between the halves.
    auto parted = std::make_shared<TiledRaster>(*input.groups.front().maps[MapSlot::Direction]);
    for (int y = 0; y < parted->size(); ++y)
        for (int x = 0; x < parted->size(); ++x)
            parted->setTexel(x, y, texelOfDirection({x < parted->size() / 2 ? -0.9F : 0.9F, 0.0F}));
    input.groups.front().maps[MapSlot::Direction] = parted;
    const auto moved = [&](int threads) {
        setThreadCount(threads);
        Simulation simulation;
        simulation.setInput(input);
        simulation.setWind({true, glm::vec3(5.0F, 1.0F, 2.0F), 0.5F, 0.4F});
        simulation.settle(0.25);
        StrandFrame frame;
        simulation.writeFrame(frame);
        return std::vector<float>(frame.groups.front().positions.begin(), frame.groups.front().positions.end());
    };
    const std::vector<float> one = moved(1);
    for (const int threads : {2, 8})
        QVERIFY(moved(threads) == one);
}

void TestBody::instructionSetsMakeNoDifference()
{
    const auto best = fallenLayers(0.5F, 60);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        QVERIFY2(sameMotion(*best, *fallenLayers(0.5F, 60)), hwy::TargetName(target));
    }
}

void TestBody::howManyStepsAreTakenAtOnceMakesNoDifference()
{
    const auto single = fallenLayers(0.5F, 63);
    const auto many = fallenLayers(0.5F, 0);
    const std::vector<StepForces> calm(7, WindField::calm({}));
    for (int i = 0; i < 9; ++i)
        many->step(calm);
    QVERIFY(sameMotion(*single, *many));
}

HAIRPAINT_TEST(TestBody, None)
#include "test_body.moc"
