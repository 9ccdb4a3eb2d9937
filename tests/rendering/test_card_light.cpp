// Cards are lit as the hair that lies along them, by either renderer.
#include "tests/rendering/golden_scenes.h"
#include "tests/rendering/renderer_fixture.h"
#include "tests/support/test_program.h"
#include "view/rendering/card_set.h"
#include "view/rendering/software/software_renderer.h"

#include <algorithm>
#include <cmath>
#include <string_view>

using namespace hairpaint::rendering;

namespace hairpaint::testing {

namespace {

Scene cardScene()
{
    const auto scenes = goldenScenes();
    return std::ranges::find(scenes, std::string_view("cards"), &GoldenScene::name)->make();
}

Picture drawnInSoftware(SoftwareRenderer& renderer, const Scene& scene, int width, int height)
{
    renderer.draw(scene, {}, width, height);
    Picture picture{.width = width, .height = height, .pixels = {}};
    renderer.read(picture.pixels);
    return picture;
}

} // namespace

class TestCardLight : public RendererFixture
{
    Q_OBJECT
private:
    SoftwareRenderer m_software;

    Picture drawnBy(bool isSoftware, const Scene& scene)
    {
        return isSoftware ? drawnInSoftware(m_software, scene, 120, 90) : draw(scene, {}, 120, 90);
    }

private Q_SLOTS:
    void cornersKnowTheHairAround()
    {
        const std::shared_ptr<const CardSet> cards = cardScene().cards;
        for (const CardCorner& corner : cards->corners) {
            QVERIFY(std::abs(glm::length(corner.tangentHd) - 1.0F) < 1e-4F);
            QVERIFY(std::abs(glm::dot(corner.tangentHd, corner.normalHd)) < 0.3F); // Strips are bent.
        }
        // Along v, from the crown down; the texture is lighter at the tips.
        const CardCorner& root = cards->corners.front();
        const CardCorner& tip = cards->corners[12];
        QVERIFY(tip.uv.y > 0.9F && tip.tangentHd.y < -0.8F);
        QVERIFY(tip.colour.r > 1.5F * root.colour.r);
        QVERIFY(root.colour.r > root.colour.b);
    }

    void theWayHairScattersLightIsSeen_data()
    {
        QTest::addColumn<bool>("software");
        QTest::newRow("software") << true;
        QTest::newRow("OpenGL") << false;
    }
    void theScatteringOfHairIsSeen()
    {
        QFETCH(bool, software);
        Scene scene = cardScene();
        const Picture marschner = drawnBy(software, scene);
        for (const ScatteringModel other : {ScatteringModel::KajiyaKay, ScatteringModel::IlluminatedLines}) {
            scene.light.scattering = other;
            QVERIFY(drawnBy(software, scene).difference(marschner) > 0.4);
        }
        // So is how much it shines.
        scene = cardScene();
        auto dull = std::make_shared<CardSet>(*scene.cards);
        for (CardCorner& corner : dull->corners)
            corner.shine = 0.0F;
        scene.cards = dull;
        QVERIFY(drawnBy(software, scene).difference(marschner) > 0.4);
    }

    void bothRenderersAgree()
    {
        Scene scene = cardScene();
        for (const glm::vec3 toward : {glm::vec3(0.4F, 0.6F, 0.7F), glm::vec3(0.3F, 0.4F, -1.0F)}) {
            scene.light.directionWo = glm::normalize(toward);
            const double difference = drawnBy(true, scene).difference(drawnBy(false, scene));
            QVERIFY2(difference < 1.5, qPrintable(QString::number(difference)));
        }
    }
};

} // namespace hairpaint::testing

HAIRPAINT_TEST(hairpaint::testing::TestCardLight, None)
#include "test_card_light.moc"
