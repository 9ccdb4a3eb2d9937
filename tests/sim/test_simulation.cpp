// What the whole simulation promises: the same bytes however it is cut up, strands that a dab leaves alone, sleep.
#include "sim/base/deterministic.h"
#include "sim/base/parallel.h"
#include "sim/motion/simulation.h"
#include "tests/support/painted_ball.h"
#include "tests/support/strand_frames.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr int kHairs = 3000;
constexpr int kBasis = 700;
const Wind kBreeze{true, glm::vec3(3.0F, 0.5F, 1.0F), 0.5F, 0.4F};

bool sameBytes(const StrandFrame& a, const StrandFrame& b)
{
    if (a.groups.size() != b.groups.size())
        return false;
    for (std::size_t i = 0; i < a.groups.size(); ++i) {
        const std::vector<float>& p = a.groups[i].positions;
        const std::vector<float>& q = b.groups[i].positions;
        if (p.size() != q.size() || std::memcmp(p.data(), q.data(), p.size() * sizeof(float)) != 0)
            return false;
    }
    return true;
}

/// A simulation in wind for a while, with a turn of the head.
void live(Simulation& simulation, const std::vector<double>& slices)
{
    simulation.setWind(kBreeze);
    for (const double slice : slices)
        simulation.advance(slice);
}

} // namespace

class TestSimulation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { setThreadCount(0); }
    void theSameTimeInOtherSlicesGivesTheSameHair_data();
    void theSameTimeInOtherSlicesGivesTheSameHair();
    void anyNumberOfThreadsGivesTheSameBytes_data();
    void anyNumberOfThreadsGivesTheSameBytes();
    void aDabLeavesAllOtherStrandsUndisturbed_data();
    void aDabLeavesAllOtherStrandsUndisturbed();
    void paintedHairStartsHangingStill();
    void hairThatGrowsIsStretchedAboutItsRoot();
    void stillHairFallsAsleepAndWakes_data();
    void stillHairFallsAsleepAndWakes();
    void inputThatDiffersElsewhereLeavesHairAsleep();
    void longHairAtTheEdgeOfACutHangs();
    void aHiddenGroupHasNoPositions();
    void resetGivesTheRestShape();
    void rootsFollowTheHead();
    void aTurnOfTheHeadSwingsTheHair();
    void strandsStayOutsideTheSkinWithoutAnEllipsoid();
    void nonsenseIsIgnored();
    void moreCandidatesKeepTheMotionOfTheOthers();
};

void TestSimulation::theSameTimeInOtherSlicesGivesTheSameHair_data()
{
    QTest::addColumn<int>("framesPerSecond");
    QTest::newRow("24 frames a second") << 24;
    QTest::newRow("30 frames a second") << 30;
    QTest::newRow("144 frames a second") << 144;
    QTest::newRow("240 frames a second") << 240;
}

void TestSimulation::theSameTimeInOtherSlicesGivesTheSameHair()
{
    constexpr int kSeconds = 10;
    QFETCH(int, framesPerSecond);
    const auto slicesAt = [](int perSecond) {
        return std::vector<double>(static_cast<std::size_t>(kSeconds * perSecond), 1.0 / perSecond);
    };
    const GroomInput input = paintedBall(kHairs, kBasis);
    Simulation a;
    Simulation b;
    a.setInput(input);
    b.setInput(input);
    live(a, slicesAt(60));
    live(b, slicesAt(framesPerSecond));
    const StrandFrame frameA = frameOf(a);
    const StrandFrame frameB = frameOf(b);
    QCOMPARE(frameB.simulatedSeconds, frameA.simulatedSeconds);
    // What is left of the last step differs by rounding, so the moment shown does.
    double furthest = 0.0;
    for (std::size_t i = 0; i < frameA.groups.front().positions.size(); ++i)
        furthest = std::max(furthest, std::abs(static_cast<double>(frameA.groups.front().positions[i]) -
                                               static_cast<double>(frameB.groups.front().positions[i])));
    QVERIFY2(furthest < 1e-5, qPrintable(QString::number(furthest)));
}

void TestSimulation::anyNumberOfThreadsGivesTheSameBytes_data()
{
    QTest::addColumn<int>("threads");
    QTest::newRow("two") << 2;
    QTest::newRow("eight") << 8;
}

