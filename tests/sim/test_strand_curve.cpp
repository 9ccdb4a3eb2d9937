// Curves are the paper's equations, drawn along the skeleton.
#include "sim/groom/groom.h"
#include "sim/groom/strand_curve.h"
#include "sim/groom/strand_style.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace hairpaint::sim;

namespace {

constexpr float kPi = 3.14159265F;

/// Nodes evenly along a direction from the origin.
std::vector<glm::vec3> straightSkeleton(glm::vec3 direction, float lengthM, int nodes = 8)
{
    std::vector<glm::vec3> skeleton;
    skeleton.reserve(static_cast<std::size_t>(nodes));
    for (int i = 0; i < nodes; ++i)
        skeleton.push_back(direction * (lengthM * static_cast<float>(i) / static_cast<float>(nodes - 1)));
    return skeleton;
}

/// Nodes along three quarters of a circle in the plane z = 0.
std::vector<glm::vec3> bentSkeleton(float radiusM, int nodes = 16)
{
    std::vector<glm::vec3> skeleton;
    for (int i = 0; i < nodes; ++i) {
        const float angle = 1.5F * kPi * static_cast<float>(i) / static_cast<float>(nodes - 1);
        skeleton.emplace_back(radiusM * std::sin(angle), radiusM * (1.0F - std::cos(angle)), 0.0F);
    }
    return skeleton;
}

float lengthOf(const std::vector<glm::vec3>& points)
{
    float length = 0.0F;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += glm::length(points[i] - points[i - 1]);
    return length;
}

StrandStyle curledStyle(float turns, float radiusM, float phase = 0.0F)
{
    StrandStyle style;
    style.lengthM = 0.3F;
    style.turns = turns;
    style.curlRadiusM = radiusM;
    style.phase = phase;
    return style;
}

StrandStyle braidedStyle(std::uint32_t wisp, float start, BraidKind kind = BraidKind::Plait)
{
    StrandStyle style;
    style.lengthM = 0.3F;
    style.braid = kind;
    style.wisp = static_cast<std::uint8_t>(wisp);
    style.braidRadiusM = 0.01F;
    style.braidStart = start;
    style.braidTurns = 4.0F;
    return style;
}

} // namespace

class TestStrandCurve : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void turnsFollowTable1_data();
    void turnsFollowTable1();
    void offsetsAreTheEquations();
    void aCurlAlongZIsEquation1Literally_data();
    void aCurlAlongZIsEquation1Literally();
    void aBraidAlongYIsEquation3Literally();
    void theRootStaysWhereItIs_data();
    void theRootStaysWhereItIs();
    void aStraightStrandHasTheSkeletonsLengthAndNodes();
    void aBentStrandFollowsItsSkeleton();
    void curlsKeepTheirRadiusAroundABend();
    void wispsAreAThirdOfATurnApartAndCentredOnTheSkeleton();
    void wispsAreRoundAboutTheirOwnPath_data();
    void wispsAreRoundAboutTheirOwnPath();
    void wispsOfATightBraidHaveRoomBesideEachOther();
    void aTwistHasTwoWispsOnOppositeSides();
    void aLocIsOneWispToItsEnd();
    void hairsOfABraidAreTurnedAlikeFromWhereverTheyCome();
    void beforeABraidTheHairLiesOnItsSkeletonAndGathers();
    void aBraidThatBendsIsNotTwisted();
    void aBraidEndsInATuft();
    void thereAreEightPointsATurn_data();
    void thereAreEightPointsATurn();
    void strangeSkeletonsGiveNumbers_data();
    void strangeSkeletonsGiveNumbers();
};

void TestStrandCurve::turnsFollowTable1_data()
{
    QTest::addColumn<float>("value");
    QTest::addColumn<float>("turns");
    QTest::addColumn<float>("steppedTurns");
    QTest::newRow("straight") << 0.0F << 0.0F << 0.0F;
    QTest::newRow("level 1") << 0.2F << 0.5F << 0.5F;
    QTest::newRow("level 2") << 0.4F << 1.0F << 1.0F;
    QTest::newRow("level 3") << 0.6F << 4.0F << 4.0F;
    QTest::newRow("level 4") << 0.8F << 8.0F << 8.0F;
    QTest::newRow("level 5") << 1.0F << 16.0F << 16.0F;
    QTest::newRow("between 0 and 1") << 0.05F << 0.125F << 0.0F;
    QTest::newRow("between 2 and 3") << 0.5F << 2.5F << 4.0F;
    QTest::newRow("between 4 and 5") << 0.85F << 10.0F << 8.0F;
    QTest::newRow("beyond") << 7.0F << 16.0F << 16.0F;
    QTest::newRow("below") << -1.0F << 0.0F << 0.0F;
}

