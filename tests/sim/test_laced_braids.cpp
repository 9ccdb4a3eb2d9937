// How braids are laced, and how they lie on a head.
#include "sim/groom/braid_path.h"
#include "sim/groom/strand_curve.h"
#include "sim/motion/simulation.h"
#include "tests/sim/groom_reading.h"
#include "tests/sim/small_groom.h"
#include "tests/sim/tied_ball.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr float kRadiusM = 0.01F;
constexpr float kStraightM = 0.6F;

/// A straight braid as the groom styles it, of a hair in the middle of a wisp.
StrandStyle lacedStyle(BraidKind kind, std::uint32_t wisp, const GroupSettings& settings = {})
{
    StrandStyle style;
    applyBraid(settings, kind, {.wisp = wisp}, {.lengthM = kStraightM, .radiusM = kRadiusM}, style);
    style.braidStart = 0.0F;
    style.wispOffset = {};
    return style;
}

std::vector<glm::vec3> straight()
{
    std::vector<glm::vec3> nodes(16);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes[i].y = kStraightM * static_cast<float>(i) / 15.0F;
    return nodes;
}

/// A ball of 20 cm with braids all over, and what it is kept out of.
GroomInput braidedBall(BraidKind kind, float spacingM, float radiusM)
{
    GroomInput input = paintedBall(6000, 400);
    GroomInput::Group& group = input.groups.front();
    group.settings.greatestLengthM = 0.35F;
    group.settings.nodesPerHair = 16; // 2.3 cm apart: contact is felt at them.
    group.settings.braidSpacingM = spacingM;
    group.settings.braidRadiusM = radiusM;
    group.settings.material.widthM = 1e-3F; // So few hairs fill a braid.
    group.maps[MapSlot::Braid] = mapOfTexel(1, {static_cast<std::uint16_t>(kind)});
    return input;
}

/// How deep the deepest point of a braid's surface is in the ball, m; its hairs on their way to it are no part of it.
float deepestM(const Simulation& simulation, float& alongM)
{
    const GroupFrame frame = tied::frameOf(simulation);
    const Groom& groom = *frame.groom;
    float least = 1.0F;
    std::vector<glm::vec3> points;
    forEachHair(groom, [&](std::uint32_t slot, const StrandStyle& style) {
        if (style.braid == BraidKind::None || !groom.isDrawn(slot))
            return;
        points = tied::drawn(groom, slot, tied::frameNodes(frame, slot), 120);
        const auto begins = static_cast<std::size_t>(std::ceil(style.braidStart * 120.0F)) + 1;
        for (std::size_t i = begins; i < points.size(); ++i)
            if (glm::length(points[i]) < least) {
                least = glm::length(points[i]);
                alongM = style.lengthM * (static_cast<float>(i) / 120.0F - style.braidStart);
            }
    });
    return tied::kBallM - least;
}

/// The wisps of a straight braid, each with that number of segments.
std::vector<std::vector<glm::vec3>> wispsOf(BraidKind kind, int segments)
{
    std::vector<std::vector<glm::vec3>> wisps(static_cast<std::size_t>(lacingOf(kind).wisps));
    for (std::size_t wisp = 0; wisp < wisps.size(); ++wisp)
        evaluateStrand(straight(), {1.0F, 0.0F, 0.0F}, lacedStyle(kind, static_cast<std::uint32_t>(wisp)), segments,
                       wisps[wisp]);
    return wisps;
}

} // namespace

class TestLacedBraids : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void wispsTouchAndAreNotInEachOther_data();
    void wispsTouchAndAreNotInEachOther();
    void ofTwoWispsThatCrossOneIsAboveInTurn_data();
    void ofTwoWispsThatCrossOneIsAboveInTurn();
    void settingsMakeABraidThinnerLongerLooserAndUntied();
    void itsSurfaceStaysOutOfTheSkin_data();
    void itsSurfaceStaysOutOfTheSkin();
    void frizzyHairsLeaveTheirWisp();
    void oneSeesNotThroughItsBeginning_data();
    void oneSeesNotThroughItsBeginning();
    void hairsFillTheirWisp();
};