void TestSimulation::anyNumberOfThreadsGivesTheSameBytes()
{
    QFETCH(int, threads);
    const auto run = [](int count) {
        setThreadCount(count);
        Simulation simulation;
        simulation.setInput(paintedBall(kHairs, kBasis));
        live(simulation, std::vector<double>(40, 1.0 / 60.0));
        return frameOf(simulation);
    };
    const StrandFrame one = run(1);
    const StrandFrame many = run(threads);
    QVERIFY(sameBytes(one, many));
}

void TestSimulation::aDabLeavesAllOtherStrandsUndisturbed_data()
{
    QTest::addColumn<bool>("windy");
    QTest::addColumn<bool>("density");
    QTest::newRow("length in wind") << true << false;
    QTest::newRow("length, at rest") << false << false;
    QTest::newRow("density in wind") << true << true;
    QTest::newRow("density, at rest") << false << true;
}

void TestSimulation::aDabLeavesAllOtherStrandsUndisturbed()
{
    QFETCH(bool, windy);
    QFETCH(bool, density);
    const GroomInput input = paintedBall(kHairs, kBasis);
    GroomInput dabbed = input;
    paintSquare(density ? dabbed.groups.front().maps[MapSlot::Density] : dabbed.groups.front().maps[MapSlot::Length],
                {0.4F, 0.4F}, {0.6F, 0.6F}, density ? 0 : 30000);
    Simulation touched;
    Simulation untouched;
    for (Simulation* simulation : {&touched, &untouched}) {
        simulation->setInput(input);
        simulation->setWind(windy ? kBreeze : Wind{});
        for (int i = 0; i < 20; ++i)
            simulation->advance(1.0 / 60.0);
    }
    touched.setInput(dabbed);
    for (Simulation* simulation : {&touched, &untouched}) {
        for (int i = 0; i < 20; ++i)
            simulation->advance(1.0 / 60.0);
    }
    const StrandFrame a = frameOf(untouched);
    const StrandFrame b = frameOf(touched);
    const RootSet& roots = *a.groups.front().groom->roots;
    std::size_t compared = 0;
    for (std::size_t slot = 0; slot < roots.count(); ++slot) {
        // Hairs in the square, and those that lie on a basis hair in it, may move.
        bool near = false;
        for (const std::uint32_t basis : roots.neighbours[slot]) {
            const glm::vec2 uv = roots.uv[roots.basisSlot[basis]];
            near = near || (std::abs(uv.x - 0.5F) < 0.11F && std::abs(uv.y - 0.5F) < 0.11F);
        }
        const glm::vec2 uv = roots.uv[slot];
        if (near || (std::abs(uv.x - 0.5F) < 0.11F && std::abs(uv.y - 0.5F) < 0.11F))
            continue;
        const std::vector<glm::vec3> was = nodesOf(a, slot);
        if (was.empty())
            continue;
        QVERIFY(was == nodesOf(b, slot));
        ++compared;
    }
    QVERIFY(compared > kHairs / 2);
}

void TestSimulation::paintedHairStartsHangingStill()
{
    GroomInput input = paintedBall(kHairs, kBasis);
    input.groups.front().maps[MapSlot::Density] = mapOfTexel(1, {0});
    Simulation simulation;
    simulation.setInput(input);
    QCOMPARE(frameOf(simulation).hairCount, std::size_t{0});
    input.groups.front().maps[MapSlot::Density] = mapOfTexel(1, {65535});
    simulation.setInput(input);
    const StrandFrame before = frameOf(simulation);
    simulation.advance(1.0 / 30.0);
    const StrandFrame after = frameOf(simulation);
    QVERIFY(after.hairCount > 0);
    double sum = 0.0;
    double hangs = 0.0;
    for (std::size_t slot = 0; slot < kHairs; ++slot) {
        const std::vector<glm::vec3> a = nodesOf(before, slot);
        const std::vector<glm::vec3> b = nodesOf(after, slot);
        sum += static_cast<double>(glm::distance(a.back(), b.back()));
        hangs += static_cast<double>(b.front().y - b.back().y);
    }
    QVERIFY2(sum / kHairs < 0.004, qPrintable(QString::number(sum / kHairs)));
    QVERIFY2(hangs / kHairs > 0.1, qPrintable(QString::number(hangs / kHairs)));
}