void TestStrandCurve::turnsFollowTable1()
{
    QFETCH(float, value);
    QFETCH(float, turns);
    QFETCH(float, steppedTurns);
    QVERIFY(std::abs(turnsOfCurl(value, false) - turns) < 1e-4F);
    QCOMPARE(turnsOfCurl(value, true), steppedTurns);
}

void TestStrandCurve::offsetsAreTheEquations()
{
    for (int i = 0; i < 100; ++i) {
        const float t = static_cast<float>(i) * 0.37F;
        QVERIFY(glm::length(curlOffset(t) - glm::vec3(std::cos(t), std::sin(t), std::cos(t) * std::sin(t))) < 1e-5F);
        QVERIFY(glm::length(braidOffset(t, 0.4F) - glm::vec3(std::cos(t + 0.4F), 0.0F, std::sin(2.0F * (t + 0.4F)))) <
                1e-5F);
    }
}

void TestStrandCurve::aCurlAlongZIsEquation1Literally_data()
{
    QTest::addColumn<float>("turns");
    QTest::addColumn<float>("phase");
    for (const float turns : {0.5F, 1.0F, 4.0F, 8.0F, 16.0F})
        QTest::addRow("%g turns", static_cast<double>(turns)) << turns << turns * 0.3F;
}

void TestStrandCurve::aCurlAlongZIsEquation1Literally()
{
    QFETCH(float, turns);
    QFETCH(float, phase);
    constexpr float kRadius = 0.006F;
    std::vector<glm::vec3> points;
    evaluateStrand(straightSkeleton({0.0F, 0.0F, 1.0F}, 0.3F), {1.0F, 0.0F, 0.0F}, curledStyle(turns, kRadius, phase),
                   200, points);
    QCOMPARE(points.size(), std::size_t{201});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float s = static_cast<float>(i) / 200.0F;
        const float radius = kRadius * std::min(1.0F, s / kCurlEaseFraction);
        const float t = phase + 2.0F * kPi * turns * s;
        const glm::vec3 expected(radius * std::cos(t), radius * std::sin(t),
                                 0.3F * s + radius * std::cos(t) * std::sin(t));
        QVERIFY2(glm::length(points[i] - expected) < 2e-6F, qPrintable(QString::number(i)));
    }
}

void TestStrandCurve::aBraidAlongYIsEquation3Literally()
{
    for (std::uint32_t wisp = 0; wisp < 3; ++wisp) {
        const StrandStyle style = braidedStyle(wisp, 0.0F);
        std::vector<glm::vec3> points;
        evaluateStrand(straightSkeleton({0.0F, 1.0F, 0.0F}, 0.3F), {1.0F, 0.0F, 0.0F}, style, 200, points);
        const float w = static_cast<float>(wisp) * 2.0F * kPi / 3.0F;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const float s = static_cast<float>(i) / 200.0F;
            if (s * style.braidTurns < kBraidEaseTurns || s > 1.0F - kTuftFraction - kTieFraction)
                continue;
            const float t = 2.0F * kPi * style.braidTurns * s;
            const glm::vec3 expected(0.01F * std::cos(t + w), 0.3F * s, 0.01F * std::sin(2.0F * (t + w)));
            QVERIFY2(glm::length(points[i] - expected) < 2e-6F, qPrintable(QString::number(i)));
        }
    }
}

void TestStrandCurve::theRootStaysWhereItIs_data()
{
    QTest::addColumn<bool>("braided");
    QTest::addColumn<float>("start");
    QTest::newRow("curled") << false << 0.0F;
    QTest::newRow("braided from the first node on") << true << 1.0F / 15.0F;
    QTest::newRow("braided further on") << true << 0.25F;
}

