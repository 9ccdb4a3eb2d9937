// A painted strip of cornrow is a plait along the skin, whose end is free.
#include "sim/groom/braid_row.h"
#include "sim/groom/strand_curve.h"
#include "tests/sim/groom_bytes.h"
#include "tests/sim/groom_reading.h"
#include "tests/sim/tied_ball.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr std::uint16_t kCornrow = static_cast<std::uint16_t>(BraidKind::Cornrow);
constexpr int kSegments = 240;

/// Strips on the ball's front from its equator to near its top.
GroomInput rowsOnBall(int rows)
{
    GroomInput input = paintedBall(60000, 800);
    GroomInput::Group& group = input.groups.front();
    group.settings.nodesPerHair = 16;
    group.settings.braidRadiusM = 0.004F;
    for (int row = 0; row < rows; ++row) {
        const float u = 0.4F + 0.05F * static_cast<float>(row);
        paintSquare(group.maps[MapSlot::Braid], {u, 0.5F}, {u + 0.032F, 0.8F}, kCornrow);
    }
    return input;
}

template<typename Visit>
void forEachInRow(const Groom& groom, const Visit& visit)
{
    forEachHair(groom, [&](std::uint32_t slot, const StrandStyle&) {
        const StrandChunk& chunk = *groom.chunks[chunkOf(slot)];
        if (!chunk.cornrows.empty() && chunk.cornrows[inChunk(slot)].end > 0.0F)
            visit(slot, chunk.cornrows[inChunk(slot)]);
    });
}

} // namespace

class TestCornrows : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aStripIsOneRowFromItsUpperEndToItsLower();
    void stripsAreRowsOfTheirOwn();
    void stripsThatTouchAreTwoRowsWhereTheirNumbersDiffer();
    void aStripThatFallsApartIsStillOneRow();
    void itTakesInEveryHairOfItsStrip();
    void itKeepsWithinSixMillimetresOfTheSkin();
    void hairsThatJoinItFurtherOnAreInStep();
    void itsEndIsFree();
    void aWideStripIsAThickBraid();
    void aShortTailStaysOnTheSkin();
    void paintingAnotherGivesWhatAFreshGroomHas();
};

void TestCornrows::aStripIsOneRowFromItsUpperEndToItsLower()
{
    const auto groom = tied::groomed(rowsOnBall(1));
    std::vector<std::uint32_t> slots;
    forEachInRow(*groom, [&](std::uint32_t slot, const CornrowHair&) { slots.push_back(slot); });
    QVERIFY(slots.size() > 200);
    std::ranges::sort(slots, {}, [&](std::uint32_t slot) { return groom->roots->rankOfSlot[slot]; });
    const BraidRow row = rowAlong(*groom->roots, slots);
    // 0.3 of half the circle.
    const float expectedM = 0.3F * 3.1416F * 0.1F;
    QVERIFY2(std::abs(row.lengthM - expectedM) < 0.1F * expectedM, qPrintable(QString::number(row.lengthM)));
    QVERIFY(row.pointsHd.front().y > row.pointsHd.back().y + 0.06F);
    for (const glm::vec3& point : row.pointsHd) {
        QVERIFY(std::abs(glm::length(point) - 0.1F) < 0.002F);
        const float u = 0.5F + std::atan2(point.x, point.z) / 6.2832F;
        QVERIFY2(std::abs(u - 0.416F) < 0.012F, qPrintable(QString::number(u)));
    }
    QVERIFY(std::abs(nearestOnRow(row, row.pointsHd[16]).alongM - 0.5F * row.lengthM) < 0.01F * row.lengthM);
    QVERIFY(glm::length(onRow(row, row.lengthM + 0.05F, 0.0F) - row.pointsHd.back()) > 0.045F);
}

void TestCornrows::stripsAreRowsOfTheirOwn()
{
    const auto groom = tied::groomed(rowsOnBall(5));
    std::set<std::uint32_t> centres;
    forEachInRow(*groom, [&](std::uint32_t slot, const CornrowHair&) {
        centres.insert(groom->chunks[chunkOf(slot)]->braidCentre[inChunk(slot)]);
    });
    QCOMPARE(centres.size(), std::size_t{5});
}

void TestCornrows::stripsThatTouchAreTwoRowsWhereTheirNumbersDiffer()
{
    GroomInput input = rowsOnBall(1);
    MapRaster& braid = input.groups.front().maps[MapSlot::Braid];
    const auto rows = [&input] {
        const auto groom = tied::groomed(input);
        std::map<std::uint32_t, std::set<std::uint16_t>> numbersOfCentre;
        forEachInRow(*groom, [&](std::uint32_t slot, const CornrowHair&) {
            numbersOfCentre[groom->chunks[chunkOf(slot)]->braidCentre[inChunk(slot)]].insert(
                input.groups.front().maps[MapSlot::Braid]->sampleNearest(groom->roots->uv[slot])[0]);
        });
        return numbersOfCentre;
    };
    paintSquare(braid, {0.432F, 0.5F}, {0.464F, 0.8F}, kCornrow);
    QCOMPARE(rows().size(), std::size_t{1});
    for (const std::uint16_t number : {static_cast<std::uint16_t>(kCornrow + 1), kLastRowNumber}) {
        paintSquare(braid, {0.432F, 0.5F}, {0.464F, 0.8F}, number);
        const auto numbersOfCentre = rows();
        QCOMPARE(numbersOfCentre.size(), std::size_t{2});
        for (const auto& [centre, numbers] : numbersOfCentre)
            QCOMPARE(numbers.size(), std::size_t{1}); // No hair lies in the other's row.
    }
}

