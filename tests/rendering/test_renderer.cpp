// The renderer draws what the scene says, off-screen.
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/allocation_limit.h"
#include "tests/support/test_program.h"
#include "view/rendering/gl/gl_objects.h"
#include "view/rendering/gl/packed_style.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <new>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::Quality;
using rendering::Scene;

namespace {

/// Sum over the pixels, about linear; a white pixel is 1.
double lightIn(const Picture& picture)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < picture.pixels.size(); i += 4)
        sum += std::pow(picture.pixels[i] / 255.0, 2.2);
    return sum;
}

} // namespace

class TestRenderer : public RendererFixture
{
    Q_OBJECT

private Q_SLOTS:
    void plainBackgroundHasTheColourAskedFor_data();
    void plainBackgroundHasTheColourAskedFor();
    void headCoversTheMiddleAndNotTheCorners();
    void strandsShowTheirColourWhereTheyAre_data();
    void strandsShowTheirColourWhereTheyAre();
    void fewerHairsCoverAsMuch_data();
    void fewerHairsCoverAsMuch();
    void hairThinsOutToTheTip();
    void hairBehindTheHeadIsHidden();
    void onlyChangedChunksAreSent();
    void aHiddenGroupKeepsNoFrame();
    void aBufferThatFindsNoMemoryIsTriedAgain();
    void wantOfMemoryLeavesNothingOutOfTheNextFrame_data();
    void wantOfMemoryLeavesNothingOutOfTheNextFrame();
    void aFrameEndsWhereItIsInterrupted();
    void theSameSceneGivesTheSamePixels_data();
    void theSameSceneGivesTheSamePixels();
    void ringShowsOnTheSkinAndHairInsideFades();
    void hairShadesTheSkin();
    void hairThrowsNoShadeBesideItself_data();
    void hairThrowsNoShadeBesideItself();
    void aPlaitsShadeEndsWhereThePlaitDoes();
    void emptyAndHiddenHairDrawsNothing();
};

void TestRenderer::plainBackgroundHasTheColourAskedFor_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<float>("linear");
    QTest::addColumn<int>("srgb");
    QTest::newRow("dark theme, 1 sample") << 1 << 0.010330F << 27;
    QTest::newRow("dark theme, 4 samples") << 4 << 0.010330F << 27;
    QTest::newRow("light theme, 2 samples") << 2 << 0.791298F << 230;
    QTest::newRow("black") << 4 << 0.0F << 0;
}

void TestRenderer::plainBackgroundHasTheColourAskedFor()
{
    QFETCH(int, samples);
    QFETCH(float, linear);
    QFETCH(int, srgb);
    Scene scene = emptyScene();
    scene.background = glm::vec3(linear);
    const Picture picture = draw(scene, {.samples = samples});
    for (int x : {0, 99, 199})
        for (int channel = 0; channel < 3; ++channel)
            QVERIFY(std::abs(picture.at(x, 75)[channel] - srgb) <= 1);
    QVERIFY(picture.at(0, 0).x >= picture.at(0, 149).x);
}

void TestRenderer::headCoversTheMiddleAndNotTheCorners()
{
    Scene scene = emptyScene();
    const Picture without = draw(scene);
    scene.head = makeBall(kBall);
    const Picture with = draw(scene);
    QVERIFY(with.at(100, 75).x > without.at(100, 75).x + 40);
    for (const glm::ivec2 corner : {glm::ivec2(0, 0), glm::ivec2(199, 0), glm::ivec2(0, 149), glm::ivec2(199, 149)})
        QCOMPARE(with.at(corner.x, corner.y), without.at(corner.x, corner.y));
}

void TestRenderer::strandsShowTheirColourWhereTheyAre_data()
{
    QTest::addColumn<std::uint32_t>("colour");
    QTest::addColumn<int>("strongest");
    QTest::newRow("red") << 0xFF2020C0U << 0;
    QTest::newRow("green") << 0xFF20C020U << 1;
    QTest::newRow("blue") << 0xFFC02020U << 2;
}