void TestStrandCurve::theRootStaysWhereItIs()
{
    QFETCH(bool, braided);
    QFETCH(float, start);
    const StrandStyle style = braided ? braidedStyle(1, start) : curledStyle(16.0F, 0.006F, 1.0F);
    const auto skeleton = bentSkeleton(0.06F);
    std::vector<glm::vec3> points;
    evaluateStrand(skeleton, {0.3F, 0.1F, 0.9F}, style, 128, points);
    QVERIFY(points.front() == skeleton.front());
}

void TestStrandCurve::aStraightStrandHasTheSkeletonsLengthAndNodes()
{
    const auto skeleton = straightSkeleton(glm::normalize(glm::vec3(1.0F, 2.0F, -1.0F)), 0.25F);
    for (const int segments : {7, 14, 31}) {
        std::vector<glm::vec3> points;
        evaluateStrand(skeleton, {0.0F, 0.0F, 1.0F}, curledStyle(0.0F, 0.0F), segments, points);
        QCOMPARE(points.size(), static_cast<std::size_t>(segments + 1));
        QVERIFY(std::abs(lengthOf(points) - 0.25F) < 1e-5F);
        QVERIFY(glm::length(points.back() - skeleton.back()) < 1e-6F);
    }
}

void TestStrandCurve::aBentStrandFollowsItsSkeleton()
{
    const auto skeleton = bentSkeleton(0.06F);
    std::vector<glm::vec3> points;
    evaluateStrand(skeleton, {0.0F, 0.0F, 1.0F}, StrandStyle{}, 60, points);
    for (std::size_t node = 0; node < skeleton.size(); ++node)
        QVERIFY(glm::length(points[node * 4] - skeleton[node]) < 1e-6F);
    QVERIFY(std::abs(lengthOf(points) - 1.5F * kPi * 0.06F) < 0.01F * 0.28F);
}

void TestStrandCurve::curlsKeepTheirRadiusAroundABend()
{
    const auto skeleton = bentSkeleton(0.06F);
    std::vector<glm::vec3> axis;
    std::vector<glm::vec3> points;
    evaluateStrand(skeleton, {0.0F, 0.0F, 1.0F}, StrandStyle{}, 240, axis);
    evaluateStrand(skeleton, {0.0F, 0.0F, 1.0F}, curledStyle(8.0F, 0.004F), 240, points);
    for (std::size_t i = 60; i < points.size(); ++i) {
        // (cos, sin, cos sin) has a length of 1 to sqrt(5)/2.
        const float radius = glm::length(points[i] - axis[i]) / 0.004F;
        QVERIFY2(radius > 0.999F && radius < 1.119F, qPrintable(QString::number(static_cast<double>(radius))));
    }
}

void TestStrandCurve::wispsAreAThirdOfATurnApartAndCentredOnTheSkeleton()
{
    constexpr int kSegments = 240;
    const auto skeleton = straightSkeleton({0.0F, 1.0F, 0.0F}, 0.3F);
    std::array<std::vector<glm::vec3>, 3> wisps;
    for (std::uint32_t wisp = 0; wisp < 3; ++wisp)
        evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, braidedStyle(wisp, 0.0F), kSegments, wisps[wisp]);
    // 4 turns in 240 segments: a third of a turn is 20 of them.
    for (std::size_t i = 40; i < 180; ++i) {
        const glm::vec3 mean = (wisps[0][i] + wisps[1][i] + wisps[2][i]) / 3.0F;
        QVERIFY(glm::length(mean - glm::vec3(0.0F, 0.3F * static_cast<float>(i) / kSegments, 0.0F)) < 1e-5F);
        for (std::size_t wisp = 0; wisp < 2; ++wisp) {
            const glm::vec3 later = wisps[wisp][i + 20] - wisps[wisp + 1][i];
            QVERIFY(std::abs(later.x) < 1e-5F && std::abs(later.z) < 1e-5F);
        }
    }
}

void TestStrandCurve::wispsAreRoundAboutTheirOwnPath_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("plait") << static_cast<int>(BraidKind::Plait);
    QTest::newRow("twist") << static_cast<int>(BraidKind::Twist);
    QTest::newRow("fishtail") << static_cast<int>(BraidKind::Fishtail);
}

