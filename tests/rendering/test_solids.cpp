// What is worn on the head and drawn: lit bodies with depth, by both renderers.
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/test_program.h"
#include "view/rendering/software/software_renderer.h"

#include <QtTest>

#include <array>
#include <cmath>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::Scene;
using rendering::Solid;

namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 150;
constexpr float kPixelM = 0.00266F; // At the middle of the picture.
constexpr rendering::Quality kFine{.samples = 4};

Solid redSolid(glm::vec3 centreHd, glm::vec3 semiAxesM = glm::vec3(0.02F))
{
    static const std::shared_ptr<const sim::HeadMesh> unit = makeBall(glm::vec3(1.0F));
    return {.mesh = unit, .shape = {.centreHd = centreHd, .semiAxesM = semiAxesM}, .colour = {0.5F, 0.02F, 0.02F}};
}

Scene headScene()
{
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    return scene;
}

bool isRed(glm::ivec3 pixel)
{
    return pixel.x > pixel.y + 30 && pixel.x > pixel.z + 30;
}

/// The pixel of a point in the plane through the origin that faces the eye.
glm::ivec3 pixelAt(const Picture& picture, float xM, float yM)
{
    return picture.at(kWidth / 2 + static_cast<int>(std::lround(xM / kPixelM)),
                      kHeight / 2 - static_cast<int>(std::lround(yM / kPixelM)));
}

} // namespace

class TestSolids : public RendererFixture
{
    Q_OBJECT
private Q_SLOTS:
    void aBodyIsLitAndHasItsColour()
    {
        const std::array<Picture, 2> without = drawnByBoth(headScene());
        Scene scene = headScene();
        scene.solids = {redSolid({0.0F, 0.0F, 0.11F})};
        const std::array<Picture, 2> with = drawnByBoth(scene);
        for (std::size_t i = 0; i < with.size(); ++i) {
            QVERIFY(isRed(pixelAt(with[i], 0.0F, 0.0F)));
            QVERIFY(pixelAt(with[i], 0.005F, 0.012F).x > pixelAt(with[i], -0.005F, -0.012F).x + 10); // Lit from above.
            QVERIFY(pixelAt(with[i], 0.06F, 0.0F) == pixelAt(without[i], 0.06F, 0.0F));
            QVERIFY(!isRed(pixelAt(without[i], 0.0F, 0.0F)));
        }
        QVERIFY(with[0].difference(with[1]) / (3.0 * 255.0) < 0.02);
        QVERIFY(with[0].difference(with[1], 88, 63, 112, 87) / (3.0 * 255.0) < 0.02);
    }

    void aBodyBehindTheHeadIsHidden()
    {
        const std::array<Picture, 2> without = drawnByBoth(headScene());
        Scene scene = headScene();
        scene.solids = {redSolid({0.0F, 0.0F, -0.2F})};
        const std::array<Picture, 2> with = drawnByBoth(scene);
        for (std::size_t i = 0; i < with.size(); ++i)
            QVERIFY(with[i].pixels == without[i].pixels);
    }

    /// At the rim of the head a body behind it begins without a seam of background.
    void nothingShinesThroughBetweenHeadAndBody()
    {
        Scene scene = headScene();
        scene.background = glm::vec3(0.0F, 0.0F, 1.0F);
        scene.skin.colour = scene.skin.lips = scene.skin.lids = glm::vec3(0.3F, 0.2F, 0.02F);
        scene.skin.sheen = 0.0F;
        scene.solids = {redSolid({0.08F, 0.0F, -0.05F}, glm::vec3(0.04F))};
        for (const Picture& picture : drawnByBoth(scene))
            for (int x = kWidth / 2; x < kWidth / 2 + 36; ++x)
                QVERIFY2(picture.at(x, kHeight / 2).z < 140, qPrintable(QString::number(x)));
    }

    void hairLiesBeforeAndBehind()
    {
        for (const float depthM : {-0.1F, 0.1F}) {
            Scene scene = emptyScene();
            scene.hair = makeFrame(comb(0xFF20C020U, 300), plainSettings());
            scene.solids = {redSolid({0.0F, 0.0F, depthM})};
            for (const Picture& picture : drawnByBoth(scene))
                QCOMPARE(isRed(pixelAt(picture, 0.0F, 0.0F)), depthM > 0.0F);
        }
    }

