// Hairs between the basis hairs: their length, the head, and braids that follow their centre.
#include "sim/groom/groom.h"
#include "sim/motion/dependents.h"
#include "sim/motion/simulation.h"
#include "tests/support/painted_ball.h"
#include "tests/support/strand_frames.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr int kFollowers = 3000;

void blow(Simulation& simulation)
{
    simulation.setWind({true, glm::vec3(3.0F, 0.5F, 1.0F), 0.5F, 0.4F});
    for (int i = 0; i < 60; ++i)
        simulation.advance(1.0 / 60.0);
}

} // namespace

class TestDependents : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void dependentsKeepTheirLengthAndStayOutside();
    void braidedHairFollowsItsCentre();
    void locksHoldTheirHairInStorm();
    void hairFollowsBasisHairsThatChangeInOtherChunks();
    void longHairThatLiesAsNoneAroundHangsWithThem();
    void longHairThatACutHasMissedHangs();
};

void TestDependents::dependentsKeepTheirLengthAndStayOutside()
{
    Simulation simulation;
    simulation.setInput(paintedBall(kFollowers, 300));
    blow(simulation);
    const StrandFrame frame = frameOf(simulation);
    float worst = 0.0F;
    float deepest = 0.0F;
    std::size_t hairs = 0;
    for (std::size_t slot = 0; slot < kFollowers; ++slot) {
        const std::vector<glm::vec3> nodes = nodesOf(frame, slot);
        hairs += nodes.size() > 1 ? 1 : 0;
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            const float segment = 0.2F / static_cast<float>(nodes.size() - 1);
            worst = std::max(worst, std::abs(glm::distance(nodes[i - 1], nodes[i]) / segment - 1.0F));
            deepest = std::max(deepest, 0.1F - glm::length(nodes[i]));
        }
    }
    QCOMPARE(hairs, std::size_t{kFollowers});
    QVERIFY2(worst < 1e-4F, qPrintable(QString::number(worst)));
    QVERIFY2(deepest < 0.003F, qPrintable(QString::number(deepest)));
}

void TestDependents::locksHoldTheirHairInStorm()
{
    GroomInput input = paintedBall(kFollowers, 300);
    input.groups.front().settings.locks.sizeM = 0.03F; // Some 140 locks.
    input.groups.front().maps[MapSlot::Clump] = mapOfTexel(1, {65535});
    Simulation simulation;
    simulation.setInput(input);
    const auto within = [&simulation] {
        const StrandFrame frame = frameOf(simulation);
        const Groom& groom = *frame.groups.front().groom;
        int held = 0;
        int all = 0;
        for (std::uint32_t slot = 0; slot < kFollowers; ++slot) {
            const std::uint32_t leader = groom.roots->basisSlot[groom.chunks[chunkOf(slot)]->lockLeader[inChunk(slot)]];
            const std::vector<glm::vec3> nodes = nodesOf(frame, slot);
            const std::vector<glm::vec3> leads = nodesOf(frame, leader);
            if (leader == slot || nodes.empty() || leads.empty())
                continue;
            ++all;
            float furthest = 0.0F;
            for (std::size_t i = nodes.size() / 2; i < nodes.size(); ++i)
                furthest = std::max(furthest, glm::distance(nodes[i], leads[i]));
            held += furthest < 0.015F ? 1 : 0;
        }
        return static_cast<double>(held) / all;
    };
    simulation.settle(3.0);
    QVERIFY2(within() > 0.9, qPrintable(QString::number(within())));
    simulation.setWind({true, glm::vec3(15.0F, 0.5F, 1.0F), 0.5F, 0.4F});
    for (int i = 0; i < 60; ++i)
        simulation.advance(1.0 / 60.0);
    QVERIFY2(within() > 0.9, qPrintable(QString::number(within())));
}

