// The frame in which hair's direction is told, and how a map stores it.
#include "sim/groom/growth_direction.h"
#include "sim/groom/map_sampler.h"
#include "sim/skin/skin_frame.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

using namespace hairpaint::sim;
using namespace hairpaint::test;

class TestSkinFrame : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void xGoesRightAndYUpTheMapHoweverItIsLaidOut_data()
    {
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("as seen from outside") << false;
        QTest::newRow("mirrored on the skin") << true;
    }
    void xGoesRightAndYUpTheMapHoweverItIsLaidOut()
    {
        QFETCH(bool, mirrored);
        HeadMesh mesh = makeBallHead();
        if (mirrored)
            for (glm::vec2& uv : mesh.uvs)
                uv.x = 1.0F - uv.x;
        const Skin skin(std::move(mesh));
        for (const glm::vec2 uv : {glm::vec2(0.5F, 0.5F), glm::vec2(0.2F, 0.3F), glm::vec2(0.8F, 0.7F)}) {
            const SurfacePoint point = *skin.atUv(uv);
            const SkinFrame frame = SkinFrame::at(point);
            QVERIFY(glm::dot(frame.x, glm::normalize(point.dPduHd)) > 0.99F);
            QVERIFY(glm::dot(frame.y, glm::normalize(point.dPdvHd)) > 0.99F);
            QVERIFY(std::abs(glm::dot(frame.x, frame.y)) < 1e-5F);
            QVERIFY(std::abs(glm::dot(frame.y, frame.normal)) < 1e-5F);
            const glm::vec2 direction(0.3F, -0.6F);
            QVERIFY(glm::distance(frame.fromHd(frame.toHd(direction)), direction) < 1e-5F);
        }
    }

    void whatIsStoredIsReadBackToHalfAStep()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<float> unit(-0.7F, 0.7F);
        for (int i = 0; i < 1000; ++i) {
            const glm::vec2 direction(unit(random), unit(random));
            QVERIFY(glm::distance(directionOf(texelOfDirection(direction)), direction) < 1.0F / 32767.0F);
        }
        QCOMPARE(texelOfDirection({0.0F, 0.0F}), ruleOf(MapSlot::Direction).defaultValue);
        QCOMPARE(directionOf(ruleOf(MapSlot::Direction).defaultValue), glm::vec2(0.0F));
        QVERIFY(std::abs(glm::length(directionOf({65535, 65535})) - 1.0F) < 1e-5F);
        QVERIFY(std::abs(glm::length(directionOf({0, 0})) - 1.0F) < 1e-5F);
    }

    void aSamplerReadsVectorsBetweenTexels()
    {
        auto raster = std::make_shared<TiledRaster>(256, 2, texelOfDirection({0.5F, 0.0F}));
        QVERIFY(glm::distance(MapSampler(raster).vector({0.3F, 0.6F}), glm::vec2(0.5F, 0.0F)) < 1e-4F);
        for (int y = 0; y < 256; ++y)
            for (int x = 128; x < 256; ++x)
                raster->setTexel(x, y, texelOfDirection({0.0F, -0.5F}));
        const MapSampler sampler(raster);
        // Half way round, as flat as both.
        QVERIFY(glm::distance(sampler.vector({0.5F, 0.4F}), glm::vec2(0.353553F, -0.353553F)) < 1e-4F);
        QVERIFY(glm::distance(sampler.vector({0.9F, 0.4F}), glm::vec2(0.0F, -0.5F)) < 1e-4F);
    }

    void hairThatTurnsKeepsHowFlatItLies()
    {
        using glm::vec3;
        const vec3 right(1.0F, 0.0F, 0.0F);
        const vec3 up(0.0F, 0.5F, 0.0F);
        QCOMPARE(glm::length(turnedBetween(right, up, 0.5F)), 0.75F);
        QCOMPARE(turnedBetween(right, up, 0.0F), right);
        QCOMPARE(turnedBetween(right, up, 1.0F), up);
        QCOMPARE(turnedBetween(right, -right, 0.499F), right);
        QCOMPARE(turnedBetween(right, -right, 0.501F), -right);
        QCOMPARE(turnedBetween(vec3(0.0F), vec3(0.0F), 0.5F), vec3(0.0F));
        for (const float falls : {0.0F, 0.3F, 0.5F, 0.77F, 1.0F})
            for (const glm::vec3 same : {vec3(0.3F, -0.4F, 0.123F), vec3(1e-4F, 0.0F, 0.0F), vec3(0.0F)})
                QCOMPARE((GrowthDirections{.grownHd = same, .fallenHd = same}.of(falls)),
                         turnedBetween(same, same, falls));
        QCOMPARE(glm::length(turnedBetween(DirectionVector(0.3F, 0.4F), DirectionVector(0.0F), 0.5F)), 0.25F);
    }

    void vectorsOpposedToEachOtherDoNotStandBetween()
    {
        TiledRaster raster(256, 2, texelOfDirection({0.9F, 0.0F}));
        for (int y = 0; y < 256; ++y)
            for (int x = 128; x < 256; ++x)
                raster.setTexel(x, y, texelOfDirection({-0.9F, 0.0F}));
        for (int i = -10; i <= 10; ++i) {
            const glm::vec2 uv(0.5F + 0.0004F * static_cast<float>(i), 0.4F);
            QVERIFY(std::abs(glm::length(directionAt(raster, uv)) - 0.9F) < 1e-3F);
        }
    }
};

HAIRPAINT_TEST(TestSkinFrame, None)
#include "test_skin_frame.moc"