    /// Hair dips into skin, but not into what presses it down.
    void hairCloseBehindShowsThroughSkinAlone()
    {
        constexpr float kBehindM = 0.005F;
        Scene scene = emptyScene();
        scene.hair = makeFrame(comb(0xFF20C020U, 300), plainSettings());
        scene.head = makeBall({kBall.x, kBall.y, kBehindM});
        const auto isGreen = [](glm::ivec3 pixel) { return pixel.y > pixel.x + 30 && pixel.y > pixel.z + 30; };
        for (const Picture& picture : drawnByBoth(scene))
            QVERIFY(isGreen(pixelAt(picture, 0.0F, 0.0F)));
        scene.solids = {redSolid({0.0F, 0.0F, 2.0F * kBehindM - 0.02F})};
        for (const Picture& picture : drawnByBoth(scene))
            QVERIFY(isRed(pixelAt(picture, 0.0F, 0.0F)));
    }

    void itGoesWithTheHead()
    {
        Scene scene = emptyScene();
        scene.solids = {redSolid({0.08F, 0.0F, 0.0F})};
        const auto frame = makeFrame({});
        for (const bool turned : {false, true}) {
            frame->pose.rotation = turned ? glm::quat(0.0F, 0.0F, 1.0F, 0.0F) : glm::quat(1.0F, 0.0F, 0.0F, 0.0F);
            scene.hair = std::make_shared<sim::StrandFrame>(*frame);
            for (const Picture& picture : drawnByBoth(scene)) {
                QCOMPARE(isRed(pixelAt(picture, 0.08F, 0.0F)), !turned);
                QCOMPARE(isRed(pixelAt(picture, -0.08F, 0.0F)), turned);
            }
        }
    }

    void itsShapeIsScaledAndTurned()
    {
        Scene scene = emptyScene();
        Solid upright = redSolid({0.0F, 0.0F, 0.0F}, {0.06F, 0.01F, 0.01F});
        upright.shape.rotation = glm::angleAxis(1.5707963F, glm::vec3(0.0F, 0.0F, 1.0F));
        scene.solids = {upright, redSolid({0.1F, 0.0F, 0.0F}, glm::vec3(0.01F))};
        for (const Picture& picture : drawnByBoth(scene)) {
            QVERIFY(isRed(pixelAt(picture, 0.0F, 0.045F)) && isRed(pixelAt(picture, 0.0F, -0.045F)));
            QVERIFY(!isRed(pixelAt(picture, 0.03F, 0.0F)));
            QVERIFY(isRed(pixelAt(picture, 0.1F, 0.0F)));
        }
    }

    void oneThatGoesLeavesNothing()
    {
        rendering::SoftwareRenderer software;
        for (rendering::Backend* renderer : std::initializer_list<rendering::Backend*>{&software, m_renderer.get()}) {
            Scene scene = headScene();
            const Picture before = drawn(*renderer, scene, kFine, kWidth, kHeight);
            scene.solids = {redSolid({0.0F, 0.0F, 0.11F})};
            const Picture with = drawn(*renderer, scene, kFine, kWidth, kHeight);
            scene.solids.front().shape.centreHd.x = 0.03F;
            const Picture moved = drawn(*renderer, scene, kFine, kWidth, kHeight);
            scene.solids.clear();
            QVERIFY(with.pixels != before.pixels && moved.pixels != with.pixels);
            QVERIFY(drawn(*renderer, scene, kFine, kWidth, kHeight).pixels == before.pixels);
        }
    }

private:
    std::array<Picture, 2> drawnByBoth(const Scene& scene)
    {
        rendering::SoftwareRenderer software;
        return {drawn(software, scene, kFine, kWidth, kHeight), draw(scene, kFine, kWidth, kHeight)};
    }
};

HAIRPAINT_TEST(TestSolids, None)
#include "test_solids.moc"