void TestStrandCurve::wispsAreRoundAboutTheirOwnPath()
{
    QFETCH(int, kind);
    constexpr int kSegments = 1000;
    const auto skeleton = straightSkeleton({0.0F, 1.0F, 0.0F}, 0.3F);
    StrandStyle style = braidedStyle(0, 0.0F, static_cast<BraidKind>(kind));
    const float radius = lacingOf(style.braid).wisp * style.braidRadiusM;
    std::vector<glm::vec3> middle;
    std::vector<glm::vec3> aside;
    evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, kSegments, middle);
    style.wispOffset = {0.6F, -0.8F};
    evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, kSegments, aside);
    for (std::size_t i = 200; i < 800; ++i) {
        const glm::vec3 offset = aside[i] - middle[i];
        QVERIFY(std::abs(glm::length(offset) - radius) < 1e-5F);
        QVERIFY(std::abs(glm::dot(offset, glm::normalize(middle[i + 1] - middle[i - 1]))) < 0.01F * radius);
    }
}

void TestStrandCurve::wispsOfATightBraidHaveRoomBesideEachOther()
{
    constexpr int kSegments = 1000;
    const auto skeleton = straightSkeleton({0.0F, 1.0F, 0.0F}, 0.3F);
    StrandStyle style = braidedStyle(0, 0.0F);
    style.braidTurns = 20.0F;
    const float turnM = 0.3F / style.braidTurns;
    std::vector<glm::vec3> middle;
    std::vector<glm::vec3> aside;
    evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, kSegments, middle);
    style.wispOffset = {0.0F, 1.0F};
    evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, kSegments, aside);
    float furthest = 0.0F;
    for (std::size_t i = 200; i < 800; ++i)
        furthest = std::max(furthest, std::abs(aside[i].y - middle[i].y));
    QVERIFY(furthest <= kPlaitRoomTurns * turnM * 1.001F);
    QVERIFY(furthest > turnM / 6.0F); // Three of them leave no gap.
}

void TestStrandCurve::aTwistHasTwoWispsOnOppositeSides()
{
    const auto skeleton = straightSkeleton({0.0F, 1.0F, 0.0F}, 0.3F);
    std::array<std::vector<glm::vec3>, 2> wisps;
    for (std::uint32_t wisp = 0; wisp < 2; ++wisp)
        evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, braidedStyle(wisp, 0.0F, BraidKind::Twist), 240, wisps.at(wisp));
    for (std::size_t i = 40; i < 165; ++i) {
        const glm::vec3 axis(0.0F, 0.3F * static_cast<float>(i) / 240.0F, 0.0F);
        QVERIFY(glm::length(0.5F * (wisps[0][i] + wisps[1][i]) - axis) < 1e-5F);
        QVERIFY(std::abs(glm::length(wisps[0][i] - axis) - kTwistFraction * 0.01F) < 1e-5F);
        // 4 turns in 240 segments: after half a turn each wisp is where the other was.
        const glm::vec3 later = wisps[0][i + 30] - wisps[1][i];
        QVERIFY(std::abs(later.x) < 1e-5F && std::abs(later.z) < 1e-5F);
    }
}

void TestStrandCurve::aLocIsOneWispToItsEnd()
{
    const auto skeleton = straightSkeleton({0.0F, 1.0F, 0.0F}, 0.3F);
    StrandStyle style = braidedStyle(0, 0.0F, BraidKind::Loc);
    style.wispOffset = {0.6F, -0.8F};
    std::vector<glm::vec3> points;
    evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, 100, points);
    for (std::size_t i = 20; i < points.size(); ++i) {
        const glm::vec2 offset(points[i].x, points[i].z);
        QVERIFY(std::abs(glm::length(offset) - kLocWispFraction * style.braidRadiusM) < 1e-6F);
    }
}

