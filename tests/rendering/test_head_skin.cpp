// The skin that the renderer draws: its colours, its marks and the light at the edge of the shadow.
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>

using namespace hairpaint;
using namespace hairpaint::testing;
using rendering::Scene;

Q_DECLARE_METATYPE(hairpaint::sim::SkinMarks)

class TestHeadSkin : public RendererFixture
{
    Q_OBJECT
private:
    static rendering::SkinShading fair()
    {
        return {.colour = {0.72F, 0.48F, 0.36F},
                .lips = {0.58F, 0.30F, 0.24F},
                .lids = {0.62F, 0.38F, 0.28F},
                .scatter = 1.0F,
                .grain = 0.0F,
                .sheen = 0.8F};
    }

    /// Lit from the picture's right; without grain, so that single pixels tell.
    static Scene ballOf(const rendering::SkinShading& skin, const sim::SkinMarks& marks = {})
    {
        Scene scene = emptyScene();
        auto ball = std::make_shared<sim::HeadMesh>(*makeBall(kBall));
        ball->marks.assign(ball->positionsHd.size(), marks);
        scene.head = ball;
        scene.skin = skin;
        scene.skin.grain = 0.0F;
        scene.light.directionWo = glm::vec3(1.0F, 0.0F, 0.0F);
        scene.light.ambient = 0.2F;
        scene.light.fill = 0.0F;
        scene.light.rim = 0.0F;
        return scene;
    }

    static double rednessAt(const Picture& picture, int x)
    {
        const glm::ivec3 pixel = picture.at(x, 75);
        return static_cast<double>(pixel.x) / std::max(pixel.z, 1);
    }

    static int brightness(const Picture& picture, int x) { return picture.at(x, 75).x + picture.at(x, 75).y; }

private Q_SLOTS:
    void theShadowsEdgeIsRedWhereLightScatters()
    {
        const auto redness = [this](float scatter) {
            rendering::SkinShading skin = fair();
            skin.scatter = scatter;
            const Picture picture = draw(ballOf(skin));
            double reddest = 0.0; // A little beyond the middle, where the ball turns away from the light.
            for (int x = 88; x <= 100; ++x)
                reddest = std::max(reddest, rednessAt(picture, x));
            return reddest / rednessAt(picture, 118);
        };
        QVERIFY2(redness(1.0F) > 1.12 && redness(1.0F) < 1.8, qPrintable(QString::number(redness(1.0F))));
        QVERIFY2(redness(0.0F) < 1.08, qPrintable(QString::number(redness(0.0F))));
    }

    void lipsLidsAndFoldsAreToldApart_data()
    {
        QTest::addColumn<sim::SkinMarks>("marks");
        QTest::addColumn<int>("least");
        QTest::newRow("lips") << sim::SkinMarks{.lips = 255} << 20;
        QTest::newRow("lids") << sim::SkinMarks{.lids = 255} << 10;
        QTest::newRow("a fold") << sim::SkinMarks{.sky = 128} << 20;
    }
    void lipsLidsAndFoldsAreToldApart()
    {
        QFETCH(sim::SkinMarks, marks);
        QFETCH(int, least);
        const int darker = brightness(draw(ballOf(fair())), 112) - brightness(draw(ballOf(fair(), marks)), 112);
        QVERIFY2(darker > least, qPrintable(QString::number(darker)));
    }

    void aMeshWithoutMarksIsPlainSkin()
    {
        Scene scene = ballOf(fair());
        const Picture marked = draw(scene);
        scene.head = makeBall(kBall);
        QCOMPARE(draw(scene).difference(marked), 0.0);
    }

    void grainIsSeenNearByAndDoesNotFlickerFarAway()
    {
        const auto grainAt = [&](float distanceM) {
            Scene scene = ballOf(fair());
            scene.camera.distanceM = distanceM;
            const Picture smooth = draw(scene);
            scene.skin.grain = 1.0F;
            return draw(scene).difference(smooth);
        };
        QVERIFY(grainAt(0.16F) > 0.5);
        QCOMPARE(grainAt(1.5F), 0.0);
    }
};

HAIRPAINT_TEST(TestHeadSkin, None)
#include "test_head_skin.moc"
