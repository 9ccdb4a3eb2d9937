// Hair follows the painted direction over the head and leaves it where it should.
#include "sim/groom/lay.h"
#include "sim/groom/stream_raster.h"
#include "sim/skin/natural_stream.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace hairpaint::sim;
using namespace hairpaint::test;

namespace {

constexpr float kBallM = 0.1F;
constexpr std::size_t kNodes = 8;
using Nodes = std::array<glm::vec3, kNodes>;

/// A ball of a head whose hair has one direction in the frame of every root, and how hairs lie on it.
class LaidBall
{
public:
    explicit LaidBall(DirectionVector direction, float coatM = 0.004F, bool stream = false, float radiusM = kBallM)
        : m_radiusM(radiusM), m_skin(makeBallHead(96, radiusM)), m_band(std::make_shared<SkinBand>(m_skin)),
          m_natural(stream ? streamRaster(m_skin, naturalStream(m_skin, std::nullopt)) : nullptr),
          m_map(stream ? m_natural : std::make_shared<const TiledRaster>(256, 2, texelOfDirection(direction))),
          m_field(m_band, m_natural, m_map), m_sampler(m_map), m_coatM(coatM)
    {
        if (m_natural)
            m_naturalSampler.emplace(m_natural);
    }

    /// What else a hair may have.
    struct More
    {
        glm::vec3 strayHd{0.0F};
        float coatRiseM = 0.0F;
        std::vector<std::int32_t>* passed = nullptr;
        float liftM = 0.0F;
    };
    [[nodiscard]] Nodes lay(glm::vec3 at, float lengthM, float chance = 0.5F) const
    {
        return lay(at, lengthM, chance, {});
    }
    [[nodiscard]] Nodes lay(glm::vec3 at, float lengthM, float chance, const More& more) const
    {
        const SurfacePoint point = m_skin.nearest(m_radiusM * glm::normalize(at));
        Lay lay({.direction = m_sampler,
                 .natural = m_naturalSampler ? &*m_naturalSampler : nullptr,
                 .field = &m_field,
                 .coatM = m_coatM,
                 .coatRiseM = more.coatRiseM},
                kNodes);
        (void)lay.add({.positionHd = point.positionHd,
                       .frame = SkinFrame::at(point),
                       .uv = point.uv,
                       .chance = chance,
                       .strayHd = more.strayHd,
                       .liftM = more.liftM},
                      lengthM);
        lay.lay();
        if (more.passed != nullptr)
            more.passed->assign(lay.passed(0).begin(), lay.passed(0).end());
        Nodes nodes;
        lay.read(0, nodes);
        return nodes;
    }
    /// Whether a hair grows there beside a parting that bares so much.
    [[nodiscard]] bool grows(glm::vec3 at, float lengthM, float partGapM) const
    {
        const SurfacePoint point = m_skin.nearest(m_radiusM * glm::normalize(at));
        Lay lay({.direction = m_sampler,
                 .natural = m_naturalSampler ? &*m_naturalSampler : nullptr,
                 .field = &m_field,
                 .partGapM = partGapM},
                kNodes);
        return lay.add({.positionHd = point.positionHd, .frame = SkinFrame::at(point), .uv = point.uv}, lengthM);
    }
    [[nodiscard]] std::int32_t cellAt(glm::vec3 hd) const { return m_band->cellAt(hd); }
    [[nodiscard]] SkinFrame frameAt(glm::vec3 at) const
    {
        return SkinFrame::at(m_skin.nearest(m_radiusM * glm::normalize(at)));
    }

private:
    float m_radiusM;
    Skin m_skin;
    std::shared_ptr<const SkinBand> m_band;
    MapRaster m_natural;
    MapRaster m_map;
    LayField m_field;
    MapSampler m_sampler;
    std::optional<MapSampler> m_naturalSampler;
    float m_coatM;
};

const glm::vec3 kSide(1.0F, 0.3F, 0.2F);

} // namespace

class TestLay : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void uprightHairIsStraight();
    void hairLeavesTheSkinAtItsAngle_data();
    void hairLeavesTheSkinAtItsAngle();
    void flatHairFollowsTheHead_data();
    void flatHairFollowsTheHead();
    void hairLongerThanItsPathIsFree();
    void longHairThatLeavesTheHeadHangs();
    void fieldsThatStandHoldNothing();
    void longHairFallsToItsSideWhereNobodyCombed();
    void hairThatStraysAcrossAPartingLiesToItsOtherSide();
    void curlsFallOverTheMiddleOfAWhorl();
    void aPartingBaresAsMuchAsIsSet();
    void theCoatRisesFromTheRoots();
};