void TestCornrows::aStripThatFallsApartIsStillOneRow()
{
    // 15 cm along the equator, 6 mm wide, with two gaps of 5 mm; the first point stands alone between them.
    const Skin skin(makeBallHead(64, 0.1F));
    const auto at = [&skin](float alongM, float acrossM) {
        const float angle = alongM / 0.1F;
        return skin.nearest({0.1F * std::sin(angle), acrossM, 0.1F * std::cos(angle)}).positionHd;
    };
    std::vector<glm::vec3> strip{at(0.075F, 0.0F)};
    for (int i = 0; i < 300; ++i) {
        const float alongM = 0.15F * static_cast<float>(i) / 299.0F;
        if (std::abs(alongM - 0.075F) > 0.005F)
            strip.push_back(at(alongM, 0.0006F * static_cast<float>(i * 7 % 11 - 5)));
    }
    const BraidRow row = rowAlong(skin, strip, {1.0F, 0.0F, 0.0F});
    QVERIFY2(std::abs(row.lengthM - 0.15F) < 0.01F, qPrintable(QString::number(row.lengthM)));
    QVERIFY2(row.widthM > 0.003F && row.widthM < 0.009F, qPrintable(QString::number(row.widthM)));
}

void TestCornrows::itTakesInEveryHairOfItsStrip()
{
    const GroomInput input = rowsOnBall(5);
    const auto groom = tied::groomed(input);
    const auto& braid = *input.groups.front().maps[MapSlot::Braid];
    forEachHair(*groom, [&](std::uint32_t slot, const StrandStyle& style) {
        const bool isPainted = braid.sampleNearest(groom->roots->uv[slot])[0] == kCornrow;
        QCOMPARE(style.braid, isPainted ? BraidKind::Plait : BraidKind::None);
    });
}

void TestCornrows::itKeepsWithinSixMillimetresOfTheSkin()
{
    const auto groom = tied::groomed(rowsOnBall(1));
    float highest = 0.0F;
    float lowest = 1.0F;
    forEachInRow(*groom, [&](std::uint32_t slot, const CornrowHair& hair) {
        const std::vector<glm::vec3> points = tied::drawn(*groom, slot, tied::restNodes(*groom, slot), kSegments);
        const auto end = static_cast<std::size_t>(hair.end * static_cast<float>(kSegments));
        for (std::size_t i = 0; i <= end; ++i) {
            highest = std::max(highest, glm::length(points[i]) - tied::kBallM);
            lowest = std::min(lowest, glm::length(points[i]) - tied::kBallM);
        }
    });
    QVERIFY2(highest < 0.006F && highest > 0.002F, qPrintable(QString::number(highest)));
    QVERIFY2(lowest > -0.002F, qPrintable(QString::number(lowest)));
}

void TestCornrows::hairsThatJoinItFurtherOnAreInStep()
{
    const auto groom = tied::groomed(rowsOnBall(1));
    std::uint32_t early = 0;
    std::uint32_t late = 0;
    float earlyY = -1.0F;
    float lateApart = 1.0F;
    forEachInRow(*groom, [&](std::uint32_t slot, const CornrowHair&) {
        const float y = groom->roots->positionHd[slot].y;
        if (y > earlyY) {
            earlyY = y;
            early = slot;
        }
        if (std::abs(y - 0.05F) < lateApart) {
            lateApart = std::abs(y - 0.05F);
            late = slot;
        }
    });
    const auto middleOf = [&](std::uint32_t slot) {
        StrandStyle style = groom->style(slot);
        style.wisp = 0;
        style.wispOffset = {};
        std::vector<glm::vec3> points;
        evaluateStrand(tied::restNodes(*groom, slot), frameTangentHd(*groom, slot), style, 2000, points);
        return points;
    };
    const std::vector<glm::vec3> of = middleOf(early);
    const std::vector<glm::vec3> other = middleOf(late);
    const float radiusM = groom->style(late).braidRadiusM;
    const auto end = static_cast<std::size_t>(groom->chunks[chunkOf(late)]->cornrows[inChunk(late)].end * 2000.0F);
    // From a little behind where it joins to the end.
    for (std::size_t i = 400; i < end; i += 20) {
        float nearest = 1.0F;
        for (const glm::vec3& point : of)
            nearest = std::min(nearest, glm::length(point - other[i]));
        QVERIFY2(nearest < 0.3F * radiusM, qPrintable(QStringLiteral("%1: %2").arg(i).arg(nearest / radiusM)));
    }
}