void TestLacedBraids::wispsTouchAndAreNotInEachOther_data()
{
    QTest::addColumn<int>("kind");
    // Greatest distance to the nearest wisp anywhere, in units of both radii together.
    QTest::addColumn<float>("furthest");
    QTest::newRow("plait") << static_cast<int>(BraidKind::Plait) << 1.2F;
    QTest::newRow("twist") << static_cast<int>(BraidKind::Twist) << 1.2F;
    // Where a wisp turns at the edge of a flat plait, none crosses it.
    QTest::newRow("plait of four") << static_cast<int>(BraidKind::PlaitOfFour) << 1.7F;
    QTest::newRow("plait of five") << static_cast<int>(BraidKind::PlaitOfFive) << 1.9F;
    QTest::newRow("fishtail") << static_cast<int>(BraidKind::Fishtail) << 1.8F;
}

void TestLacedBraids::wispsTouchAndAreNotInEachOther()
{
    QFETCH(int, kind);
    QFETCH(float, furthest);
    constexpr int kSegments = 900;
    const std::vector<std::vector<glm::vec3>> wisps = wispsOf(static_cast<BraidKind>(kind), kSegments);
    float low = 9.0F;
    float high = 0.0F;
    float sum = 0.0F;
    int count = 0;
    // Where it is laced: behind its beginning, before its tie.
    for (std::size_t i = 250; i < 600; i += 5) {
        float nearest = std::numeric_limits<float>::max();
        for (std::size_t wisp = 1; wisp < wisps.size(); ++wisp)
            for (std::size_t j = i - 150; j < i + 150; ++j)
                nearest = std::min(nearest, glm::length(wisps[wisp][j] - wisps[0][i]));
        const float inRadii = nearest / (2.0F * lacingOf(static_cast<BraidKind>(kind)).wisp * kRadiusM);
        low = std::min(low, inRadii);
        high = std::max(high, inRadii);
        sum += inRadii;
        ++count;
    }
    const float mean = sum / static_cast<float>(count);
    const QString told = QStringLiteral("%1 %2 %3").arg(low).arg(mean).arg(high);
    QVERIFY2(low > 0.9F, qPrintable(told));
    QVERIFY2(mean < 1.2F, qPrintable(told));
    QVERIFY2(high < furthest, qPrintable(told));
}

void TestLacedBraids::ofTwoWispsThatCrossOneIsAboveInTurn_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("plait") << static_cast<int>(BraidKind::Plait);
    QTest::newRow("plait of four") << static_cast<int>(BraidKind::PlaitOfFour);
    QTest::newRow("plait of five") << static_cast<int>(BraidKind::PlaitOfFive);
}

void TestLacedBraids::ofTwoWispsThatCrossOneIsAboveInTurn()
{
    QFETCH(int, kind);
    constexpr int kSegments = 3000;
    const std::vector<std::vector<glm::vec3>> wisps = wispsOf(static_cast<BraidKind>(kind), kSegments);
    // Those that the first wisp crosses on its way from one edge to the other: over one, under the next.
    std::vector<bool> over;
    bool inward = wisps[0][900].x > wisps[0][901].x;
    for (std::size_t i = 900; i < 2100; ++i) {
        const bool isInward = wisps[0][i].x > wisps[0][i + 1].x;
        if (isInward != inward) {
            inward = isInward;
            over.clear();
        }
        for (std::size_t wisp = 1; wisp < wisps.size(); ++wisp)
            if ((wisps[0][i].x < wisps[wisp][i].x) != (wisps[0][i + 1].x < wisps[wisp][i + 1].x))
                over.push_back(wisps[0][i].z > wisps[wisp][i].z);
        for (std::size_t k = 1; k < over.size(); ++k)
            QVERIFY(over[k] != over[k - 1]);
    }
}