void TestSimulation::hairThatGrowsIsStretchedAboutItsRoot()
{
    GroomInput input = paintedBall(kHairs, kHairs);
    input.groups.front().maps[MapSlot::Length] = mapOfTexel(1, {32768});
    Simulation simulation;
    simulation.setInput(input);
    const StrandFrame before = frameOf(simulation);
    input.groups.front().maps[MapSlot::Length] = mapOfTexel(1, {65535});
    simulation.setInput(input);
    const StrandFrame after = frameOf(simulation);
    int stretched = 0;
    for (std::size_t slot = 0; slot < kHairs; ++slot) {
        const std::vector<glm::vec3> a = nodesOf(before, slot);
        const std::vector<glm::vec3> b = nodesOf(after, slot);
        const glm::vec3 expected = a.front() + (a.back() - a.front()) * (65535.0F / 32768.0F);
        stretched += glm::distance(expected, b.back()) < 0.02F ? 1 : 0;
    }
    QVERIFY(stretched > kHairs * 9 / 10);
}

void TestSimulation::stillHairFallsAsleepAndWakes_data()
{
    QTest::addColumn<int>("by");
    QTest::newRow("wind") << 0;
    QTest::newRow("a turned head") << 1;
    QTest::newRow("a puff") << 2;
    QTest::newRow("a dab") << 3;
    QTest::newRow("other physics") << 4;
}

void TestSimulation::stillHairFallsAsleepAndWakes()
{
    QFETCH(int, by);
    GroomInput input = paintedBall(600, 600);
    Simulation simulation;
    simulation.setInput(input);
    QVERIFY(!simulation.asleep());
    for (int i = 0; i < 60 * 60 && !simulation.asleep(); ++i)
        simulation.advance(1.0 / 60.0);
    QVERIFY(simulation.asleep());
    QVERIFY(frameOf(simulation).asleep);
    const StrandFrame before = frameOf(simulation);
    simulation.advance(1.0);
    QVERIFY(sameBytes(before, frameOf(simulation)));
    switch (by) {
    case 0:
        simulation.setWind(kBreeze);
        break;
    case 1:
        simulation.setPose({glm::quat(0.9848F, 0.0F, 0.1736F, 0.0F), glm::vec3(0.0F)});
        break;
    case 2:
        simulation.puff(glm::vec3(0.1F, 0.0F, 0.0F), glm::vec3(0.0F, 0.0F, 5.0F), 0.1F);
        break;
    case 3:
        paintSquare(input.groups.front().maps[MapSlot::Length], {0.4F, 0.4F}, {0.6F, 0.6F}, 30000);
        simulation.setInput(input);
        break;
    default:
        input.groups.front().settings.physics.gravityScale = 0.2F;
        simulation.setInput(input);
    }
    QVERIFY(!simulation.asleep());
    for (int i = 0; i < 10; ++i)
        simulation.advance(1.0 / 60.0);
    QVERIFY(!sameBytes(before, frameOf(simulation)));
}

void TestSimulation::inputThatDiffersElsewhereLeavesHairAsleep()
{
    Simulation simulation;
    GroomInput input = paintedBall(kHairs, kBasis);
    simulation.setInput(input);
    simulation.settle(60.0);
    QVERIFY(simulation.asleep());
    StrandFrame before;
    simulation.writeFrame(before);
    input.revision = 2;
    simulation.setInput(input);
    QVERIFY(simulation.asleep());
    StrandFrame after;
    simulation.writeFrame(after);
    QCOMPARE(after.revision, std::uint64_t{2});
    QVERIFY(sameBytes(before, after));
    // What hair collides with does wake it.
    input.colliders.front().semiAxesM *= 1.01F;
    simulation.setInput(input);
    QVERIFY(!simulation.asleep());
}

