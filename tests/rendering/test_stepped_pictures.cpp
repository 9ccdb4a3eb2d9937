// A picture drawn in steps is the one drawn at once; until it is whole the last one stays.
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/test_program.h"
#include "view/rendering/gl/gl_objects.h"

#include <QtTest>

#include <epoxy/gl.h>

#include <array>
#include <limits>
#include <vector>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::Quality;
using rendering::Scene;

namespace {

constexpr int kSteppedWidth = 100;
constexpr int kSteppedHeight = 76;

/// A head with a ring on it and two groups of hair, of several pieces each.
Scene hairyScene()
{
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    const auto frame = makeFrame(hairOnBall(kBall, {.hairs = 6000}), plainSettings(), 1);
    const auto more = makeFrame(comb(0xFF20C020U, 4000), plainSettings(), 2);
    frame->groups.push_back(more->groups[0]);
    frame->hairCount += more->hairCount;
    scene.hair = frame;
    scene.ring = rendering::Ring{.centreHd = {0.0F, 0.0F, 0.1F}, .normalHd = {0.0F, 0.0F, 1.0F}, .radiusM = 0.02F};
    return scene;
}

Scene redComb()
{
    Scene scene = emptyScene();
    scene.hair = makeFrame(comb(0xFF2020C0U, 3000), plainSettings());
    return scene;
}

/// What a neighbour in the same context may leave behind: nothing that the renderer binds is where it was.
class ForeignState
{
public:
    ForeignState() : m_framebuffer(16, 16)
    {
        m_buffer.reserve(1U << 20U);
        m_flat.resize2D(GL_RGBA8, 16, 16);
        m_solid.resize3D(GL_R32F, 4);
        const std::vector<float> dense(64, 9.0F);
        m_solid.bind(0);
        glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 4, 4, 4, GL_RED, GL_FLOAT, dense.data());
    }
    void set() const
    {
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
        glViewport(1, 2, 3, 4);
        glUseProgram(0);
        glBindVertexArray(0);
        m_buffer.bindUniform(0);
        for (unsigned index = 0; index < 4; ++index) {
            m_buffer.bindStorage(index);
            m_flat.bind(index);
            m_solid.bind(index);
        }
        glBindImageTexture(0, m_flat.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA8);
        for (const GLenum test : kTests)
            glEnable(test);
        glScissor(0, 0, 1, 1);
        glBlendFunc(GL_ZERO, GL_ZERO);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_NEVER);
    }
    ~ForeignState()
    {
        for (const GLenum test : kTests)
            glDisable(test);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_LESS);
    }
    ForeignState(const ForeignState&) = delete;
    ForeignState& operator=(const ForeignState&) = delete;

private:
    static constexpr std::array<GLenum, 5> kTests{GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST,
                                                  GL_FRAMEBUFFER_SRGB};
    ForeignFramebuffer m_framebuffer;
    rendering::Buffer m_buffer;
    rendering::Texture m_flat;
    rendering::Texture m_solid;
};

} // namespace

class TestSteppedPictures : public RendererFixture
{
    Q_OBJECT

private:
    [[nodiscard]] Picture lastPicture(int width = kSteppedWidth, int height = kSteppedHeight)
    {
        Picture picture{.width = width, .height = height, .pixels = {}};
        m_renderer->read(picture.pixels);
        return picture;
    }

private Q_SLOTS:
    void stepsGiveThePictureDrawnAtOnce_data();
    void stepsGiveThePictureDrawnAtOnce();
    void aLargeBudgetIsOneStep();
    void aPictureWithoutHairIsOneStep();
    void whatOthersDoBetweenStepsDoesNoHarm();
    void theLastPictureStaysUntilTheNextIsWhole();
    void aPictureDrawnMeanwhileDropsTheOneUnderWay_data();
    void aPictureDrawnMeanwhileDropsTheOneUnderWay();
    void stepsDoNotCountInTheTimeOfWhatIsDrawnAtOnce();
};

void TestSteppedPictures::stepsGiveThePictureDrawnAtOnce_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<float>("detail");
    QTest::newRow("fine") << 4 << 1.0F;
    QTest::newRow("between") << 2 << 1.0F;
    QTest::newRow("coarse") << 1 << 0.5F;
}

void TestSteppedPictures::stepsGiveThePictureDrawnAtOnce()
{
    QFETCH(int, samples);
    QFETCH(float, detail);
    const Quality quality{.detail = detail, .samples = samples};
    const Scene scene = hairyScene();
    const Picture whole = draw(scene, quality, kSteppedWidth, kSteppedHeight);
    const rendering::FrameStatistics statistics = m_renderer->statistics();
    draw(redComb());
    m_renderer->begin(scene, quality, kSteppedWidth, kSteppedHeight);
    int steps = 1;
    while (!m_renderer->step(0.0))
        ++steps;
    QVERIFY2(steps >= 5, qPrintable(QString::number(steps)));
    QCOMPARE(lastPicture().pixels == whole.pixels, true);
    QCOMPARE(m_renderer->statistics().drawnHairs, statistics.drawnHairs);
    QCOMPARE(m_renderer->statistics().drawnSegments, statistics.drawnSegments);
    QVERIFY(m_renderer->statistics().complete);
    QVERIFY(m_renderer->step(0.0)); // Nothing is left.
    QCOMPARE(lastPicture().pixels == whole.pixels, true);
}