void TestStrandCurve::hairsOfABraidAreTurnedAlikeFromWhereverTheyCome()
{
    // Two hairs come from opposite sides, then follow the same skeleton.
    std::vector<glm::vec3> left{{-0.08F, 0.02F, 0.0F}, {-0.04F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}};
    std::vector<glm::vec3> right{{0.05F, 0.01F, 0.07F}, {0.02F, 0.0F, 0.03F}, {0.0F, 0.0F, 0.0F}};
    for (int i = 1; i <= 6; ++i) {
        const glm::vec3 node(0.01F * static_cast<float>(i), -0.04F * static_cast<float>(i), 0.02F);
        left.push_back(node);
        right.push_back(node);
    }
    const StrandStyle style = braidedStyle(1, 0.25F);
    std::vector<glm::vec3> fromLeft;
    std::vector<glm::vec3> fromRight;
    evaluateStrand(left, {0.0F, 0.0F, 1.0F}, style, 160, fromLeft);
    evaluateStrand(right, {0.0F, 0.0F, 1.0F}, style, 160, fromRight);
    // The first node after the gathering shares one neighbour only; from the next on the curves are one.
    for (std::size_t i = 60; i <= 160; ++i)
        QVERIFY(glm::length(fromLeft[i] - fromRight[i]) < 1e-6F);
}

void TestStrandCurve::beforeABraidTheHairLiesOnItsSkeletonAndGathers()
{
    const auto skeleton = bentSkeleton(0.06F);
    std::vector<glm::vec3> plain;
    std::vector<glm::vec3> braided;
    evaluateStrand(skeleton, {0.0F, 0.0F, 1.0F}, StrandStyle{}, 150, plain);
    evaluateStrand(skeleton, {0.0F, 0.0F, 1.0F}, braidedStyle(2, 0.4F), 150, braided);
    for (std::size_t i = 0; i <= 50; ++i)
        QVERIFY(plain[i] == braided[i]);
    // Over the span before, it comes to where the wisp begins, beside the middle of the braid.
    for (std::size_t i = 51; i <= 60; ++i)
        QVERIFY(glm::length(plain[i] - braided[i]) > glm::length(plain[i - 1] - braided[i - 1]));
    const float beside = kBraidFirstFraction * 0.01F * glm::length(braidOffset(0.0F, 4.0F / 3.0F * kPi));
    QVERIFY(std::abs(glm::length(plain[60] - braided[60]) - beside) < 1e-5F);
    QVERIFY(glm::length(plain[100] - braided[100]) > 0.003F);
}

void TestStrandCurve::aBraidThatBendsIsNotTwisted()
{
    // Down, and then along the root's own tangent, past which its projection would turn over.
    std::vector<glm::vec3> skeleton{{0.0F, 0.0F, 0.0F}};
    for (int i = 1; i < 16; ++i) {
        const float angle = 0.5F * kPi * std::clamp(static_cast<float>(i - 5) / 4.0F, 0.0F, 1.04F);
        skeleton.push_back(skeleton.back() + 0.02F * glm::vec3(std::sin(angle), -std::cos(angle), 0.001F));
    }
    StrandStyle style = braidedStyle(0, 0.2F);
    style.braidTurns = 0.01F; // The wisp shows the frame.
    style.wisp = 1;
    style.braidRadiusM = 1.0F;
    std::vector<glm::vec3> middle;
    std::vector<glm::vec3> wisp;
    evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, StrandStyle{}, 150, middle);
    evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, 150, wisp);
    for (std::size_t i = 41; i < 120; ++i) {
        const glm::vec3 before = glm::normalize(wisp[i - 1] - middle[i - 1]);
        const glm::vec3 here = glm::normalize(wisp[i] - middle[i]);
        QVERIFY2(glm::dot(before, here) > 0.99F, qPrintable(QString::number(i)));
    }
}

