// The points that the compute shader walks are those of sim::evaluateStrand.
#include "sim/groom/strand_curve.h"
#include "tests/rendering/gl_test.h"
#include "tests/rendering/hand_made_hair.h"
#include "tests/support/test_program.h"
#include "view/rendering/gl/hair_pass.h"

#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::testing;

class TestStrandCurveOnGpu : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void pointsAreThoseOfTheCpu_data();
    void pointsAreThoseOfTheCpu();

private:
    static constexpr int kCoiled = -1; ///< In the column of braids.
    std::unique_ptr<GlTest> m_gl;
};

void TestStrandCurveOnGpu::initTestCase()
{
    m_gl = std::make_unique<GlTest>();
    QVERIFY2(m_gl->failure().empty(), m_gl->failure().c_str());
}

void TestStrandCurveOnGpu::pointsAreThoseOfTheCpu_data()
{
    QTest::addColumn<int>("nodes");
    QTest::addColumn<float>("turns");
    QTest::addColumn<float>("curlRadiusM");
    QTest::addColumn<int>("braid"); ///< Kind, wisp in bits 8 and 9.
    QTest::addColumn<bool>("turned");
    QTest::addColumn<float>("frizzM");
    QTest::newRow("straight") << 8 << 0.0F << 0.0F << 0 << false << 0.0F;
    QTest::newRow("four nodes") << 4 << 2.0F << 0.01F << 0 << false << 0.0F;
    QTest::newRow("two turns") << 8 << 2.0F << 0.012F << 0 << false << 0.0F;
    QTest::newRow("sixteen turns") << 8 << 16.0F << 0.006F << 0 << false << 0.0F;
    QTest::newRow("head turned") << 12 << 5.0F << 0.01F << 0 << true << 0.0F;
    QTest::newRow("plait, first wisp") << 12 << 0.0F << 0.0F << 0x001 << false << 0.0F;
    QTest::newRow("plait, second wisp") << 12 << 0.0F << 0.0F << 0x101 << false << 0.0F;
    QTest::newRow("plait, third wisp, head turned") << 32 << 0.0F << 0.0F << 0x201 << true << 0.0F;
    QTest::newRow("twist, first wisp") << 12 << 0.0F << 0.0F << 0x002 << false << 0.0F;
    QTest::newRow("twist, second wisp, head turned") << 12 << 0.0F << 0.0F << 0x102 << true << 0.0F;
    QTest::newRow("loc") << 12 << 0.0F << 0.0F << 0x003 << false << 0.0F;
    QTest::newRow("rope of a bun") << 12 << 0.0F << 0.0F << 0x008 << false << 0.0F;
    QTest::newRow("rope of a bun, head turned") << 8 << 0.0F << 0.0F << 0x008 << true << 0.0F;
    QTest::newRow("frizzy") << 8 << 0.0F << 0.0F << 0 << false << 0.006F;
    QTest::newRow("frizzy curl, head turned") << 12 << 5.0F << 0.01F << 0 << true << 0.004F;
    QTest::newRow("frizzy plait") << 12 << 0.0F << 0.0F << 0x101 << false << 0.003F;
    // Measured in real units.
    QTest::newRow("coil") << 12 << 9.0F << 0.009F << kCoiled << false << 0.0F;
    QTest::newRow("coil, head turned") << 8 << 6.4F << 0.0075F << kCoiled << true << 0.0F;
}

void TestStrandCurveOnGpu::pointsAreThoseOfTheCpu()
{
    QFETCH(int, nodes);
    QFETCH(float, turns);
    QFETCH(float, curlRadiusM);
    QFETCH(int, braid);
    QFETCH(bool, turned);
    QFETCH(float, frizzM);

    // Bent skeletons from all over a ball.
    const glm::vec3 axes(0.08F, 0.11F, 0.1F);
    std::vector<HandMadeStrand> strands =
        hairOnBall(axes, {.hairs = 200, .lengthM = 0.25F, .turns = turns, .curlRadiusM = curlRadiusM, .nodes = nodes});
    float chance = -1.0F;
    for (HandMadeStrand& strand : strands) {
        if (braid == kCoiled)
            continue;
        strand.style.braid = static_cast<sim::BraidKind>(braid & 0xFF);
        strand.style.wisp = static_cast<std::uint8_t>(braid >> 8);
        strand.style.braidRadiusM = 0.014F;
        strand.style.braidStart = 0.27F;
        strand.style.braidTurns = 4.3F;
        strand.style.wispOffset = {0.4F, -0.7F};
        strand.style.frizzM = frizzM;
        strand.style.variation = chance += 0.009F;
    }
    sim::GroupSettings settings;
    if (braid == kCoiled) {
        settings.turnsMode = sim::TurnsMode::Coils;
        settings.curl = {.flatness = 0.3F,
                         .inStepFromM = 0.05F,
                         .switchbacksPerM = 12.0F,
                         .skips = 0.2F,
                         .uncoil = 0.25F,
                         .straightM = 0.006F};
    }
    auto frame = makeFrame(strands, settings);
    if (turned)
        frame->pose.rotation = glm::angleAxis(0.7F, glm::normalize(glm::vec3(1.0F, 2.0F, 0.5F)));
    rendering::Scene scene;
    scene.hair = frame;
    const rendering::FrameConstants constants = rendering::frameConstants(scene, {.width = 64, .height = 64}, 0.0F);

    auto pass = rendering::HairPass::create();
    QVERIFY2(pass.has_value(), pass.has_value() ? "" : pass.error().c_str());
    rendering::Buffer uniforms;
    uniforms.assign(&constants, sizeof(constants));
    uniforms.bindUniform(0);
    const rendering::HairPass::Report report = (*pass)->upload(frame, constants, 1.0F, true);
    (*pass)->begin(constants, rendering::HairList::kBatchPoints);
    QVERIFY((*pass)->projectPiece() && !(*pass)->projectPiece());
    QCOMPARE(report.hairs, strands.size());
    std::vector<glm::vec4> points(report.segments + report.hairs);
    (*pass)->points().read(points.data(), points.size() * sizeof(glm::vec4));

    const rendering::HairList& list = (*pass)->group(frame->groups[0].groom->groupId).list();
    float worst = 0.0F;
    std::vector<glm::vec3> expected;
    for (std::size_t i = 0; i < list.strandCount(); ++i) {
        const auto [slot, first] = list.strands()[i];
        const int segments = static_cast<int>(list.strands()[i + 1].firstPoint - first) - 1;
        const glm::vec3 tangent = frame->pose.rotation * sim::frameTangentHd(*frame->groups[0].groom, slot);
        const sim::StrandStyle& style = frame->groups[0].groom->chunks[0]->styles[slot];
        sim::evaluateStrand(strands[slot].nodesWo, tangent, style, segments, expected, sim::coilsOf(settings));
        for (std::size_t p = 0; p < expected.size(); ++p)
            worst = std::max(worst, glm::distance(expected[p], glm::vec3(points[first + p])));
    }
    QVERIFY2(worst < 1e-4F, qPrintable(QString::number(static_cast<double>(worst))));
    const std::string errors = m_gl->takeErrors();
    QVERIFY2(errors.empty(), errors.c_str());
}

HAIRPAINT_TEST(TestStrandCurveOnGpu, None)
#include "test_strand_curve_on_gpu.moc"
