// Parts of a character: bodies that show a picture by their uvs, and are not there where its alpha is none.
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/test_program.h"
#include "view/rendering/software/software_renderer.h"

#include <QtTest>

#include <array>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::Scene;

namespace {

constexpr int kMiddleX = 100;
constexpr int kMiddleY = 75;

/// A square that faces the eye, 8 cm large, before the head; its left half shows the texture's left half.
Scene sceneOfSquare(std::array<std::uint8_t, 4> left, std::array<std::uint8_t, 4> right, bool masked)
{
    auto square = std::make_shared<sim::HeadMesh>();
    for (const glm::vec2 uv : {glm::vec2(0.0F), glm::vec2(1.0F, 0.0F), glm::vec2(1.0F), glm::vec2(0.0F, 1.0F)}) {
        square->positionsHd.emplace_back(0.08F * (uv.x - 0.5F), 0.08F * (uv.y - 0.5F), 0.12F);
        square->normalsHd.emplace_back(0.0F, 0.0F, 1.0F);
        square->uvs.push_back(uv);
    }
    square->triangles = {{0, 1, 2}, {0, 2, 3}};
    auto texture = std::make_shared<sim::MeshTexture>();
    texture->width = texture->height = 16;
    for (int i = 0; i < 256; ++i) {
        const auto& colour = i % 16 < 8 ? left : right;
        texture->rgba.insert(texture->rgba.end(), colour.begin(), colour.end());
    }
    Scene scene = emptyScene();
    scene.head = makeBall(kBall);
    scene.solids.push_back({.mesh = square,
                            .shape = {.centreHd = glm::vec3(0.0F), .semiAxesM = glm::vec3(1.0F)},
                            .colour = glm::vec3(1.0F),
                            .open = true,
                            .masked = masked,
                            .texture = texture});
    return scene;
}

} // namespace

class TestTexturedSolids : public RendererFixture
{
    Q_OBJECT
private Q_SLOTS:
    void aPictureLiesOnABodyByItsUvs()
    {
        const std::array<Picture, 2> drawn = drawnByBoth(sceneOfSquare({220, 10, 10, 255}, {10, 10, 220, 255}, false));
        for (const Picture& picture : drawn) {
            const glm::ivec3 left = picture.at(kMiddleX - 8, kMiddleY);
            const glm::ivec3 right = picture.at(kMiddleX + 8, kMiddleY);
            QVERIFY(left.x > 2 * std::max(left.y, left.z));
            QVERIFY(right.z > 2 * std::max(right.x, right.y));
        }
        QVERIFY(drawn[0].difference(drawn[1]) / (3.0 * 255.0) < 0.02);
    }

    void whatItsAlphaLeavesOutIsNotThere()
    {
        const std::array<Picture, 2> drawn = drawnByBoth(sceneOfSquare({220, 10, 10, 255}, {10, 10, 220, 0}, true));
        for (const Picture& picture : drawn) {
            const glm::ivec3 left = picture.at(kMiddleX - 8, kMiddleY);
            const glm::ivec3 right = picture.at(kMiddleX + 8, kMiddleY);
            QVERIFY(left.x > 2 * std::max(left.y, left.z));
            QVERIFY(right.z < 2 * std::max(right.x, right.y)); // The head behind it.
        }
    }

    void aPictureLiesOnTheHeadAndIsTakenAwayAgain()
    {
        auto halves = std::make_shared<sim::MeshTexture>();
        halves->width = halves->height = 2;
        halves->rgba = {220, 10, 10, 255, 10, 10, 220, 255, 220, 10, 10, 255, 10, 10, 220, 255};
        Scene scene = emptyScene();
        scene.head = makeBall(kBall);
        scene.skinTexture = halves;
        // From the front, u = 0 and 1 meet in the middle of the picture, and so do the colours.
        const std::array<Picture, 2> drawn = drawnByBoth(scene);
        for (const Picture& picture : drawn) {
            const glm::ivec3 left = picture.at(kMiddleX - 30, kMiddleY);
            const glm::ivec3 right = picture.at(kMiddleX + 30, kMiddleY);
            QVERIFY((left.x > 2 * left.z && right.z > 2 * right.x) || (left.z > 2 * left.x && right.x > 2 * right.z));
        }
        QVERIFY(drawn[0].difference(drawn[1]) / (3.0 * 255.0) < 0.02);
        scene.skinTexture.reset();
        for (const Picture& picture : drawnByBoth(scene)) {
            const glm::ivec3 left = picture.at(kMiddleX - 30, kMiddleY);
            QVERIFY(left.x < 2 * left.z && left.z < 2 * left.x);
        }
    }

private:
    /// By software, then by OpenGL.
    std::array<Picture, 2> drawnByBoth(const Scene& scene)
    {
        constexpr rendering::Quality kFine{.samples = 4};
        rendering::SoftwareRenderer software;
        return {drawn(software, scene, kFine), draw(scene, kFine)};
    }
};

HAIRPAINT_TEST(TestTexturedSolids, None)
#include "test_textured_solids.moc"
