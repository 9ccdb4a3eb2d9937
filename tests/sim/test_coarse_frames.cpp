// Frames that hold only the hairs that a coarse picture draws.
#include "sim/motion/simulation.h"
#include "tests/support/painted_ball.h"
#include "tests/support/strand_frames.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>

using namespace hairpaint::sim;
using namespace hairpaint::test;

class TestCoarseFrames : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aCoarseFramePositionsItsHairsWhereAWholeOneDoes()
    {
        Simulation simulation;
        simulation.setInput(paintedBall(3000, 700));
        simulation.setWind({true, glm::vec3(3.0F, 0.5F, 1.0F), 0.5F, 0.4F});
        simulation.advance(0.2);
        const StrandFrame whole = frameOf(simulation);
        QCOMPARE(frameDetail(whole), 1.0F);

        constexpr float kDetail = 0.25F;
        constexpr float kUntouched = 77.0F;
        StrandFrame coarse = whole;
        std::ranges::fill(coarse.groups.front().positions, kUntouched);
        simulation.writeFrame(coarse, kDetail);
        QCOMPARE(frameDetail(coarse), kDetail);
        const Groom& groom = *coarse.groups.front().groom;
        std::size_t positioned = 0;
        for (std::size_t slot = 0; slot < groom.roots->count(); ++slot) {
            if (!coarse.groups.front().isPositioned(slot))
                continue;
            QVERIFY(nodesOf(coarse, slot) == nodesOf(whole, slot));
            ++positioned;
        }
        QVERIFY(positioned > 0);
        std::size_t written = 0;
        coarse.groups.front().forEachPositionedBlock([&](std::size_t) { ++written; });
        const std::size_t floats = groom.blocks().blockFloats();
        std::size_t untouched = 0;
        const std::vector<float>& positions = coarse.groups.front().positions;
        for (std::size_t block = 0; block < positions.size() / floats; ++block)
            if (positions[block * floats] == kUntouched)
                ++untouched;
        // As much is written as is needed: hairs that are left out lie in blocks of their own.
        QCOMPARE(written + untouched, positions.size() / floats);
        QVERIFY(written * kLanes < positioned + positioned / 2);
    }
};

HAIRPAINT_TEST(TestCoarseFrames, None)
#include "test_coarse_frames.moc"
