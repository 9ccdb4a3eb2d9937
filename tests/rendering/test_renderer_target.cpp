// The renderer's picture has any size, is copied to the caller's framebuffer, and leaves the caller's state alone.
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <epoxy/gl.h>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::Quality;
using rendering::Scene;

class TestRendererTarget : public RendererFixture
{
    Q_OBJECT

private Q_SLOTS:
    void anySizeIsDrawn_data();
    void anySizeIsDrawn();
    void largePicturesShowWhatSmallOnesDo_data();
    void largePicturesShowWhatSmallOnesDo();
    void headIsCoarseInTheFirstFrameOfAViewOnly();
    void oneSampleMakesNoStairs_data();
    void oneSampleMakesNoStairs();
    void complaintsAboutOthersAreNotItsOwn();
    void pictureIsCopiedToTheCallersFramebufferAndStateIsKept();
};

void TestRendererTarget::anySizeIsDrawn_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::newRow("a pixel") << 1 << 1;
    QTest::newRow("wide") << 701 << 3;
    QTest::newRow("tall") << 5 << 400;
    QTest::newRow("odd") << 333 << 217;
}

void TestRendererTarget::anySizeIsDrawn()
{
    QFETCH(int, width);
    QFETCH(int, height);
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    scene.hair = makeFrame(comb(0xFF20C020U, 300), plainSettings());
    for (const int samples : {1, 2, 4}) {
        const Picture picture = draw(scene, {.samples = samples}, width, height);
        QCOMPARE(picture.pixels.size(), static_cast<std::size_t>(width * height * 4));
    }
    // Inside the hair, and with hair behind the eye.
    scene.camera.distanceM = 0.03F;
    draw(scene, {}, width, height);
}

void TestRendererTarget::largePicturesShowWhatSmallOnesDo_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::newRow("a large window") << 1600 << 1200;
    QTest::newRow("a screen of 4K") << 3840 << 2160;
}

void TestRendererTarget::largePicturesShowWhatSmallOnesDo()
{
    QFETCH(int, width);
    QFETCH(int, height);
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    const int smallWidth = 150 * width / height;
    const Picture small = draw(scene, {.samples = 4}, smallWidth, 150);
    const Picture large = draw(scene, {.samples = 4}, width, height);
    for (const glm::ivec2 at : {glm::ivec2(5, 5), glm::ivec2(smallWidth / 2, 75), glm::ivec2(smallWidth - 5, 145)}) {
        const glm::ivec3 wanted = small.at(at.x, at.y);
        const glm::ivec3 got = large.at(at.x * width / smallWidth, at.y * height / 150);
        for (int channel = 0; channel < 3; ++channel)
            QVERIFY(std::abs(got[channel] - wanted[channel]) <= 6);
    }
}

void TestRendererTarget::headIsCoarseInTheFirstFrameOfAViewOnly()
{
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    const Picture fine = draw(scene, {}, 200, 150);
    scene.camera.azimuthRad = 1.0F;
    const Picture fineTurned = draw(scene, {}, 200, 150);
    scene.camera.azimuthRad = 0.0F;
    scene.headInMotion = makeBall(kBall, 4);
    const Quality moving{.coarseHead = true};
    QVERIFY(draw(scene, moving, 200, 150).difference(fine) > 0.5);
    QCOMPARE(draw(scene, moving, 200, 150).difference(fine), 0.0);
    QCOMPARE(draw(scene, moving, 200, 150).difference(fine), 0.0);
    scene.camera.azimuthRad = 1.0F;
    QVERIFY(draw(scene, moving, 200, 150).difference(fineTurned) > 0.5);
    // A picture that has to be right is.
    QCOMPARE(draw(scene, {}, 200, 150).difference(fineTurned), 0.0);
    scene.camera.azimuthRad = 0.0F;
    QCOMPARE(draw(scene, {}, 200, 150).difference(fine), 0.0);
}

void TestRendererTarget::oneSampleMakesNoStairs_data()
{
    QTest::addColumn<float>("slant");
    QTest::newRow("a little from upright") << 0.15F;
    QTest::newRow("slanted") << 0.4F;
    QTest::newRow("nearly level") << 6.0F;
}

void TestRendererTarget::oneSampleMakesNoStairs()
{
    QFETCH(float, slant);
    Scene scene = emptyScene();
    const glm::vec3 half = 0.09F * glm::normalize(glm::vec3(slant, 1.0F, 0.0F));
    sim::GroupSettings settings = plainSettings();
    settings.material.widthM = 2e-3F; // Nearly a pixel.
    scene.hair = makeFrame({straightStrand(-half, half, 0xFFFFFFFFU)}, settings);
    const Picture picture = draw(scene, {.samples = 1});
    const Picture background = draw(emptyScene(), {.samples = 1});
    const auto linear = [](int srgb) { return std::pow(srgb / 255.0, 2.2); };
    // Where the strand's light has its centre on each row, or on each column where it is more level than upright. A
    // strand of whole pixels is up to half of one beside its line, 0.29 in the mean.
    const bool level = slant > 1.0F;
    double squares = 0.0;
    int rows = 0;
    for (int along = -25; along <= 25; ++along) {
        double light = 0.0;
        double moment = 0.0;
        for (int across = -60; across <= 60; ++across) {
            const glm::ivec2 at = glm::ivec2(100, 75) + (level ? glm::ivec2(along, across) : glm::ivec2(across, along));
            const double more = linear(picture.at(at.x, at.y).y) - linear(background.at(at.x, at.y).y);
            light += more;
            moment += more * (across + 0.5);
        }
        const double expected = -(along + 0.5) * static_cast<double>(level ? 1.0F / slant : slant);
        squares += std::pow(moment / light - expected, 2.0);
        ++rows;
    }
    QVERIFY(std::sqrt(squares / rows) < 0.2);
}

void TestRendererTarget::complaintsAboutOthersAreNotItsOwn()
{
    glEnable(GL_NONE + 1);
    draw(emptyScene(), {}, 60, 40);
    QVERIFY(m_renderer->statistics().complete);
    QVERIFY(!m_gl->takeErrors().empty());
}

void TestRendererTarget::pictureIsCopiedToTheCallersFramebufferAndStateIsKept()
{
    Scene scene = emptyScene();
    scene.background = glm::vec3(0.2F, 0.1F, 0.05F);
    const Picture picture = draw(scene, {}, 60, 40);
    const ForeignFramebuffer foreign(60, 40);
    m_renderer->blitTo(foreign.id(), 60, 40);
    QVERIFY(foreign.isBound());
    QCOMPARE(foreign.centre(), picture.at(30, 20));
}

HAIRPAINT_TEST(TestRendererTarget, None)
#include "test_renderer_target.moc"
