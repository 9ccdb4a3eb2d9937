// Hairs between the basis hairs: their length, the head, and braids that follow their centre.
#include "sim/motion/simulation.h"
#include "tests/support/painted_ball.h"
#include "tests/support/strand_frames.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr int kHairs = 3000;

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
};

void TestDependents::dependentsKeepTheirLengthAndStayOutside()
{
    Simulation simulation;
    simulation.setInput(paintedBall(kHairs, 300));
    blow(simulation);
    const StrandFrame frame = frameOf(simulation);
    float worst = 0.0F;
    float deepest = 0.0F;
    std::size_t hairs = 0;
    for (std::size_t slot = 0; slot < kHairs; ++slot) {
        const std::vector<glm::vec3> nodes = nodesOf(frame, slot);
        hairs += nodes.size() > 1 ? 1 : 0;
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            const float segment = 0.2F / static_cast<float>(nodes.size() - 1);
            worst = std::max(worst, std::abs(glm::distance(nodes[i - 1], nodes[i]) / segment - 1.0F));
            deepest = std::max(deepest, 0.1F - glm::length(nodes[i]));
        }
    }
    QCOMPARE(hairs, std::size_t{kHairs});
    QVERIFY2(worst < 1e-4F, qPrintable(QString::number(worst)));
    QVERIFY2(deepest < 0.003F, qPrintable(QString::number(deepest)));
}

void TestDependents::braidedHairFollowsItsCentre()
{
    GroomInput input = paintedBall(kHairs, 600);
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
    for (std::size_t slot = 0; slot < kHairs; ++slot) {
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

HAIRPAINT_TEST(TestDependents, None)
#include "test_dependents.moc"
