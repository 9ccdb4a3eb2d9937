// Strands are drawn as round as the picture's samples need, at any zoom.
#include "sim/groom/strand_curve.h"
#include "tests/support/test_program.h"
#include "view/rendering/frame_constants.h"
#include "view/rendering/software/strand_kernel.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace hairpaint;
using namespace hairpaint::rendering;

namespace {

constexpr int kNodes = 8;
constexpr float kToleranceSp = 0.2F; ///< Tolerance of still pictures, samples; they have two samples across a pixel.
constexpr float kSeenSp = 0.5F;      ///< Least deviation that is visible, samples.

/// What makes a strand round, in its first lane; the others hold nothing.
struct RoundStrand
{
    float bendRad = 0.0F; ///< Angle of the bend from root to tip.
    float turns = 0.0F;
    float curlRadiusM = 0.0F;
    sim::BraidKind braid = sim::BraidKind::None;
    float frizzM = 0.0F;
};

StrandBlock blockOf(const RoundStrand& strand)
{
    constexpr float kLengthM = 0.2F;
    constexpr float kBraidRadiusM = 0.012F;
    constexpr float kBraidTurns = 4.0F;
    StrandBlock block{};
    block.nodes = kNodes;
    block.anyCurl = strand.turns > 0.0F;
    block.anyBraid = strand.braid != sim::BraidKind::None;
    block.anyFrizz = strand.frizzM > 0.0F;
    block.anyFrame = block.anyCurl || block.anyBraid || block.anyFrizz;
    sim::StrandStyle frizzy;
    frizzy.lengthM = kLengthM;
    frizzy.frizzM = strand.frizzM;
    block.frizzM[0] = sim::frizzOf(frizzy).radiusM;
    block.frizzRad[0] = sim::frizzOf(frizzy).waveRad;
    block.perTaper.fill(1.0F);
    block.turns[0] = strand.turns;
    block.curlRadiusM[0] = strand.curlRadiusM;
    block.width[0] = 1.0F;
    block.braid[0] = static_cast<float>(strand.braid);
    block.braidRadiusM[0] = kBraidRadiusM;
    block.braidTurns[0] = kBraidTurns;
    block.nodesWo.assign(std::size_t{kNodes} * 3 * kBlockLanes, 0.0F);
    block.tangentWo[0] = 1.0F;
    for (int n = 0; n < kNodes; ++n) {
        const float s = static_cast<float>(n) / (kNodes - 1);
        glm::vec3 position(0.0F, kLengthM * (0.5F - s), 0.0F);
        if (strand.bendRad > 0.0F) {
            const float radiusM = kLengthM / strand.bendRad;
            const float angle = strand.bendRad * (s - 0.5F);
            position = {radiusM * (std::cos(angle) - 1.0F), -radiusM * std::sin(angle), 0.0F};
        }
        for (std::size_t lane = 0; lane < kBlockLanes; ++lane)
            for (int axis = 0; axis < 3; ++axis)
                block.nodesWo[(static_cast<std::size_t>(n) * 3 + static_cast<std::size_t>(axis)) * kBlockLanes + lane] =
                    position[axis];
    }
    return block;
}

StrandView viewFrom(float distanceM, float toleranceSp)
{
    static const std::vector<std::uint32_t> empty(std::size_t{kGridSide} * kGridSide * kGridSide * 2, 0U);
    Scene scene;
    scene.camera.targetWo = glm::vec3(0.0F);
    scene.camera.elevationRad = 0.0F;
    scene.camera.distanceM = distanceM;
    const FrameConstants constants =
        frameConstants(scene, {.width = 1000, .height = 1000, .samples = glm::ivec2(2)}, 0.0F);
    return {.projectionFromWo = constants.projectionFromWo,
            .gridFromWo = constants.gridFromWo[0],
            .eyeGrid = {},
            .coatAxes = {},
            .opacity = {empty.data(), empty.data()},
            .gridSide = kGridSide,
            .sizeSp = glm::vec2(constants.target),
            .samplesPerM = constants.gridSize.z,
            .groupWidthM = 1e-3F,
            .nearestM = constants.depthRange.x,
            .depthsPerM = constants.depthRange.y,
            .toleranceSp = toleranceSp,
            .lighting = {}};
}

/// The drawn points of the first lane, samples.
std::vector<glm::vec2> drawn(const StrandView& view, const RoundStrand& strand)
{
    const StrandBlock block = blockOf(strand);
    const SpanSegments segments = segmentsFor(view, block);
    StrandPoints points;
    drawnPoints(view, block, segments, points);
    std::vector<glm::vec2> line;
    line.reserve(static_cast<std::size_t>(segments.total) + 1);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(segments.total); ++i)
        line.emplace_back(points.x[i * kBlockLanes], points.y[i * kBlockLanes]);
    return line;
}

float distanceTo(glm::vec2 p, glm::vec2 a, glm::vec2 b)
{
    const glm::vec2 along = b - a;
    const float t = std::clamp(glm::dot(p - a, along) / std::max(glm::dot(along, along), 1e-12F), 0.0F, 1.0F);
    return glm::distance(p, a + along * t);
}

} // namespace