void TestRenderer::strandsShowTheirColourWhereTheyAre()
{
    QFETCH(std::uint32_t, colour);
    QFETCH(int, strongest);
    Scene scene = emptyScene();
    const Picture without = draw(scene);
    scene.hair = makeFrame(comb(colour, 120, 0.05F, 2.5e-3F), plainSettings());
    const Picture with = draw(scene);
    // The comb is 0.1 by 0.2 m in the middle; a pixel is about 2.7 mm.
    for (int y = 45; y < 105; y += 5)
        for (int x = 86; x < 114; ++x) {
            const glm::ivec3 pixel = with.at(x, y);
            for (int channel = 0; channel < 3; ++channel)
                if (channel != strongest)
                    QVERIFY2(
                        pixel[strongest] > pixel[channel] + 30,
                        qPrintable(
                            QStringLiteral("%1 %2: %3 %4 %5").arg(x).arg(y).arg(pixel.x).arg(pixel.y).arg(pixel.z)));
        }
    QCOMPARE(with.difference(without, 0, 0, 78, 150), 0.0);
    QCOMPARE(with.difference(without, 122, 0, 200, 150), 0.0);
    QCOMPARE(with.difference(without, 0, 0, 200, 30), 0.0);
    QCOMPARE(with.difference(without, 0, 120, 200, 150), 0.0);
}

void TestRenderer::fewerHairsCoverAsMuch_data()
{
    QTest::addColumn<float>("detail");
    QTest::addColumn<int>("samples");
    QTest::newRow("half, 4 samples") << 0.5F << 4;
    QTest::newRow("quarter, 4 samples") << 0.25F << 4;
    QTest::newRow("quarter, 1 sample") << 0.25F << 1;
    QTest::newRow("tenth, 4 samples") << 0.1F << 4;
}

void TestRenderer::fewerHairsCoverAsMuch()
{
    QFETCH(float, detail);
    QFETCH(int, samples);
    Scene scene = emptyScene();
    scene.background = glm::vec3(0.0F);
    // Thin enough that strands rarely lie over each other.
    scene.hair = makeFrame(comb(0xFFFFFFFFU, 160, 0.12F, 150e-6F), plainSettings());
    const double all = lightIn(draw(scene, {.samples = samples}, 400, 300));
    const double fewer = lightIn(draw(scene, {.detail = detail, .samples = samples}, 400, 300));
    QVERIFY(all > 100.0);
    QVERIFY2(std::abs(fewer / all - 1.0) < 0.05, qPrintable(QString::number(fewer / all)));
    QVERIFY(m_renderer->statistics().drawnHairs > 0);
}

void TestRenderer::hairThinsOutToTheTip()
{
    Scene scene = emptyScene();
    scene.background = glm::vec3(0.0F);
    const Picture without = draw(scene);
    sim::GroupSettings settings = plainSettings();
    settings.material.tipAlpha = 0.1F;
    scene.hair = makeFrame(comb(0xFFFFFFFFU, 120, 0.12F, 1e-3F), settings);
    const Picture with = draw(scene);
    const double root = with.difference(without, 60, 42, 140, 52);
    const double middle = with.difference(without, 60, 70, 140, 80);
    const double tip = with.difference(without, 60, 98, 140, 108);
    QVERIFY2(root > middle * 1.05 && middle > tip * 1.5,
             qPrintable(QStringLiteral("%1 %2 %3").arg(root).arg(middle).arg(tip)));
}

void TestRenderer::hairBehindTheHeadIsHidden()
{
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    const Picture without = draw(scene);
    std::vector<HandMadeStrand> strands = comb(0xFF20C020U, 50, 0.03F);
    for (HandMadeStrand& strand : strands)
        for (glm::vec3& node : strand.nodesWo)
            node = glm::vec3(node.x, node.y * 0.5F, -0.15F);
    scene.hair = makeFrame(strands, plainSettings());
    const Picture behind = draw(scene);
    QVERIFY(behind.at(100, 75).y <= without.at(100, 75).y); // Never lighter; shade may fall.
    for (HandMadeStrand& strand : strands)
        for (glm::vec3& node : strand.nodesWo)
            node.z = 0.15F;
    scene.hair = makeFrame(strands, plainSettings());
    const Picture before = draw(scene);
    QVERIFY(before.at(100, 75).y > before.at(100, 75).x + 30);
}