void TestDependents::braidedHairFollowsItsCentre()
{
    GroomInput input = paintedBall(kFollowers, 600);
    input.groups.front().maps[MapSlot::Braid] = mapOfTexel(1, {1});
    Simulation simulation;
    simulation.setInput(input);
    blow(simulation);
    const StrandFrame frame = frameOf(simulation);
    const Groom& groom = *frame.groups.front().groom;
    const int last = groom.nodes - 1;
    std::size_t braided = 0;
    glm::vec3 tips[2] = {glm::vec3(0.0F), glm::vec3(0.0F)};
    std::uint32_t centreOfFirst = kNoCentre;
    for (std::size_t slot = 0; slot < kFollowers; ++slot) {
        const StrandChunk& chunk = *groom.chunks[chunkOf(slot)];
        const std::size_t local = inChunk(slot);
        const std::uint32_t centre = chunk.braidCentre[local];
        const std::vector<glm::vec3> nodes = nodesOf(frame, slot);
        if (nodes.empty() || centre == kNoCentre)
            continue;
        // The gathering part lies where it was groomed.
        const int gathered = static_cast<int>(std::lround(chunk.styles[local].braidStart * static_cast<float>(last)));
        for (int node = 0; node <= gathered; ++node) {
            const glm::vec3 rest = groom.blocks().node(chunk.restPositions, local, static_cast<std::size_t>(node));
            QVERIFY(glm::distance(nodes[static_cast<std::size_t>(node)], rest) < 1e-6F);
        }
        // All hairs of one braid end at the same tip.
        if (gathered < last) {
            centreOfFirst = centreOfFirst == kNoCentre ? centre : centreOfFirst;
            if (centre == centreOfFirst) {
                tips[braided == 0 ? 0 : 1] = nodes.back();
                if (braided > 0)
                    QVERIFY(glm::distance(tips[0], tips[1]) < 1e-5F);
                ++braided;
            }
        }
    }
    QVERIFY(braided > 10);
}

void TestDependents::hairFollowsBasisHairsThatChangeInOtherChunks()
{
    GroomInput input = paintedBall(kFollowers, 300);
    GroomBuilder builder;
    const auto before = builder.update(input).grooms[0];
    paintSquare(input.groups.front().maps[MapSlot::Length], {0.4F, 0.4F}, {0.5F, 0.5F}, 20000);
    const auto after = builder.update(input).grooms[0];
    QVERIFY(before->basis != after->basis);

    // Every basis hair as far from its rest shape as no other.
    StrandState state;
    state.resize(after->nodes, after->basis->blockCount(), 0);
    for (AlignedFloats& positions : state.positions)
        for (std::size_t i = 0; i < positions.size(); ++i)
            positions[i] = after->basis->restPositions[i] + 0.002F * static_cast<float>(i / kLanes % 7);
    ColliderSet colliders;
    const auto written = [&](Dependents& dependents, const Groom& groom) {
        GroupFrame frame;
        dependents.write(groom, state, colliders, 1.0F, HeadPose(), Neck(), frame);
        return std::vector<float>(frame.positions.begin(), frame.positions.end());
    };
    Dependents kept;
    kept.prepare(*before, colliders, true);
    kept.prepare(*after, colliders, false);
    Dependents fresh;
    fresh.prepare(*after, colliders, true);
    const std::vector<float> expected = written(fresh, *after);
    QVERIFY(written(kept, *after) == expected);

    // It tells: among the chunks that both grooms share are hairs that follow one that differs.
    Groom asBefore = *after;
    for (std::size_t i = 0; i < after->chunks.size(); ++i)
        if (before->chunks[i] == after->chunks[i])
            asBefore.basis = before->basis;
    Dependents late;
    late.prepare(asBefore, colliders, true);
    const std::vector<float> without = written(late, *after);
    const std::size_t chunkFloats = after->blocks().floatsFor(kBlocksPerChunk);
    bool sharedDiffers = false;
    for (std::size_t i = 0; i < after->chunks.size(); ++i) {
        const auto first = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(after->packedChunk[i]) * chunkFloats);
        const auto end = first + static_cast<std::ptrdiff_t>(chunkFloats);
        sharedDiffers =
            sharedDiffers || (before->chunks[i] == after->chunks[i] &&
                              !std::equal(expected.begin() + first, expected.begin() + end, without.begin() + first));
    }
    QVERIFY(sharedDiffers);
}