class TestCurveRoundness : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void noCornerIsSeen_data()
    {
        QTest::addColumn<RoundStrand>("strand");
        QTest::addColumn<float>("distanceM");
        const std::array strands{
            std::pair{"bent", RoundStrand{.bendRad = 2.5F}},
            std::pair{"wavy", RoundStrand{.turns = 2.0F, .curlRadiusM = 0.006F}},
            std::pair{"ringlet", RoundStrand{.turns = 8.0F, .curlRadiusM = 0.006F}},
            std::pair{"bent coil", RoundStrand{.bendRad = 1.5F, .turns = 16.0F, .curlRadiusM = 0.003F}},
            std::pair{"frizzy", RoundStrand{.frizzM = 0.004F}},
            std::pair{"frizzy wave", RoundStrand{.turns = 2.0F, .curlRadiusM = 0.006F, .frizzM = 0.002F}},
            std::pair{"plait", RoundStrand{.braid = sim::BraidKind::Plait}},
            std::pair{"twist", RoundStrand{.braid = sim::BraidKind::Twist}}};
        for (const auto& [name, strand] : strands)
            for (const float distance : {2.5F, 0.75F, 0.3F, 0.1F, 0.04F})
                QTest::addRow("%s at %g m", name, double{distance}) << strand << distance;
    }

    void lanesCoilAsOneStrandDoes()
    {
        constexpr int kOfSpan = 24;
        const sim::CurlSettings coils{
            .flatness = 0.3F, .inStepFromM = 0.06F, .switchbacksPerM = 25.0F, .skips = 0.25F, .uncoil = 0.25F};
        StrandBlock block = blockOf({.bendRad = 1.2F, .turns = 7.0F, .curlRadiusM = 0.008F});
        block.coils = &coils;
        std::array<sim::StrandStyle, kBlockLanes> styles;
        for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
            sim::StrandStyle& style = styles.at(lane);
            const auto number = static_cast<float>(lane);
            style.lengthM = block.lengthM[lane] = 0.2F;
            style.turns = block.turns[lane] = 5.0F + 0.4F * number;
            style.curlRadiusM = block.curlRadiusM[lane] = 0.004F + 0.0003F * number;
            style.phase = block.phase[lane] = 0.39F * number;
            style.variation = block.variation[lane] = 0.11F * number - 0.9F;
            block.width[lane] = 1.0F;
            block.tangentWo.at(lane) = 1.0F;
        }
        SpanSegments segments;
        std::fill_n(segments.of.begin(), kNodes - 1, kOfSpan);
        segments.total = kOfSpan * (kNodes - 1);
        StrandPoints points;
        drawnPoints(viewFrom(0.5F, kToleranceSp), block, segments, points);
        std::vector<glm::vec3> skeleton;
        for (std::size_t n = 0; n < kNodes; ++n)
            skeleton.emplace_back(block.nodesWo[n * 3 * kBlockLanes], block.nodesWo[(n * 3 + 1) * kBlockLanes],
                                  block.nodesWo[(n * 3 + 2) * kBlockLanes]);
        std::vector<glm::vec3> expected;
        for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
            sim::evaluateStrand(skeleton, {1.0F, 0.0F, 0.0F}, styles.at(lane), segments.total, expected, &coils);
            for (std::size_t j = 0; j < expected.size(); ++j) {
                const float* at = points.pointsWo.data() + j * 3 * kBlockLanes + lane;
                QVERIFY(glm::distance(expected[j], glm::vec3(at[0], at[kBlockLanes], at[2 * kBlockLanes])) < 2e-5F);
            }
        }
    }

    /// The line drawn is nowhere further from the curve than half a sample.
    void noCornerIsSeen()
    {
        QFETCH(RoundStrand, strand);
        QFETCH(float, distanceM);
        const std::vector<glm::vec2> line = drawn(viewFrom(distanceM, kToleranceSp), strand);
        const std::vector<glm::vec2> curve = drawn(viewFrom(distanceM, kToleranceSp / 8.0F), strand);
        QVERIFY(curve.size() > line.size());
        const auto inPicture = [](glm::vec2 p) { return p.x > 0.0F && p.x < 2000.0F && p.y > 0.0F && p.y < 2000.0F; };
        constexpr std::size_t kAround = 3;
        float worst = 0.0F;
        std::size_t at = 0; // Both run in the same direction: the segment nearest by number is the one.
        for (std::size_t i = 0; i < curve.size(); ++i) {
            if (!inPicture(curve[i]))
                continue;
            const std::size_t guess = i * (line.size() - 1) / (curve.size() - 1);
            const std::size_t first = guess > 2 * kAround ? guess - 2 * kAround : 0;
            const std::size_t last = std::min(guess + 2 * kAround, line.size() - 2);
            float nearest = std::numeric_limits<float>::max();
            for (std::size_t s = first; s <= last; ++s)
                nearest = std::min(nearest, distanceTo(curve[i], line[s], line[s + 1]));
            if (nearest > worst) {
                worst = nearest;
                at = i;
            }
        }
        QVERIFY2(worst < kSeenSp,
                 qPrintable(QStringLiteral("%1 samples, point %2 of %3").arg(worst).arg(at).arg(curve.size())));
    }
};

HAIRPAINT_TEST(TestCurveRoundness, None)
#include "test_curve_roundness.moc"