void TestRenderer::onlyChangedChunksAreSent()
{
    constexpr int kWidth = 60; // What is sent is the same for a picture of any size.
    constexpr int kHeight = 45;
    Scene scene = emptyScene();
    auto frame = makeFrame(comb(0xFF808080U, 5000), plainSettings(), 77);
    scene.hair = frame;
    draw(scene, {}, kWidth, kHeight);
    const std::size_t all = m_renderer->statistics().uploadedBytes;
    QVERIFY(all > 5 * sim::kChunkSlots * sizeof(rendering::PackedStyle));
    draw(scene, {}, kWidth, kHeight);
    QCOMPARE(m_renderer->statistics().uploadedBytes, std::size_t{0});

    // Another frame of the same hair at rest: nothing.
    scene.hair = std::make_shared<sim::StrandFrame>(*frame);
    draw(scene, {}, kWidth, kHeight);
    QCOMPARE(m_renderer->statistics().uploadedBytes, std::size_t{0});
    // One hair moved: its block of the skeletons only. All of it moved: all of them.
    auto moved = std::make_shared<sim::StrandFrame>(*frame);
    moved->groups[0].positions[5] += 0.001F;
    scene.hair = moved;
    draw(scene, {}, kWidth, kHeight);
    QCOMPARE(m_renderer->statistics().uploadedBytes, std::size_t{16384});
    auto everything = std::make_shared<sim::StrandFrame>(*frame);
    for (float& coordinate : everything->groups[0].positions)
        coordinate += 0.001F;
    scene.hair = everything;
    draw(scene, {}, kWidth, kHeight);
    QCOMPARE(m_renderer->statistics().uploadedBytes, frame->groups[0].positions.size() * sizeof(float));
    scene.hair = frame;
    draw(scene, {}, kWidth, kHeight);

    // One chunk has another colour: its styles; neither the list nor the positions.
    auto groom = std::make_shared<sim::Groom>(*frame->groups[0].groom);
    auto chunk = std::make_shared<sim::StrandChunk>(*groom->chunks[1]);
    chunk->styles[3].rootColour = 0xFF0000FFU;
    groom->chunks[1] = chunk;
    auto painted = std::make_shared<sim::StrandFrame>(*frame);
    painted->groups[0].groom = groom;
    scene.hair = painted;
    draw(scene, {}, kWidth, kHeight);
    QCOMPARE(m_renderer->statistics().uploadedBytes, sim::kChunkSlots * sizeof(rendering::PackedStyle));
}

void TestRenderer::aHiddenGroupKeepsNoFrame()
{
    Scene scene = emptyScene();
    auto frame = makeFrame(comb(0xFF808080U, 100), plainSettings());
    scene.hair = frame;
    const Picture shown = draw(scene);
    auto groom = std::make_shared<sim::Groom>(*frame->groups[0].groom);
    groom->visible = false;
    auto hidden = std::make_shared<sim::StrandFrame>();
    hidden->groups.push_back({.groom = groom, .positions = {}});
    const std::weak_ptr<sim::StrandFrame> kept = frame;
    frame.reset();
    scene.hair = hidden;
    draw(scene);
    QVERIFY(kept.expired());
    scene.hair = makeFrame(comb(0xFF808080U, 100), plainSettings());
    QCOMPARE(draw(scene).pixels == shown.pixels, true);
}

void TestRenderer::aBufferThatFindsNoMemoryIsTriedAgain()
{
    rendering::Buffer buffer;
    buffer.reserve(std::size_t{1} << 50U);
    QVERIFY(!m_gl->takeErrors().empty());
    QCOMPARE(buffer.capacity(), std::size_t{0});
    const std::array<int, 4> sent{1, 2, 3, 4};
    buffer.assign(sent.data(), sizeof(sent));
    std::array<int, 4> got{};
    buffer.read(got.data(), sizeof(got));
    QVERIFY(got == sent);
}

void TestRenderer::wantOfMemoryLeavesNothingOutOfTheNextFrame_data()
{
    QTest::addColumn<int>("leastRefused");
    for (int bits = 10; bits <= 17; ++bits)
        QTest::addRow("from %d bytes on", 1 << bits) << (1 << bits);
}

void TestRenderer::wantOfMemoryLeavesNothingOutOfTheNextFrame()
{
    QFETCH(int, leastRefused);
    Scene scene = emptyScene();
    scene.hair = makeFrame(comb(0xFF2020C0U, 9000, 0.08F), plainSettings());
    Scene other = emptyScene();
    other.hair = makeFrame(comb(0xFF20C020U, 3000), plainSettings());
    auto fresh = rendering::GlRenderer::create();
    QVERIFY(fresh.has_value());
    const Picture expected = draw(scene);
    static_cast<void>(drawn(**fresh, other));
    bool refused = false;
    try {
        const test::AllocationLimit limit(static_cast<std::size_t>(leastRefused));
        (*fresh)->draw(scene, {}, 200, 150);
    } catch (const std::bad_alloc&) {
        refused = true;
    }
    QVERIFY(refused);
    QCOMPARE(drawn(**fresh, scene).pixels == expected.pixels, true);
}

