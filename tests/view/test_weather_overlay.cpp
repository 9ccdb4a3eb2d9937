// The paper's keys: arrows and Page Up and Down for the wind, R, G and B for the light.
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/support/view_fixture.h"
#include "view/head_area/head_view.h"
#include "view/head_area/weather_overlay.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace hairpaint;

namespace {

struct Fixture
{
    Fixture() : overlay(view::Theme::of(view::ThemeKind::Dark), nullptr)
    {
        QObject::connect(&overlay, &view::WeatherOverlay::windWanted, &overlay, [this](const sim::Wind& w, bool done) {
            wind = w;
            (done ? windDone : windShown) += 1;
        });
        QObject::connect(&overlay, &view::WeatherOverlay::lightWanted, &overlay,
                         [this](const model::LightSettings& l, bool done) {
                             light = l;
                             (done ? lightDone : lightShown) += 1;
                         });
        sim::Wind start;
        start.velocity = {2.0F, 0.0F, 0.0F};
        model::LightSettings half;
        half.red = half.green = half.blue = 0.5F;
        overlay.setValues(start, half);
        overlay.show();
    }

    view::WeatherOverlay overlay;
    sim::Wind wind;
    model::LightSettings light;
    int windShown = 0, windDone = 0, lightShown = 0, lightDone = 0;
};

} // namespace

class WeatherOverlayTest : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void arrowsTurnTheWindAndKeepItsStrength_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<float>("x");
        QTest::addColumn<float>("y");
        QTest::addColumn<float>("z");
        const float side = 2.0F * std::cos(0.2617994F);
        const float along = 2.0F * std::sin(0.2617994F);
        QTest::newRow("right") << int(Qt::Key_Right) << side << 0.0F << -along;
        QTest::newRow("left") << int(Qt::Key_Left) << side << 0.0F << along;
        QTest::newRow("up") << int(Qt::Key_Up) << side << along << 0.0F;
        QTest::newRow("down") << int(Qt::Key_Down) << side << -along << 0.0F;
    }
    void arrowsTurnTheWindAndKeepItsStrength()
    {
        QFETCH(int, key);
        QFETCH(float, x);
        QFETCH(float, y);
        QFETCH(float, z);
        Fixture f;
        QTest::keyClick(&f.overlay, Qt::Key(key));
        QCOMPARE(f.windShown, 1);
        QVERIFY(glm::length(f.wind.velocity - glm::vec3(x, y, z)) < 1e-4F);
    }

    void pageUpStrengthensAndPageDownWeakens()
    {
        Fixture f;
        QTest::keyClick(&f.overlay, Qt::Key_PageUp);
        QVERIFY(std::abs(glm::length(f.wind.velocity) - 2.5F) < 1e-4F);
        for (int i = 0; i < 8; ++i)
            QTest::keyClick(&f.overlay, Qt::Key_PageDown);
        QVERIFY(glm::length(f.wind.velocity) < 1e-6F);
        // The direction is kept while there is no wind.
        QTest::keyClick(&f.overlay, Qt::Key_PageUp);
        QVERIFY(f.wind.velocity.x > 0.49F);
    }

    void lettersTintTheLight_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<bool>("lower");
        QTest::addColumn<int>("channel");
        QTest::newRow("more red") << int(Qt::Key_R) << false << 0;
        QTest::newRow("less red") << int(Qt::Key_R) << true << 0;
        QTest::newRow("more green") << int(Qt::Key_G) << false << 1;
        QTest::newRow("less blue") << int(Qt::Key_B) << true << 2;
    }
    void lettersTintTheLight()
    {
        QFETCH(int, key);
        QFETCH(bool, lower);
        QFETCH(int, channel);
        Fixture f;
        QTest::keyClick(&f.overlay, Qt::Key(key), lower ? Qt::ShiftModifier : Qt::NoModifier);
        const glm::vec3 colour(f.light.red, f.light.green, f.light.blue);
        for (int i = 0; i < 3; ++i) {
            const float expected = i != channel ? 0.5F : lower ? 0.45F : 0.55F;
            QVERIFY(std::abs(colour[i] - expected) < 1e-5F);
        }
    }

    void keysInARowAreOneStepWhenLeft()
    {
        Fixture f;
        QSignalSpy leave(&f.overlay, &view::WeatherOverlay::leaveWanted);
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(&f.overlay, Qt::Key_PageUp);
        QCOMPARE(f.windDone, 0);
        QTest::keyClick(&f.overlay, Qt::Key_R);
        QCOMPARE(f.windDone, 1); // Before the light's step begins.
        QCOMPARE(f.lightDone, 0);
        QTest::keyClick(&f.overlay, Qt::Key_Escape);
        QCOMPARE(leave.count(), 1);
        QCOMPARE(f.windDone, 1);
        QCOMPARE(f.lightDone, 1);
        QVERIFY(std::abs(glm::length(f.wind.velocity) - 4.0F) < 1e-4F);
    }

    void othersValuesEndTheChange()
    {
        Fixture f;
        const sim::Wind before = f.wind;
        QTest::keyClick(&f.overlay, Qt::Key_PageUp);
        f.overlay.setValues(f.wind, f.light); // Our own, come back.
        f.overlay.setValues(before, f.light);
        QTest::keyClick(&f.overlay, Qt::Key_Escape);
        QCOMPARE(f.windDone, 0);
    }

    void aPauseEndsTheStep()
    {
        Fixture f;
        f.overlay.setPause(1);
        QTest::keyClick(&f.overlay, Qt::Key_PageUp);
        QTRY_COMPARE_WITH_TIMEOUT(f.windDone, 1, test::kPatienceMs);
        QVERIFY(!f.overlay.pausing());
        QTest::keyClick(&f.overlay, Qt::Key_Escape);
        QCOMPARE(f.windDone, 1);
    }

    void inTheHeadAreaItOpensTakesKeysAndLeaves()
    {
        test::Editor editor(test::makeProject(test::makeBallHead()));
        view::HeadView area(editor.state, view::Theme::of(view::ThemeKind::Dark), view::PresenterChoice::Software);
        area.resize(480, 400);
        area.show();
        int winds = 0;
        connect(&area, &view::HeadView::windWanted, &area, [&winds] { ++winds; });
        QTest::keyClick(&area, Qt::Key_PageUp);
        QCOMPARE(winds, 0);
        area.setWeatherShown(true);
        QVERIFY(area.weatherShown());
        QTest::keyClick(&area, Qt::Key_PageUp);
        QCOMPARE(winds, 1);
        QTest::keyClick(&area, Qt::Key_Escape);
        QVERIFY(!area.weatherShown());
        QCOMPARE(winds, 2); // The preview and the step.
    }
};

HAIRPAINT_TEST(WeatherOverlayTest, Widgets)
#include "test_weather_overlay.moc"
