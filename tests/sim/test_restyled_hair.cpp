// Hair in motion whose maps change: what is combed elsewhere goes there, and nothing flies.
#include "sim/groom/direction_texel.h"
#include "sim/motion/simulation.h"
#include "tests/support/painted_ball.h"
#include "tests/support/strand_frames.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr int kRestyledHairs = 1500;
constexpr int kRestyledBasis = 500;
constexpr double kFrame = 1.0 / 60.0;

/// 20 cm of hair on one ball, which grows to one side.
GroomInput combed(float direction)
{
    static const GroomInput ball = paintedBall(kRestyledHairs, kRestyledBasis);
    GroomInput input = ball;
    input.groups.front().maps[MapSlot::Direction] = mapOfTexel(2, texelOfDirection({direction, 0.0F}));
    return input;
}

/// How far the node that is furthest out is from the ball's upright axis, m.
float widthOf(const Simulation& simulation)
{
    const StrandFrame frame = frameOf(simulation);
    float farthestM = 0.0F;
    for (std::size_t slot = 0; slot < frame.groups.front().groom->roots->count(); ++slot)
        for (const glm::vec3& node : nodesOf(frame, slot))
            farthestM = std::max(farthestM, std::hypot(node.x, node.z));
    return farthestM;
}

} // namespace

class TestRestyledHair : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void longHairThatIsCombedToTheOtherSideDoesNotFly();
    void hairThatIsCombedALittleKeepsItsMotion();
    void hairThatHangsAnewIsAsNew();
};

void TestRestyledHair::longHairThatIsCombedToTheOtherSideDoesNotFly()
{
    Simulation simulation;
    simulation.setInput(combed(0.9F));
    simulation.settle(5.0);
    const float hanging = widthOf(simulation);
    simulation.setInput(combed(-0.9F));
    for (int frame = 0; frame < 60; ++frame) {
        const float width = widthOf(simulation);
        QVERIFY2(width < hanging + 0.02F, qPrintable(QStringLiteral("%1 after %2").arg(width).arg(hanging)));
        simulation.advance(kFrame);
    }
}

void TestRestyledHair::hairThatIsCombedALittleKeepsItsMotion()
{
    Simulation simulation;
    simulation.setInput(combed(0.1F));
    simulation.setWind({true, glm::vec3(6.0F, 0.0F, 0.0F), 0.0F, 0.0F});
    for (int frame = 0; frame < 20; ++frame)
        simulation.advance(kFrame);
    const StrandFrame before = frameOf(simulation);
    simulation.setInput(combed(0.15F));
    const StrandFrame after = frameOf(simulation);
    float greatest = 0.0F;
    for (std::size_t slot = 0; slot < before.groups.front().groom->roots->count(); ++slot)
        if (const std::vector<glm::vec3> nodes = nodesOf(before, slot); !nodes.empty())
            greatest = std::max(greatest, glm::distance(nodes.back(), nodesOf(after, slot).back()));
    // Its rest shape turns by 3 degrees, 1 cm at the tip.
    QVERIFY2(greatest > 0.0F && greatest < 0.02F, qPrintable(QString::number(greatest)));
}

void TestRestyledHair::hairThatHangsAnewIsAsNew()
{
    const GroomInput input = combed(0.9F);
    Simulation simulation;
    simulation.setInput(input);
    simulation.setWind({true, glm::vec3(6.0F, 0.0F, 0.0F), 0.0F, 0.0F});
    for (int frame = 0; frame < 30; ++frame)
        simulation.advance(kFrame);
    Simulation fresh;
    fresh.setInput(input);
    const std::vector<float> wanted = frameOf(fresh).groups.front().positions;
    QVERIFY(frameOf(simulation).groups.front().positions != wanted);
    simulation.hangAnew();
    QVERIFY(frameOf(simulation).groups.front().positions == wanted);
}

HAIRPAINT_TEST(TestRestyledHair, None)
#include "test_restyled_hair.moc"