void TestCornrows::itsEndIsFree()
{
    Simulation simulation;
    simulation.setInput(rowsOnBall(1));
    simulation.settle(2.0);
    const GroupFrame still = tied::frameOf(simulation);
    simulation.setWind({.velocity = {14.0F, 0.0F, 0.0F}});
    for (int i = 0; i < 60; ++i)
        simulation.advance(1.0 / 60.0);
    const GroupFrame blown = tied::frameOf(simulation);
    forEachInRow(*still.groom, [&](std::uint32_t slot, const CornrowHair& hair) {
        const std::vector<glm::vec3> before = tied::frameNodes(still, slot);
        const std::vector<glm::vec3> after = tied::frameNodes(blown, slot);
        for (std::size_t node = 0; node < 16; ++node)
            if (static_cast<float>(node) <= hair.end * 15.0F)
                QVERIFY(glm::length(before[node] - after[node]) < 1e-6F);
        // A tail of 20 cm has fallen, and is blown aside.
        QVERIFY(before.back().y < hair.endHd.y - 0.15F);
        QVERIFY(glm::length(after.back() - before.back()) > 0.03F);
    });
}

void TestCornrows::aWideStripIsAThickBraid()
{
    GroomInput input = paintedBall(20000, 800);
    GroomInput::Group& group = input.groups.front();
    group.settings.nodesPerHair = 24;
    group.settings.braidRadiusM = 0.008F;
    // Half around the ball and 5 cm wide.
    paintSquare(group.maps[MapSlot::Braid], {0.25F, 0.42F}, {0.75F, 0.58F}, kCornrow);
    const auto groom = tied::groomed(input);
    int hairs = 0;
    forEachInRow(*groom, [&](std::uint32_t slot, const CornrowHair& hair) {
        ++hairs;
        QVERIFY(groom->style(slot).braidRadiusM > 0.006F);
        // No hair swings out, or runs under the skin by more than the braid's lower side does.
        const std::vector<glm::vec3> points = tied::drawn(*groom, slot, tied::restNodes(*groom, slot), kSegments);
        const auto end = static_cast<std::size_t>(hair.end * static_cast<float>(kSegments));
        for (std::size_t i = 0; i < end; ++i) {
            const float aboveM = glm::length(points[i]) - tied::kBallM;
            QVERIFY2(aboveM > -0.0045F && aboveM < 0.026F, qPrintable(QString::number(aboveM)));
        }
    });
    QVERIFY(hairs > 500);
}

void TestCornrows::aShortTailStaysOnTheSkin()
{
    GroomInput input = rowsOnBall(1);
    input.groups.front().settings.greatestLengthM = 0.02F;
    Simulation simulation;
    simulation.setInput(input);
    simulation.setWind({.velocity = {14.0F, 0.0F, 0.0F}});
    simulation.settle(1.0);
    const GroupFrame blown = tied::frameOf(simulation);
    int hairs = 0;
    forEachInRow(*blown.groom, [&](std::uint32_t slot, const CornrowHair&) {
        ++hairs;
        const std::vector<glm::vec3> nodes = tied::frameNodes(blown, slot);
        const std::vector<glm::vec3> rest = tied::restNodes(*blown.groom, slot);
        for (std::size_t node = 0; node < nodes.size(); ++node)
            QVERIFY(glm::length(nodes[node] - rest[node]) < 1e-6F);
        QVERIFY(glm::length(nodes.back()) - tied::kBallM < 0.004F);
    });
    QVERIFY(hairs > 200);
}

void TestCornrows::paintingAnotherGivesWhatAFreshGroomHas()
{
    GroomInput input = rowsOnBall(2);
    GroomBuilder builder;
    const auto first = builder.update(input).grooms.front();
    const GroomInput more = rowsOnBall(4);
    input.groups.front().maps[MapSlot::Braid] = more.groups.front().maps[MapSlot::Braid];
    const auto updated = builder.update(input).grooms.front();
    const char* difference = differenceOf(*updated, *tied::groomed(input));
    QVERIFY2(difference == nullptr, difference);
    // And back.
    input.groups.front().maps[MapSlot::Braid] = rowsOnBall(2).groups.front().maps[MapSlot::Braid];
    difference = differenceOf(*builder.update(input).grooms.front(), *first);
    QVERIFY2(difference == nullptr, difference);
    // Another number alone: one of two that are one row becomes its own.
    MapRaster& braid = input.groups.front().maps[MapSlot::Braid];
    paintSquare(braid, {0.432F, 0.5F}, {0.45F, 0.8F}, kCornrow);
    static_cast<void>(builder.update(input));
    paintSquare(braid, {0.432F, 0.5F}, {0.482F, 0.8F}, kCornrow + 1);
    difference = differenceOf(*builder.update(input).grooms.front(), *tied::groomed(input));
    QVERIFY2(difference == nullptr, difference);
}

HAIRPAINT_TEST(TestCornrows, None)
#include "test_cornrows.moc"