void TestLay::uprightHairIsStraight()
{
    const LaidBall ball(DirectionVector(0.0F));
    const Nodes nodes = ball.lay(kSide, 0.07F);
    const glm::vec3 normal = ball.frameAt(kSide).normal;
    for (std::size_t i = 0; i < kNodes; ++i)
        QVERIFY(glm::distance(nodes[i], nodes[0] + normal * (0.01F * static_cast<float>(i))) < 1e-6F);
}

void TestLay::hairLeavesTheSkinAtItsAngle_data()
{
    QTest::addColumn<float>("flatness");
    for (const float flatness : {0.1F, 0.3F, 0.5F, 0.7F, 0.9F})
        QTest::addRow("%.1f", static_cast<double>(flatness)) << flatness;
}

void TestLay::hairLeavesTheSkinAtItsAngle()
{
    QFETCH(float, flatness);
    const LaidBall ball({0.0F, -flatness}, 0.05F);
    const Nodes nodes = ball.lay(kSide, 0.007F); // Too short to turn.
    const SkinFrame frame = ball.frameAt(kSide);
    const glm::vec3 first = (nodes[1] - nodes[0]) / glm::distance(nodes[1], nodes[0]);
    QVERIFY(std::abs(glm::dot(first, frame.y) + flatness) < 0.12F);
    QVERIFY(std::abs(glm::dot(first, frame.x)) < 0.02F);
    QVERIFY(glm::dot(first, frame.normal) > 0.1F);
}

void TestLay::flatHairFollowsTheHead_data()
{
    QTest::addColumn<float>("lengthM");
    QTest::addColumn<float>("chance");
    for (const float lengthM : {0.01F, 0.03F, 0.07F, 0.15F})
        for (const float chance : {0.0F, 1.0F})
            QTest::addRow("%.0f cm, %.0f", 100.0 * static_cast<double>(lengthM), static_cast<double>(chance))
                << lengthM << chance;
}

void TestLay::flatHairFollowsTheHead()
{
    QFETCH(float, lengthM);
    QFETCH(float, chance);
    const LaidBall ball({0.9F, 0.0F}, 0.006F);
    const Nodes nodes = ball.lay(kSide, lengthM, chance);
    for (std::size_t i = 1; i < kNodes; ++i) {
        QVERIFY(std::abs(glm::distance(nodes[i - 1], nodes[i]) - lengthM / 7.0F) < 1e-5F);
        const float heightM = glm::length(nodes[i]) - kBallM;
        // Never in the head, and no higher than the coat with what a step leaves.
        QVERIFY2(heightM > -0.0005F && heightM < 0.0095F, qPrintable(QString::number(heightM)));
    }
    // It turned with the ball: around the axis, as far as it is long.
    const float turned = std::atan2(nodes[7].x, nodes[7].z) - std::atan2(nodes[0].x, nodes[0].z);
    const float around = std::hypot(nodes[0].x, nodes[0].z);
    QVERIFY2(std::abs(std::abs(turned) * around / lengthM - 0.93F) < 0.15F, qPrintable(QString::number(turned)));
}

void TestLay::hairLongerThanItsPathIsFree()
{
    // Past Lay::kFurthestM hair that goes up goes on straight,
    const LaidBall upward({0.0F, 0.95F});
    const Nodes risen = upward.lay({1.0F, -0.6F, 0.2F}, 0.5F);
    QVERIFY(risen[7].y > risen[5].y);
    for (std::size_t i = 5; i < kNodes; ++i)
        QVERIFY(glm::distance(risen[i] - risen[i - 1], risen[i - 1] - risen[i - 2]) < 1e-5F);
    QVERIFY(glm::length(risen[7]) > 0.2F);
}

