// A braid is as thick as its wisps make it where it meets the skin.
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

} // namespace

class TestBraidContact : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void itLiesOnTheSkinWithItsSide();
    void itStartsOnTheSkinWithItsSide();
    void theGirthIsThatOfTheDrawnBraid();
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

HAIRPAINT_TEST(TestBraidContact, None)
#include "test_braid_contact.moc"
