// Turns and radius of curls, from the maps at a hair's root.
#include "sim/groom/groom.h"
#include "tests/sim/groom_reading.h"
#include "tests/sim/small_groom.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <set>

using namespace hairpaint::sim;
using namespace hairpaint::test;

class TestCurls : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theCurlSizeMapScalesTheRadius_data();
    void theCurlSizeMapScalesTheRadius();
    void turnsAndRadiusFollowTheCurlMap_data();
    void turnsAndRadiusFollowTheCurlMap();
};

void TestCurls::theCurlSizeMapScalesTheRadius_data()
{
    QTest::addColumn<int>("texel");
    QTest::addColumn<float>("radiusM");
    QTest::newRow("nothing") << 0 << 0.0F;
    QTest::newRow("a quarter") << 16384 << 0.004F;
    QTest::newRow("the default is exactly half") << 32768 << 0.008F;
    QTest::newRow("the greatest") << 65535 << 0.016F;
}

void TestCurls::theCurlSizeMapScalesTheRadius()
{
    QFETCH(int, texel);
    QFETCH(float, radiusM);
    GroomInput::Group group = smallGroup();
    group.settings.greatestCurlRadiusM = 0.016F;
    group.maps[MapSlot::Curl] = uniformMap(0.6F);
    group.maps[MapSlot::CurlSize] =
        std::make_shared<const TiledRaster>(512, 1, Texel{static_cast<std::uint16_t>(texel)});
    const auto groom = groomOf(inputOf(patch(), group));
    forEachHair(*groom, [&](std::uint32_t, const StrandStyle& style) {
        if (texel == 32768)
            QVERIFY(style.curlRadiusM == radiusM); // Bit for bit: files without the map keep their hair.
        QVERIFY(std::abs(style.curlRadiusM - radiusM) < 1e-7F);
    });
}

void TestCurls::turnsAndRadiusFollowTheCurlMap_data()
{
    QTest::addColumn<float>("curl");
    QTest::addColumn<bool>("perLength");
    QTest::addColumn<float>("turns");
    QTest::addColumn<float>("radiusM");
    QTest::newRow("straight") << 0.0F << false << 0.0F << 0.0F;
    QTest::newRow("level 3") << 0.6F << false << 4.0F << 0.006F;
    QTest::newRow("level 5") << 1.0F << false << 16.0F << 0.006F;
    QTest::newRow("a quarter turn is half as wide") << 0.1F << false << 0.25F << 0.003F;
    QTest::newRow("level 3 for every 10 cm of 20") << 0.6F << true << 8.0F << 0.006F;
    QTest::newRow("no wider than the turns are apart") << 1.0F << true << 32.0F << 0.2F / 32.0F;
}

void TestCurls::turnsAndRadiusFollowTheCurlMap()
{
    QFETCH(float, curl);
    QFETCH(bool, perLength);
    QFETCH(float, turns);
    QFETCH(float, radiusM);
    GroomInput::Group group = smallGroup();
    group.settings.greatestLengthM = 0.4F;
    group.settings.turnsMode = perLength ? TurnsMode::PerLength : TurnsMode::PerHair;
    group.settings.turnsPerLengthM = 0.1F;
    group.settings.greatestCurlRadiusM = perLength && curl == 1.0F ? 0.05F : 0.012F;
    group.maps[MapSlot::Curl] = uniformMap(curl);
    const auto groom = groomOf(inputOf(patch(), group));
    std::set<float> phases;
    forEachHair(*groom, [&](std::uint32_t, const StrandStyle& style) {
        QVERIFY(std::abs(style.turns - turns) < 2e-3F);
        QVERIFY(std::abs(style.curlRadiusM - radiusM) < 1e-5F);
        phases.insert(style.phase);
    });
    QVERIFY(phases.size() > 15000);
}

HAIRPAINT_TEST(TestCurls, None)
#include "test_curls.moc"