void TestLay::longHairThatLeavesTheHeadHangs()
{
    const auto cosines = [](DirectionVector direction, glm::vec3 at, float lengthM) {
        const Nodes nodes = LaidBall(direction).lay(at, lengthM);
        std::array<float, kNodes - 1> down{};
        for (std::size_t i = 0; i + 1 < kNodes; ++i)
            down[i] = (nodes[i].y - nodes[i + 1].y) / glm::distance(nodes[i], nodes[i + 1]);
        return down;
    };
    // Around the ball and a little down: it turns to hang, by and by.
    const auto around = cosines({0.95F, -0.2F}, kSide, 0.5F);
    for (std::size_t i = 3; i < around.size(); ++i)
        QVERIFY2(around[i] > around[i - 1], qPrintable(QString::number(i)));
    QVERIFY2(around.back() > 0.98F, qPrintable(QString::number(around.back())));
    // Hair too short to fall keeps its way: 7 cm stand off at the side as they are laid.
    const auto standing = cosines({0.0F, -0.2F}, {1.0F, 0.0F, 0.0F}, 0.07F);
    QVERIFY(standing.back() < 0.6F);
}

void TestLay::fieldsThatStandHoldNothing()
{
    const LaidBall ball({0.1F, 0.0F});
    const Nodes nodes = ball.lay(kSide, 0.07F);
    for (std::size_t i = 2; i < kNodes; ++i)
        QVERIFY(glm::distance(nodes[i] - nodes[i - 1], nodes[1] - nodes[0]) < 1e-5F);
}

void TestLay::longHairFallsToItsSideWhereNobodyCombed()
{
    const LaidBall ball({}, 0.004F, true);
    const glm::vec3 forehead(0.3F, 0.8F, 0.5F);
    const auto goes = [&](float lengthM) {
        const Nodes nodes = ball.lay(forehead, lengthM);
        return (nodes[1] - nodes[0]) / glm::distance(nodes[1], nodes[0]);
    };
    QVERIFY(goes(0.03F).z > goes(0.03F).x); // As it grows: forward, away from the whorl on top.
    QVERIFY(goes(0.30F).x > 0.7F);
    QVERIFY(goes(0.30F).z < goes(0.30F).x);
}

void TestLay::hairThatStraysAcrossAPartingLiesToItsOtherSide()
{
    const LaidBall ball({0.0F, 0.0F}, 0.004F, true);
    const glm::vec3 besideHd(-0.004F, kBallM, 0.01F);
    const glm::vec3 strayHd(0.009F, 0.0F, 0.0F);
    std::vector<std::int32_t> passed;
    QVERIFY(ball.lay(besideHd, 0.25F).back().x < -0.05F);
    const Nodes over = ball.lay(besideHd, 0.25F, 0.5F, {.strayHd = strayHd, .passed = &passed});
    QVERIFY2(over.back().x > 0.05F, qPrintable(QString::number(over.back().x)));

    // Should that cell be combed, the hair is to be laid anew.
    const glm::vec3 rootHd = ball.lay(besideHd, 0.25F).front();
    QVERIFY(std::ranges::find(passed, ball.cellAt(rootHd + strayHd)) != passed.end());
    QVERIFY(ball.cellAt(rootHd + strayHd) != SkinBand::kNone);
    // Where hairs around lie as it does it keeps every bit.
    QCOMPARE(ball.lay(kSide, 0.25F, 0.5F, {.strayHd = strayHd}), ball.lay(kSide, 0.25F));
}