void TestLacedBraids::settingsMakeABraidThinnerLongerLooserAndUntied()
{
    GroupSettings settings;
    const StrandStyle usual = lacedStyle(BraidKind::Plait, 0, settings);
    settings.braidKnot = 2.0F;
    QVERIFY(std::abs(lacedStyle(BraidKind::Plait, 0, settings).braidTurns - 0.5F * usual.braidTurns) < 1e-4F);
    settings = {};
    settings.braidTaper = 0.6F;
    const auto widthAt = [](const StrandStyle& style, float from, float to) {
        std::vector<glm::vec3> points;
        evaluateStrand(straight(), {1.0F, 0.0F, 0.0F}, style, 1000, points);
        float width = 0.0F;
        for (auto i = static_cast<std::size_t>(from * 1000.0F); i < static_cast<std::size_t>(to * 1000.0F); ++i)
            width = std::max(width, std::abs(points[i].x));
        return width;
    };
    const StrandStyle tapered = lacedStyle(BraidKind::Plait, 0, settings);
    QVERIFY(std::abs(widthAt(usual, 0.6F, 0.8F) - kRadiusM) < 1e-4F);
    QVERIFY(widthAt(tapered, 0.6F, 0.8F) < 0.66F * kRadiusM);
    QVERIFY(widthAt(tapered, 0.1F, 0.3F) > 0.8F * kRadiusM);
    settings = {};
    settings.braidTie = 0.0F;
    const float tieAt = 1.0F - kTuftFraction;
    const StrandStyle untied = lacedStyle(BraidKind::Plait, 0, settings);
    QVERIFY(widthAt(usual, tieAt - 0.005F, tieAt) < 0.3F * kRadiusM);
    QVERIFY(widthAt(untied, tieAt - 0.2F, tieAt) > 0.8F * kRadiusM);
    // How far the hairs of a wisp lie from its middle.
    const auto spread = [](const GroupSettings& of) {
        float sum = 0.0F;
        for (std::uint32_t rank = 0; rank < 2000; ++rank) {
            StrandStyle style;
            style.variation = static_cast<float>(rank) / 1000.0F - 1.0F;
            applyBraid(of, BraidKind::Plait, wispChanceOf(1, rank), {.lengthM = 0.3F, .radiusM = kRadiusM}, style);
            sum += glm::length(style.wispOffset) / 2000.0F;
        }
        return sum;
    };
    settings = {};
    const float middling = spread(settings);
    settings.braidTightness = 0.0F;
    QVERIFY(spread(settings) > 1.1F * middling);
    settings.braidTightness = 1.0F;
    QVERIFY(spread(settings) < 0.9F * middling);
}

void TestLacedBraids::itsSurfaceStaysOutOfTheSkin_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<float>("spacingM");
    QTest::addColumn<float>("radiusM");
    QTest::newRow("one thick plait") << static_cast<int>(BraidKind::Plait) << 0.5F << 0.008F;
    QTest::newRow("box braids") << static_cast<int>(BraidKind::Plait) << 0.06F << 0.004F;
    QTest::newRow("locs") << static_cast<int>(BraidKind::Loc) << 0.06F << 0.005F;
}

void TestLacedBraids::itsSurfaceStaysOutOfTheSkin()
{
    QFETCH(int, kind);
    QFETCH(float, spacingM);
    QFETCH(float, radiusM);
    constexpr float kMostM = 0.002F;
    const GroomInput input = braidedBall(static_cast<BraidKind>(kind), spacingM, radiusM);
    Simulation simulation;
    simulation.setInput(input);
    simulation.settle(2.0);
    float alongM = 0.0F;
    float deepM = deepestM(simulation, alongM);
    QVERIFY2(deepM < kMostM, qPrintable(QStringLiteral("%1 m at %2 m").arg(deepM).arg(alongM)));
    simulation.setWind({.velocity = {14.4F, 0.0F, 4.3F}});
    for (int i = 0; i < 90; ++i)
        simulation.advance(1.0 / 60.0);
    deepM = deepestM(simulation, alongM);
    QVERIFY2(deepM < kMostM, qPrintable(QStringLiteral("%1 m at %2 m").arg(deepM).arg(alongM)));
    // A nod of 20 degrees in half a second.
    simulation.setWind({});
    for (int i = 1; i <= 60; ++i) {
        const float angle = 0.35F * std::sin(static_cast<float>(std::min(i, 30)) / 30.0F * 3.1416F);
        simulation.setPose({.rotation = glm::angleAxis(angle, glm::vec3(1.0F, 0.0F, 0.0F))});
        simulation.advance(1.0 / 60.0);
        if (i % 6 == 0)
            deepM = std::max(deepM, deepestM(simulation, alongM));
    }
    QVERIFY2(deepM < kMostM, qPrintable(QStringLiteral("%1 m at %2 m").arg(deepM).arg(alongM)));
}