void TestDependents::longHairThatLiesAsNoneAroundHangsWithThem()
{
    GroomBuilder builder;
    const auto even = builder.update(paintedBall(kFollowers, 300)).grooms[0];
    constexpr std::size_t kLoner = 77;
    const auto last = static_cast<std::size_t>(even->nodes - 1);
    const StrandBlocks layout = even->blocks();
    auto chunk = std::make_shared<StrandChunk>(*even->chunks[0]);
    QVERIFY(chunk->drawn[kLoner]);
    const glm::vec3 root = layout.node(chunk->restPositions, kLoner, 0);
    for (std::size_t node = 1; node <= last; ++node) // To the other side.
        layout.setNode(chunk->restPositions, kLoner, node,
                       2.0F * root - layout.node(chunk->restPositions, kLoner, node));
    Groom groom = *even;
    groom.chunks[0] = chunk;

    StrandState atRest;
    atRest.resize(groom.nodes, groom.basis->blockCount(), 0);
    for (AlignedFloats& positions : atRest.positions)
        positions.assign(groom.basis->restPositions.begin(), groom.basis->restPositions.end());
    const auto written = [&](const Groom& of) {
        Dependents dependents;
        dependents.prepare(of, ColliderSet(), true);
        GroupFrame frame;
        dependents.write(of, atRest, ColliderSet(), 1.0F, HeadPose(), Neck(), frame);
        return frame.positions;
    };
    const auto expected = written(*even);
    const auto got = written(groom);
    for (std::size_t slot = 0; slot < kChunkSlots; ++slot) {
        const float apart = glm::distance(layout.node(expected, slot, last), layout.node(got, slot, last));
        QVERIFY2(apart <= (slot == kLoner ? 0.02F : 0.0F), qPrintable(QString::number(apart)));
    }
}

void TestDependents::longHairThatACutHasMissedHangs()
{
    constexpr float kLongM = 0.15F;
    constexpr float kBallM = 0.1F;
    constexpr float kOffBallM = 0.06F; // Hair that hangs as others do bends down nearer to the ball.
    GroomInput input = paintedBall(4 * kFollowers, 300);
    input.groups.front().settings.variation = {.crossing = 0.3F, .flyaways = 0.2F};
    MapRaster& length = input.groups.front().maps[MapSlot::Length];
    paintSquare(length, {0.2F, 0.3F}, {0.8F, 0.7F}, 26000);
    for (int column = 0; column < 15; ++column)
        for (int row = 0; row < 10; ++row) {
            const glm::vec2 low = glm::vec2(0.22F, 0.32F) + 0.04F * glm::vec2(column, row);
            paintSquare(length, low, low + 0.01F, 65535);
        }
    Simulation simulation;
    simulation.setInput(input);
    simulation.settle(2.0);
    StrandFrame frame;
    simulation.writeFrame(frame);
    const GroupFrame& hair = frame.groups.front();
    std::size_t missed = 0;
    std::size_t flying = 0;
    for (std::uint32_t slot = 0; slot < hair.groom->roots->count(); ++slot) {
        const glm::vec2 uv = hair.groom->roots->uv[slot];
        const bool isInside = uv.x > 0.2F && uv.x < 0.8F && uv.y > 0.3F && uv.y < 0.7F;
        if (!isInside || !hair.isPositioned(slot) || hair.groom->style(slot).lengthM < kLongM)
            continue;
        ++missed;
        bool isFlying = false;
        for (std::size_t node = 0; node < static_cast<std::size_t>(hair.groom->nodes); ++node) {
            const glm::vec3 p = hair.groom->blocks().node(hair.positions, hair.groom->frameStrand(slot), node);
            isFlying = isFlying || glm::length(glm::vec2(p.x, p.z)) > kBallM + kOffBallM;
        }
        flying += isFlying ? 1 : 0;
    }
    QVERIFY(missed > 50);
    QVERIFY2(flying * 40 < missed, qPrintable(QStringLiteral("%1 of %2").arg(flying).arg(missed)));
}

HAIRPAINT_TEST(TestDependents, None)
#include "test_dependents.moc"