void TestRenderer::aFrameEndsWhereItIsInterrupted()
{
    Scene scene = emptyScene();
    scene.hair = makeFrame(comb(0xFF808080U, 9000), plainSettings()); // Several pieces.
    const Picture whole = draw(scene);
    int asked = 0;
    const auto atOnce = [&asked](double) { return ++asked < 1; };
    QVERIFY(!m_renderer->drawPatiently(scene, {}, 200, 150, atOnce));
    QCOMPARE(asked, 1);
    const auto never = [&asked](double) { return ++asked > 0; };
    QVERIFY(m_renderer->drawPatiently(scene, {}, 200, 150, never));
    QVERIFY(asked >= 3);
    QCOMPARE(m_renderer->statistics().drawnHairs, std::size_t{9000});
    QCOMPARE(draw(scene).pixels == whole.pixels, true);
}

void TestRenderer::theSameSceneGivesTheSamePixels_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<float>("detail");
    QTest::newRow("still") << 4 << 1.0F;
    QTest::newRow("moving") << 1 << 0.3F;
    QTest::newRow("between") << 2 << 0.6F;
}

void TestRenderer::theSameSceneGivesTheSamePixels()
{
    QFETCH(int, samples);
    QFETCH(float, detail);
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    scene.hair = makeFrame(hairOnBall(kBall, {.hairs = 3000, .lengthM = 0.15F, .turns = 4.0F, .curlRadiusM = 0.004F}));
    const Quality quality{.detail = detail, .samples = samples};
    const Picture first = draw(scene, quality);
    draw(emptyScene(), {.samples = 4}, 64, 64);
    const Picture second = draw(scene, quality);
    QCOMPARE(first.pixels == second.pixels, true);
    auto other = rendering::GlRenderer::create();
    QVERIFY(other.has_value());
    QCOMPARE(drawn(**other, scene, quality).pixels == first.pixels, true);
}

void TestRenderer::ringShowsOnTheSkinAndHairInsideFades()
{
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    const Picture without = draw(scene, {}, 400, 300);
    scene.ring = rendering::Ring{.centreHd = {0.0F, 0.0F, 0.1F}, .normalHd = {0.0F, 0.0F, 1.0F}, .radiusM = 0.02F};
    const Picture with = draw(scene, {}, 400, 300);
    // White in a circle round the middle: as many pixels as its radius says.
    const float metresPerPixel = 2.0F * 0.65F * std::tan(0.26F) / 300.0F;
    const float radius = 0.02F / metresPerPixel;
    int white = 0;
    for (int degree = 0; degree < 360; degree += 10) {
        const float angle = glm::radians(static_cast<float>(degree));
        bool found = false;
        for (int step = -5; step < 5; ++step) {
            const float r = radius + 0.5F * static_cast<float>(step);
            const glm::ivec3 pixel =
                with.at(static_cast<int>(200.0F + r * std::cos(angle)), static_cast<int>(150.0F - r * std::sin(angle)));
            found = found || pixel.x > 200;
        }
        white += found ? 1 : 0;
    }
    QCOMPARE(white, 36);
    QCOMPARE(with.difference(without, 0, 0, 150, 300), 0.0);

    std::vector<HandMadeStrand> strands = comb(0xFF20C020U, 400, 0.06F);
    for (HandMadeStrand& strand : strands)
        for (glm::vec3& node : strand.nodesWo)
            node.z = 0.13F;
    scene.hair = makeFrame(strands, plainSettings());
    const Picture faded = draw(scene, {}, 400, 300);
    scene.ring.reset();
    const Picture covered = draw(scene, {}, 400, 300);
    const auto greenness = [](glm::ivec3 p) { return p.y - p.x; };
    QVERIFY(greenness(covered.at(200, 150)) > 30);
    QVERIFY(greenness(faded.at(200, 150)) < greenness(covered.at(200, 150)) * 2 / 3);
    QCOMPARE(faded.at(160, 150), covered.at(160, 150));
}

void TestRenderer::hairShadesTheSkin()
{
    Scene scene = emptyScene();
    scene.light.directionWo = glm::vec3(0.0F, 1.0F, 0.3F);
    scene.head = makeBall(kBall);
    const Picture without = draw(scene);
    std::vector<HandMadeStrand> strands = comb(0xFF202020U, 2000, 0.08F);
    for (HandMadeStrand& strand : strands) // A roof over the ball.
        for (std::size_t n = 0; n < strand.nodesWo.size(); ++n)
            strand.nodesWo[n] = glm::vec3(strand.nodesWo[n].x, 0.13F, 0.15F - 0.03F * static_cast<float>(n));
    scene.hair = makeFrame(strands, plainSettings());
    const Picture with = draw(scene);
    QVERIFY2(with.at(100, 60).x < without.at(100, 60).x - 10,
             qPrintable(QStringLiteral("%1 %2").arg(with.at(100, 60).x).arg(without.at(100, 60).x)));
}

