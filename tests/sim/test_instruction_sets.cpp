// Every instruction set that this machine has gives the same bytes. Highway picks the best one at run time; here each
// of the others is forced in turn.
#include "groom_bytes.h"
#include "hanging_hair.h"
#include "sim/motion/simulation.h"
#include "tests/support/painted_ball.h"
#include "tests/support/test_program.h"
#include "tied_ball.h"

#include <QtTest>

#include <hwy/highway.h>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

/// Every branch of both kernels: wind, puff, gel, short hair, a moving head, sleep.
std::vector<float> hairAfterAWhile()
{
    GroomInput input = paintedBall(2000, 600);
    paintSquare(input.groups.front().maps[MapSlot::Gel], {0.0F, 0.5F}, {0.3F, 1.0F}, 40000);
    paintSquare(input.groups.front().maps[MapSlot::Length], {0.5F, 0.5F}, {0.8F, 1.0F}, 8000);
    paintSquare(input.groups.front().maps[MapSlot::Clump], {0.4F, 0.5F}, {1.0F, 1.0F}, 50000);
    Simulation simulation;
    simulation.setInput(input);
    simulation.setWind({true, glm::vec3(4.0F, 0.5F, -2.0F), 0.6F, 0.5F});
    for (int i = 0; i < 30; ++i)
        simulation.advance(1.0 / 60.0);
    simulation.puff(glm::vec3(0.1F, 0.0F, 0.05F), glm::vec3(0.0F, 3.0F, 6.0F), 0.15F);
    for (int i = 0; i < 15; ++i) {
        simulation.setPose({glm::quat(1.0F, 0.0F, 0.02F * static_cast<float>(i), 0.0F), glm::vec3(0.0F)});
        simulation.advance(1.0 / 60.0);
    }
    simulation.setWind({});
    for (int i = 0; i < 30; ++i)
        simulation.advance(1.0 / 60.0);
    StrandFrame frame;
    simulation.writeFrame(frame);
    return frame.groups.front().positions;
}

/// Hair that a ring gathers, long or too short for it, with the grid of distances and without.
std::vector<float> gatheredHair()
{
    std::vector<float> all;
    for (const bool hasGrid : {true, false}) {
        GroomInput input = tied::tiedBall(hasGrid ? 1200 : 200);
        GroomInput::Group& group = input.groups.front();
        group.ties.front().tightness = 0.5F;
        paintSquare(group.maps[MapSlot::Length], {0.3F, 0.5F}, {0.7F, 1.0F}, 12000);
        paintSquare(group.maps[MapSlot::Clump], {0.0F, 0.5F}, {0.5F, 1.0F}, 30000);
        if (!hasGrid)
            input.distances = nullptr;
        const std::shared_ptr<const Groom> groom = tied::groomed(input);
        for (const std::shared_ptr<const StrandChunk>& chunk : groom->chunks)
            if (chunk)
                all.insert(all.end(), chunk->restPositions.begin(), chunk->restPositions.end());
        all.insert(all.end(), groom->tails->basis->restPositions.begin(), groom->tails->basis->restPositions.end());
    }
    return all;
}

/// Braids that fall over a ball and each other.
std::vector<float> braidedHair()
{
    std::vector<HandStrand> strands;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 4; ++j)
            strands.push_back(
                {.rootHd = {0.006F * static_cast<float>(i) - 0.015F, 0.1F, 0.006F * static_cast<float>(j) - 0.009F},
                 .lengthM = 0.25F,
                 .girthM = 0.006F});
    GroupDynamics hair;
    hair.setGroom(groomOf(strands, 14, PhysicsSettings{}), ballCollider(), WindField::calm({}));
    fall(hair, 60);
    return {hair.state().now().begin(), hair.state().now().end()};
}

/// From now on the kernels run with this instruction set; 0: the best one again.
void force(std::int64_t target)
{
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

} // namespace

class TestInstructionSets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { force(0); }
    void eachGivesTheSameBytes_data();
    void eachGivesTheSameBytes();
};

void TestInstructionSets::eachGivesTheSameBytes_data()
{
    QTest::addColumn<qint64>("target");
    force(0);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        QTest::newRow(hwy::TargetName(target)) << qint64{target};
}

void TestInstructionSets::eachGivesTheSameBytes()
{
    QFETCH(qint64, target);
    force(0);
    const std::vector<float> best = hairAfterAWhile();
    const std::vector<float> bestGathered = gatheredHair();
    const std::vector<float> bestBraided = braidedHair();
    force(target);
    QVERIFY(hwy::SupportedTargets() == target);
    const std::vector<float> forced = hairAfterAWhile();
    QVERIFY(!best.empty());
    QVERIFY(sameBytes(best, forced));
    QVERIFY(sameBytes(bestGathered, gatheredHair()));
    QVERIFY(sameBytes(bestBraided, braidedHair()));
}

HAIRPAINT_TEST(TestInstructionSets, None)
#include "test_instruction_sets.moc"