void TestLay::curlsFallOverTheMiddleOfAWhorl()
{
    const LaidBall ball({0.0F, 0.0F}, 0.004F, true);
    constexpr int kHairs = 400;
    // How many of those that grow so far from it come over it.
    const auto over = [&ball](float fromM, float lengthM, float liftM) {
        int count = 0;
        for (int i = 0; i < kHairs; ++i) {
            const float angle = 0.7F * static_cast<float>(i);
            const float chance = (static_cast<float>(i) + 0.5F) / kHairs;
            const Nodes nodes = ball.lay({fromM * std::cos(angle), kBallM, fromM * std::sin(angle)}, lengthM, chance,
                                         {.strayHd = glm::vec3(1e-4F, 0.0F, 0.0F), .liftM = liftM});
            float nearestM = fromM;
            for (std::size_t k = 1; k < kNodes; ++k) {
                const glm::vec2 from(nodes[k - 1].x, nodes[k - 1].z);
                const glm::vec2 along = glm::vec2(nodes[k].x, nodes[k].z) - from;
                const float t = std::clamp(-glm::dot(from, along) / glm::dot(along, along), 0.0F, 1.0F);
                nearestM = std::min(nearestM, glm::length(from + along * t));
            }
            count += nearestM < 0.5F * fromM ? 1 : 0;
        }
        return count;
    };
    QCOMPARE(over(0.004F, 0.04F, 0.0F), 0); // A straight whorl shows how it turns.
    const int curled = over(0.004F, 0.04F, 0.006F);
    QVERIFY2(curled > kHairs / 5 && curled < kHairs * 2 / 3, qPrintable(QString::number(curled)));
    QCOMPARE(over(0.030F, 0.04F, 0.006F), 0);
    QCOMPARE(over(0.004F, 0.25F, 0.006F), over(0.004F, 0.25F, 0.0F)); // Long hair falls.

    // Past a chin hair grows as steeply, and goes its way.
    const LaidBall tall({0.0F, 0.0F}, 0.004F, true, 0.15F);
    for (int i = 0; i < kHairs; ++i) {
        const float angle = 0.7F * static_cast<float>(i);
        const glm::vec3 at(0.4F * std::cos(angle), -0.9F, 0.4F * std::sin(angle));
        const auto firstOf = [&](float liftM) {
            const Nodes nodes = tall.lay(at, 0.03F, (static_cast<float>(i) + 0.5F) / kHairs,
                                         {.strayHd = glm::vec3(1e-4F, 0.0F, 0.0F), .liftM = liftM});
            const glm::vec3 normal = glm::normalize(nodes[0]);
            return nodes[1] - normal * glm::dot(nodes[1], normal);
        };
        QVERIFY(glm::dot(firstOf(0.006F), firstOf(0.0F)) > 0.0F); // Along the skin.
    }
}

void TestLay::aPartingBaresAsMuchAsIsSet()
{
    // Long hair falls to both sides of the middle, from the forehead to behind the top.
    const LaidBall ball({0.0F, 0.0F}, 0.004F, true);
    constexpr float kGapM = 0.004F;
    constexpr float kStepM = 0.0002F;
    float bareM = 0.0F;
    constexpr int kLines = 12;
    for (int line = 0; line < kLines; ++line)
        for (int step = -40; step <= 40; ++step) {
            const glm::vec3 at(kStepM * static_cast<float>(step), kBallM, 0.02F + 0.0035F * static_cast<float>(line));
            QVERIFY(ball.grows(at, 0.25F, 0.0F) && ball.grows(at, 0.015F, kGapM));
            if (ball.grows(at, 0.25F, kGapM))
                continue;
            bareM += kStepM / kLines;
            QVERIFY2(std::abs(at.x) < kGapM, qPrintable(QString::number(at.x)));
        }
    QVERIFY2(std::abs(bareM / kGapM - 1.0F) < 0.25F, qPrintable(QString::number(bareM)));
    // Beside it, and where hair goes one way, all of it grows.
    for (const glm::vec3 at : {kSide, glm::vec3(0.01F, kBallM, 0.02F), glm::vec3(0.0F, 0.0F, -kBallM)})
        QVERIFY(ball.grows(at, 0.25F, kGapM));
}

void TestLay::theCoatRisesFromTheRoots()
{
    const LaidBall ball({0.95F, 0.0F}, 0.01F);
    const float lengthM = 0.02F * static_cast<float>(kNodes - 1);
    const auto heights = [&](float riseM) {
        const Nodes nodes = ball.lay(kSide, lengthM, 1.0F, {.coatRiseM = riseM});
        std::array<float, kNodes> above{};
        std::ranges::transform(nodes, above.begin(), [](glm::vec3 node) { return glm::length(node) - kBallM; });
        return above;
    };
    const auto atOnce = heights(0.0F);
    const auto rising = heights(0.05F);
    QVERIFY2(atOnce[1] > 0.006F, qPrintable(QString::number(atOnce[1])));
    QVERIFY2(rising[1] < 0.004F, qPrintable(QString::number(rising[1])));
    QVERIFY2(std::abs(rising[5] - atOnce[5]) < 0.002F, qPrintable(QString::number(rising[5])));
    // Over the top of a head no hair that lies to the side is higher than the parting.
    const LaidBall parted({0.0F, 0.0F}, 0.008F, true);
    const Nodes side = parted.lay({0.002F, kBallM, 0.0F}, 0.25F, 1.0F, {.coatRiseM = 0.05F});
    for (const glm::vec3& node : side)
        QVERIFY2(node.y < side.front().y + 0.0005F, qPrintable(QString::number(node.y - side.front().y)));
}

HAIRPAINT_TEST(TestLay, Core)
#include "test_lay.moc"