void TestRenderer::hairThrowsNoShadeBesideItself_data()
{
    QTest::addColumn<float>("endY");
    for (const float end : {0.0F, -0.004F, -0.008F, -0.012F, -0.016F})
        QTest::addRow("ends at %g m", static_cast<double>(end)) << end;
}

void TestRenderer::hairThrowsNoShadeBesideItself()
{
    QFETCH(float, endY);
    Scene scene = emptyScene();
    scene.light.directionWo = glm::vec3(0.0F, 0.0F, 1.0F);
    scene.head = makeBall(kBall);
    const Picture without = draw(scene);
    std::vector<HandMadeStrand> strands = comb(0xFF202020U, 2000, 0.02F);
    for (HandMadeStrand& strand : strands) // A long curtain before the ball's upper half.
        for (std::size_t n = 0; n < strand.nodesWo.size(); ++n)
            strand.nodesWo[n] =
                glm::vec3(strand.nodesWo[n].x, glm::mix(0.5F, endY, static_cast<float>(n) / 7.0F), 0.13F);
    scene.hair = makeFrame(strands, plainSettings());
    const Picture with = draw(scene);
    QVERIFY(without.difference(with, 80, 50, 120, 70) > 5.0);
    QCOMPARE(without.difference(with, 60, 96, 140, 120), 0.0);
}

void TestRenderer::aPlaitsShadeEndsWhereThePlaitDoes()
{
    Scene scene = emptyScene();
    scene.light.directionWo = glm::vec3(0.0F, 0.0F, 1.0F);
    scene.head = makeBall(kBall);
    const Picture without = draw(scene, {}, 400, 300);
    // A long rope before the ball's upper half, so full of hair that a small part of it lets no light through.
    std::vector<HandMadeStrand> strands = comb(0xFF202020U, 20'000, 0.008F);
    for (HandMadeStrand& strand : strands)
        for (std::size_t n = 0; n < strand.nodesWo.size(); ++n)
            strand.nodesWo[n] =
                glm::vec3(strand.nodesWo[n].x, glm::mix(1.0F, 0.0F, static_cast<float>(n) / 7.0F), 0.13F);
    scene.hair = makeFrame(strands, plainSettings());
    const Picture with = draw(scene, {}, 400, 300);
    // Below its end the skin becomes light evenly, over one voxel of the shade.
    std::vector<double> light;
    for (int y = 150; y < 300 && (light.empty() || light.back() < 0.99); ++y)
        light.push_back(static_cast<double>(with.at(200, y).x) / static_cast<double>(without.at(200, y).x));
    QVERIFY(light.size() > 10 && light.back() >= 0.99);
    const double middle = light[light.size() / 2];
    QVERIFY2(middle > 0.45, qPrintable(QString::number(middle)));
}

void TestRenderer::emptyAndHiddenHairDrawsNothing()
{
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    const Picture without = draw(scene);
    scene.hair = std::make_shared<sim::StrandFrame>();
    QCOMPARE(draw(scene).pixels == without.pixels, true);
    scene.hair = makeFrame({});
    QCOMPARE(draw(scene).pixels == without.pixels, true);

    auto frame = makeFrame(comb(0xFF20C020U, 100), plainSettings());
    scene.hair = frame;
    QCOMPARE(draw(scene).pixels == without.pixels, false);
    QCOMPARE(m_renderer->statistics().drawnHairs, std::size_t{100});
    auto groom = std::make_shared<sim::Groom>(*frame->groups[0].groom);
    groom->visible = false;
    auto hidden = std::make_shared<sim::StrandFrame>(*frame);
    hidden->groups[0].groom = groom;
    scene.hair = hidden;
    QCOMPARE(draw(scene).pixels == without.pixels, true);
    QCOMPARE(m_renderer->statistics().drawnHairs, std::size_t{0});
    scene.hair = frame;
    QCOMPARE(draw(scene).pixels == without.pixels, false);
}

HAIRPAINT_TEST(TestRenderer, None)
#include "test_renderer.moc"