void TestStrandCurve::aBraidEndsInATuft()
{
    const auto skeleton = straightSkeleton({0.0F, 1.0F, 0.0F}, 0.3F);
    StrandStyle style = braidedStyle(0, 0.0F);
    std::vector<glm::vec3> middle;
    std::vector<glm::vec3> aside;
    evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, 200, middle);
    style.wispOffset.x = 1.0F;
    evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, 200, aside);
    const auto besideAxis = [](glm::vec3 point) { return glm::length(glm::vec2(point.x, point.z)); };
    // Drawn together before it.
    const auto tie = static_cast<std::size_t>(200.0F * (1.0F - kTuftFraction));
    QVERIFY(besideAxis(middle[tie]) < 1.5F * kTieBraidFraction * style.braidRadiusM);
    QVERIFY(glm::length(aside[tie] - middle[tie]) < 0.8F * glm::length(aside[120] - middle[120]));
    // Its wisps are one in the end, which opens and narrows again.
    QVERIFY(besideAxis(middle.back()) < 0.01F * style.braidRadiusM);
    const auto opened = static_cast<std::size_t>(200.0F * (1.0F - kTuftFraction * (1.0F - kTuftOpens))) + 1;
    QVERIFY(besideAxis(aside[opened]) > 1.2F * kWispRadiusFraction * style.braidRadiusM);
    QVERIFY(besideAxis(aside.back()) < kWispRadiusFraction * style.braidRadiusM);
    // Each hair ends by chance.
    float first = 0.3F;
    float last = 0.0F;
    for (int i = 0; i <= 50; ++i) {
        style.variation = static_cast<float>(i) * 0.04F - 1.0F;
        evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, style, 200, aside);
        first = std::min(first, aside.back().y);
        last = std::max(last, aside.back().y);
    }
    constexpr float kUnevenM = 0.3F * kTuftFraction * kTuftUneven;
    QVERIFY(last < 0.3F + 1e-5F && last > 0.3F - 0.2F * kUnevenM);
    QVERIFY(first > 0.3F - kUnevenM - 1e-5F && first < 0.3F - 0.8F * kUnevenM);
}

void TestStrandCurve::thereAreEightPointsATurn_data()
{
    QTest::addColumn<float>("turns");
    QTest::addColumn<bool>("braided");
    QTest::addColumn<int>("least");
    QTest::addColumn<int>("most");
    QTest::newRow("straight") << 0.0F << false << 7 << 14;
    QTest::newRow("half a turn") << 0.5F << false << 7 << 14;
    QTest::newRow("sixteen turns") << 16.0F << false << 128 << 128;
    QTest::newRow("more than is drawn") << 400.0F << false << 256 << 256;
    QTest::newRow("a braid, four turns on three quarters") << 0.0F << true << 86 << 90;
}

void TestStrandCurve::thereAreEightPointsATurn()
{
    QFETCH(float, turns);
    QFETCH(bool, braided);
    QFETCH(int, least);
    QFETCH(int, most);
    const StrandStyle style = braided ? braidedStyle(0, 0.25F) : curledStyle(turns, turns > 0.0F ? 0.006F : 0.0F);
    const int segments = segmentsOf(style, 8);
    QVERIFY2(segments >= least && segments <= most, qPrintable(QString::number(segments)));
}

void TestStrandCurve::strangeSkeletonsGiveNumbers_data()
{
    QTest::addColumn<int>("nodes");
    QTest::addColumn<float>("lengthM");
    QTest::addColumn<bool>("alongTangent");
    QTest::newRow("all nodes at one point") << 8 << 0.0F << false;
    QTest::newRow("two nodes") << 2 << 0.1F << false;
    QTest::newRow("along the frame's tangent") << 8 << 0.1F << true;
    QTest::newRow("one node") << 1 << 0.0F << false;
}

void TestStrandCurve::strangeSkeletonsGiveNumbers()
{
    QFETCH(int, nodes);
    QFETCH(float, lengthM);
    QFETCH(bool, alongTangent);
    std::vector<glm::vec3> skeleton(static_cast<std::size_t>(nodes), glm::vec3(0.0F));
    for (int i = 1; i < nodes; ++i)
        skeleton[static_cast<std::size_t>(i)].y = lengthM * static_cast<float>(i);
    const glm::vec3 tangent = alongTangent ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
    for (const StrandStyle& style : {curledStyle(4.0F, 0.01F), braidedStyle(1, 0.25F), braidedStyle(1, 1.0F)}) {
        std::vector<glm::vec3> points;
        evaluateStrand(skeleton, tangent, style, 40, points);
        QCOMPARE(points.size(), std::size_t{nodes > 1 ? 41U : 0U});
        for (const glm::vec3& point : points)
            QVERIFY(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z));
    }
}

HAIRPAINT_TEST(TestStrandCurve, None)
#include "test_strand_curve.moc"