void TestSteppedPictures::aLargeBudgetIsOneStep()
{
    const Picture whole = draw(hairyScene(), {}, kSteppedWidth, kSteppedHeight);
    draw(redComb());
    m_renderer->begin(hairyScene(), {}, kSteppedWidth, kSteppedHeight);
    QVERIFY(m_renderer->step(std::numeric_limits<double>::infinity()));
    QCOMPARE(lastPicture().pixels == whole.pixels, true);
}

void TestSteppedPictures::aPictureWithoutHairIsOneStep()
{
    Scene bald = hairyScene();
    bald.hair.reset();
    const Picture whole = draw(bald, {}, kSteppedWidth, kSteppedHeight);
    draw(redComb());
    m_renderer->begin(bald, {}, kSteppedWidth, kSteppedHeight);
    QVERIFY(m_renderer->step(0.0));
    QCOMPARE(lastPicture().pixels == whole.pixels, true);
    QCOMPARE(m_renderer->statistics().drawnHairs, std::size_t{0});
}

void TestSteppedPictures::whatOthersDoBetweenStepsDoesNoHarm()
{
    const Picture whole = draw(hairyScene(), {}, kSteppedWidth, kSteppedHeight);
    draw(redComb());
    const ForeignState foreign;
    foreign.set();
    m_renderer->begin(hairyScene(), {}, kSteppedWidth, kSteppedHeight);
    do {
        foreign.set();
        glEnable(GL_NONE + 1); // A complaint that is not the renderer's.
    } while (!m_renderer->step(0.0));
    QVERIFY(!m_gl->takeErrors().empty());
    QVERIFY(m_renderer->statistics().complete);
    foreign.set();
    QCOMPARE(lastPicture().pixels == whole.pixels, true);
}

void TestSteppedPictures::theLastPictureStaysUntilTheNextIsWhole()
{
    Scene red = redComb();
    red.background = glm::vec3(0.2F, 0.1F, 0.05F);
    const Picture last = draw(red, {}, 60, 40);
    const std::size_t hairs = m_renderer->statistics().drawnHairs;
    const ForeignFramebuffer foreign(60, 40);
    m_renderer->begin(hairyScene(), {}, kSteppedWidth, kSteppedHeight);
    int steps = 0;
    do {
        QCOMPARE(lastPicture(60, 40).pixels == last.pixels, true);
        QCOMPARE(m_renderer->statistics().drawnHairs, hairs);
        glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
        glClear(GL_COLOR_BUFFER_BIT);
        m_renderer->blitTo(foreign.id(), 60, 40);
        QCOMPARE(foreign.centre(), last.at(30, 20));
        ++steps;
    } while (!m_renderer->step(0.0));
    QVERIFY(steps >= 5);
    QCOMPARE(lastPicture().pixels == draw(hairyScene(), {}, kSteppedWidth, kSteppedHeight).pixels, true);
}

void TestSteppedPictures::aPictureDrawnMeanwhileDropsTheOneUnderWay_data()
{
    QTest::addColumn<bool>("inSteps");
    QTest::newRow("at once") << false;
    QTest::newRow("in steps") << true;
}

void TestSteppedPictures::aPictureDrawnMeanwhileDropsTheOneUnderWay()
{
    QFETCH(bool, inSteps);
    const Picture red = draw(redComb(), {}, 120, 90);
    const Picture hairy = draw(hairyScene(), {}, kSteppedWidth, kSteppedHeight);
    m_renderer->begin(hairyScene(), {}, kSteppedWidth, kSteppedHeight);
    QVERIFY(!m_renderer->step(0.0));
    QVERIFY(!m_renderer->step(0.0));
    if (inSteps)
        m_renderer->begin(redComb(), {}, 120, 90);
    else
        m_renderer->draw(redComb(), {}, 120, 90);
    while (!m_renderer->step(0.0))
        QVERIFY(inSteps);
    QCOMPARE(lastPicture(120, 90).pixels == red.pixels, true);
    QCOMPARE(m_renderer->statistics().drawnHairs, std::size_t{3000});
    QCOMPARE(draw(hairyScene(), {}, kSteppedWidth, kSteppedHeight).pixels == hairy.pixels, true);
}

void TestSteppedPictures::stepsDoNotCountInTheTimeOfWhatIsDrawnAtOnce()
{
    m_renderer->draw(redComb(), {}, kSteppedWidth, kSteppedHeight);
    const double ms = m_renderer->statistics().milliseconds;
    QVERIFY(!m_renderer->statistics().inSteps);
    m_renderer->begin(hairyScene(), {}, kSteppedWidth, kSteppedHeight);
    QVERIFY(!m_renderer->step(0.0));
    static_cast<void>(lastPicture());
    QCOMPARE(m_renderer->statistics().milliseconds, ms);
    while (!m_renderer->step(0.0)) {
    }
    const double stepsMs = m_renderer->statistics().milliseconds;
    QVERIFY(stepsMs > 0.0 && m_renderer->statistics().inSteps);
    static_cast<void>(lastPicture());
    QCOMPARE(m_renderer->statistics().milliseconds, stepsMs);
}

HAIRPAINT_TEST(TestSteppedPictures, None)
#include "test_stepped_pictures.moc"