void TestLacedBraids::frizzyHairsLeaveTheirWisp()
{
    const auto outside = [](float frizzM) {
        int count = 0;
        for (std::uint32_t rank = 0; rank < 4000; ++rank) {
            StrandStyle style;
            style.frizzM = frizzM;
            style.variation = static_cast<float>(rank) / 2000.0F - 1.0F;
            applyBraid({}, BraidKind::Plait, wispChanceOf(1, rank), {.lengthM = 0.3F, .radiusM = kRadiusM}, style);
            count += glm::length(style.wispOffset) > 1.15F ? 1 : 0;
        }
        return count;
    };
    QCOMPARE(outside(0.0F), 0);
    QVERIFY(outside(0.002F) > 10);
    QVERIFY(outside(0.008F) > 2 * outside(0.002F));
}

void TestLacedBraids::oneSeesNotThroughItsBeginning_data()
{
    QTest::addColumn<int>("kind");
    for (const auto& [name, kind] :
         {std::pair{"plait", BraidKind::Plait}, std::pair{"twist", BraidKind::Twist},
          std::pair{"plait of four", BraidKind::PlaitOfFour}, std::pair{"plait of five", BraidKind::PlaitOfFive},
          std::pair{"fishtail", BraidKind::Fishtail}})
        QTest::newRow(name) << static_cast<int>(kind);
}

/// Where the wisps have not parted yet, they are one bundle from whichever side.
void TestLacedBraids::oneSeesNotThroughItsBeginning()
{
    QFETCH(int, kind);
    constexpr float kGap = 0.06F; // Widest gap, as a fraction of the braid's radius.
    std::vector<glm::vec2> hairs;
    std::vector<glm::vec3> points;
    for (std::uint32_t rank = 0; rank < 3000; ++rank) {
        StrandStyle style;
        style.variation = static_cast<float>(rank) / 1500.0F - 1.0F;
        applyBraid({}, static_cast<BraidKind>(kind), wispChanceOf(1, rank),
                   {.lengthM = kStraightM, .radiusM = kRadiusM}, style);
        style.braidStart = 0.0F;
        evaluateStrand(straight(), {1.0F, 0.0F, 0.0F}, style, 60, points);
        hairs.emplace_back(points.front().x / kRadiusM, points.front().z / kRadiusM);
    }
    for (int side = 0; side < 24; ++side) {
        const float angle = 3.1416F * static_cast<float>(side) / 24.0F;
        std::vector<float> across;
        across.reserve(hairs.size());
        for (const glm::vec2 hair : hairs)
            across.push_back(hair.x * std::cos(angle) + hair.y * std::sin(angle));
        std::ranges::sort(across);
        for (std::size_t i = 1; i < across.size(); ++i)
            QVERIFY2(across[i] - across[i - 1] < kGap, qPrintable(QString::number(across[i] - across[i - 1])));
        QVERIFY2(across.back() - across.front() > 0.8F, qPrintable(QString::number(across.back() - across.front())));
    }
}

/// Strands are seen in it, but nothing through it.
void TestLacedBraids::hairsFillTheirWisp()
{
    constexpr float kEmpty = 0.15F; // Radius of the largest empty disc, as a fraction of the wisp's.
    std::vector<glm::vec2> hairs;
    for (std::uint32_t rank = 0; rank < 6000; ++rank) {
        StrandStyle style;
        applyBraid({}, BraidKind::Plait, wispChanceOf(1, rank), {.lengthM = 0.3F, .radiusM = kRadiusM}, style);
        hairs.push_back(style.wispOffset);
    }
    float largest = 0.0F;
    for (int x = -40; x <= 40; ++x)
        for (int y = -40; y <= 40; ++y) {
            const glm::vec2 at = glm::vec2(x, y) / 50.0F;
            if (glm::length(at) > 0.8F)
                continue;
            float nearest = 9.0F;
            for (const glm::vec2 hair : hairs)
                nearest = std::min(nearest, glm::length(hair - at));
            largest = std::max(largest, nearest);
        }
    QVERIFY2(largest < kEmpty, qPrintable(QString::number(largest)));
}

HAIRPAINT_TEST(TestLacedBraids, None)
#include "test_laced_braids.moc"
