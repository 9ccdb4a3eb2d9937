// The renderer draws what the scene says, off-screen.
#include "tests/rendering/hand_made_hair.h"
#include "view/rendering/offscreen_context.h"
#include "view/rendering/renderer.h"

#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::testing;

class TestRenderer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void headCoversTheMiddleAndNotTheCorners();

private:
    struct Picture
    {
        int width = 0;
        std::vector<std::uint8_t> pixels;
        [[nodiscard]] glm::ivec3 at(int x, int y) const
        {
            const auto i = static_cast<std::size_t>((y * width + x) * 4);
            return {pixels[i], pixels[i + 1], pixels[i + 2]};
        }
    };
    Picture draw(const rendering::Scene& scene, const rendering::Quality& quality = {}, int width = 200,
                 int height = 150)
    {
        Picture picture{.width = width, .pixels = {}};
        m_renderer->draw(scene, quality, width, height);
        m_renderer->read(picture.pixels);
        return picture;
    }

    std::unique_ptr<rendering::OffscreenContext> m_context;
    std::unique_ptr<rendering::Renderer> m_renderer;
};

void TestRenderer::initTestCase()
{
    auto context = rendering::OffscreenContext::create();
    QVERIFY2(context.has_value(), context.has_value() ? "" : context.error().c_str());
    m_context = std::move(*context);
    QVERIFY(m_context->makeCurrent());
    auto renderer = rendering::Renderer::create();
    QVERIFY2(renderer.has_value(), renderer.has_value() ? "" : renderer.error().c_str());
    m_renderer = std::move(*renderer);
}

void TestRenderer::headCoversTheMiddleAndNotTheCorners()
{
    rendering::Scene scene;
    const Picture without = draw(scene);
    scene.head = makeBall(glm::vec3(0.08F, 0.11F, 0.1F));
    const Picture with = draw(scene);
    QVERIFY(with.at(100, 75) != without.at(100, 75));
    QVERIFY(with.at(100, 75).x > without.at(100, 75).x + 40);
    for (const glm::ivec2 corner : {glm::ivec2(0, 0), glm::ivec2(199, 0), glm::ivec2(0, 149), glm::ivec2(199, 149)})
        QCOMPARE(with.at(corner.x, corner.y), without.at(corner.x, corner.y));
}

QTEST_APPLESS_MAIN(TestRenderer)
#include "test_renderer.moc"