void TestSimulation::longHairAtTheEdgeOfACutHangs()
{
    /// Over the hair that stays long on the upper half: the greatest distance of a tip from the ball's axis, and the
    /// greatest height of a tip over its root; m.
    const auto reachOf = [](bool cut) {
        GroomInput input = paintedBall(6000, 500);
        if (cut) // A band of stubble, along whose edges the nearest basis hairs are short.
            paintSquare(input.groups.front().maps[MapSlot::Length], {0.1F, 0.55F}, {0.9F, 0.7F}, 1000);
        Simulation simulation;
        simulation.setInput(input);
        simulation.settle(3.0);
        const StrandFrame frame = frameOf(simulation);
        const Groom& groom = *frame.groups.front().groom;
        glm::vec2 reach(-1.0F);
        for (std::size_t slot = 0; slot < groom.roots->count(); ++slot) {
            const std::vector<glm::vec3> nodes = nodesOf(frame, slot);
            const float rootY = groom.roots->positionHd[slot].y;
            if (nodes.empty() || groom.chunks[chunkOf(slot)]->styles[inChunk(slot)].lengthM < 0.18F || rootY < 0.0F ||
                rootY > 0.09F)
                continue;
            const glm::vec3 tip = nodes.back();
            reach = glm::max(reach, glm::vec2(glm::length(glm::vec2(tip.x, tip.z)), tip.y - rootY));
        }
        return reach;
    };
    const glm::vec2 uncut = reachOf(false);
    const glm::vec2 cut = reachOf(true);
    QVERIFY(uncut.y < 0.0F && cut.y < 0.0F);
    // A shape is scaled from basis hairs of up to two times another length.
    QVERIFY2(cut.x < uncut.x + 0.06F, qPrintable(QStringLiteral("%1 %2").arg(cut.x).arg(uncut.x)));
}

void TestSimulation::aHiddenGroupHasNoPositions()
{
    Simulation simulation;
    GroomInput input = paintedBall(kHairs, kBasis);
    simulation.setInput(input);
    StrandFrame frame;
    simulation.writeFrame(frame);
    const StrandFrame shown = frame;
    QVERIFY(!shown.groups.front().positions.empty());
    input.groups.front().visible = false;
    simulation.setInput(input);
    simulation.writeFrame(frame);
    QVERIFY(frame.groups.front().positions.empty());
    QVERIFY(simulation.asleep()); // So no frames are made for it.
    QCOMPARE(frame.hairCount, shown.hairCount);
    input.groups.front().visible = true;
    simulation.setInput(input);
    simulation.writeFrame(frame);
    QVERIFY(sameBytes(frame, shown));
}

void TestSimulation::resetGivesTheRestShape()
{
    Simulation simulation;
    simulation.setInput(paintedBall(kHairs, kBasis));
    live(simulation, std::vector<double>(10, 1.0 / 60.0));
    simulation.reset();
    const StrandFrame frame = frameOf(simulation);
    const RootSet& roots = *frame.groups.front().groom->roots;
    for (std::size_t slot = 0; slot < roots.count(); ++slot) {
        const std::vector<glm::vec3> nodes = nodesOf(frame, slot);
        const glm::vec3 tip = roots.positionHd[slot] + roots.normalHd[slot] * 0.2F;
        QVERIFY(glm::distance(nodes.back(), tip) < 1e-4F);
    }
}

void TestSimulation::rootsFollowTheHead()
{
    Simulation simulation;
    simulation.setInput(paintedBall(kHairs, kBasis));
    const HeadPose pose{glm::quat(0.8F, 0.0F, 0.6F, 0.0F), glm::vec3(0.3F, 1.0F, -0.5F)};
    simulation.setPose(pose);
    for (int i = 0; i < 10; ++i)
        simulation.advance(1.0 / 60.0);
    const StrandFrame frame = frameOf(simulation);
    const RootSet& roots = *frame.groups.front().groom->roots;
    for (std::size_t slot = 0; slot < roots.count(); ++slot) {
        const glm::vec3 expected = pose.rotation * roots.positionHd[slot] + pose.positionWo;
        QVERIFY(glm::distance(nodesOf(frame, slot).front(), expected) < 1e-5F);
    }
}

void TestSimulation::aTurnOfTheHeadSwingsTheHair()
{
    Simulation simulation;
    simulation.setInput(paintedBall(kHairs, kBasis));
    const StrandFrame before = frameOf(simulation);
    // A jerk sideways: for a moment the tips stay behind in the world while the roots go along.
    for (int i = 1; i <= 3; ++i) {
        simulation.setPose({glm::quat(1.0F, 0.0F, 0.0F, 0.0F), glm::vec3(0.02F * static_cast<float>(i), 0.0F, 0.0F)});
        simulation.advance(1.0 / 60.0);
    }
    const StrandFrame after = frameOf(simulation);
    double tips = 0.0;
    std::size_t count = 0;
    for (std::size_t slot = 0; slot < kHairs; ++slot) {
        const std::vector<glm::vec3> a = nodesOf(before, slot);
        const std::vector<glm::vec3> b = nodesOf(after, slot);
        if (a.back().y < -0.12F) { // hangs free below the ball
            tips += static_cast<double>(b.back().x - a.back().x);
            ++count;
        }
    }
    QVERIFY(count > 100);
    QVERIFY2(tips / static_cast<double>(count) < 0.035, qPrintable(QString::number(tips / static_cast<double>(count))));
}

void TestSimulation::strandsStayOutsideTheSkinWithoutAnEllipsoid()
{
    /// The greatest depth of nodes and middles of segments in the ball, m.
    const auto deepest = [](bool withSkin) {
        GroomInput input = paintedBall(2000, 400);
        input.colliders.clear();
        if (!withSkin)
            input.distances = nullptr;
        Simulation simulation;
        simulation.setInput(input);
        simulation.setWind({true, glm::vec3(9.0F, 0.0F, -4.0F), 0.5F, 0.3F});
        for (int i = 0; i < 60; ++i)
            simulation.advance(1.0 / 60.0);
        StrandFrame frame;
        simulation.writeFrame(frame);
        const std::vector<float>& positions = frame.groups.front().positions;
        const StrandBlocks blocks = frame.groups.front().groom->blocks();
        const std::size_t strands = positions.size() / blocks.blockFloats() * kLanes;
        float depth = 0.0F;
        for (std::size_t strand = 0; strand < strands; ++strand)
            for (int node = 1; node < frame.groups.front().groom->nodes; ++node) {
                const glm::vec3 parent = blocks.node(positions, strand, static_cast<std::size_t>(node) - 1);
                const glm::vec3 child = blocks.node(positions, strand, static_cast<std::size_t>(node));
                if (child == glm::vec3(0.0F))
                    continue; // No hair.
                for (const glm::vec3& position : {0.5F * (parent + child), child})
                    depth = std::max(depth, 0.1F - glm::length(position));
            }
        return depth;
    };
    QVERIFY(deepest(false) > 0.02F);
    QVERIFY2(deepest(true) < 0.0015F, qPrintable(QString::number(deepest(true))));
}

void TestSimulation::nonsenseIsIgnored()
{
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    Simulation simulation;
    simulation.setInput(paintedBall(600, 600));
    simulation.setWind({true, glm::vec3(kNan), kNan, kNan});
    simulation.setPose({glm::quat(kNan, 0.0F, 0.0F, 0.0F), glm::vec3(kNan)});
    simulation.puff(glm::vec3(kNan), glm::vec3(1.0F), kNan);
    simulation.advance(std::numeric_limits<double>::quiet_NaN());
    simulation.advance(-1.0);
    simulation.advance(1e30);
    simulation.settle(-1.0);
    const StrandFrame frame = frameOf(simulation);
    QVERIFY(frame.simulatedSeconds <= 8.001 * kStepSeconds);
    for (const float value : frame.groups.front().positions)
        QVERIFY(std::isfinite(value));
}

void TestSimulation::moreCandidatesKeepTheMotionOfTheOthers()
{
    GroomInput input = paintedBall(1000, 500);
    Simulation simulation;
    simulation.setInput(input);
    live(simulation, std::vector<double>(30, 1.0 / 60.0));
    const StrandFrame before = frameOf(simulation);
    input.groups.front().settings.greatestDensityPerM2 *= 2.0F;
    simulation.setInput(input);
    const StrandFrame after = frameOf(simulation);
    const RootSet& old = *before.groups.front().groom->roots;
    const RootSet& now = *after.groups.front().groom->roots;
    QVERIFY(now.count() > old.count());
    for (std::uint32_t rank = 0; rank < 500; ++rank) {
        const std::vector<glm::vec3> a = nodesOf(before, old.slotOfRank[rank]);
        const std::vector<glm::vec3> b = nodesOf(after, now.slotOfRank[rank]);
        QVERIFY(glm::distance(a.back(), b.back()) < 1e-5F);
    }
}

HAIRPAINT_TEST(TestSimulation, None)
#include "test_simulation.moc"
