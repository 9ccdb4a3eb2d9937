// The Weather overlay in the real window: what its keys change is kept after a pause as one step, or undone whole.
#include "model/document/scene_commands.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"
#include "view/dialogs/light_dialog.h"
#include "view/head_area/weather_overlay.h"

#include <QLabel>

#include <algorithm>

namespace hairpaint::app {

class TestWindowWeather : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    [[nodiscard]] const model::Project& shown() { return session().document().project(); }
    [[nodiscard]] const model::Project& kept() { return session().document().committed(); }

    /// As its timer would.
    static void endPause(view::WeatherOverlay& overlay)
    {
        overlay.settle();
        QCoreApplication::processEvents();
    }

    view::WeatherOverlay& openWeather()
    {
        key(Qt::Key_F7);
        auto* overlay = m_window->findChild<view::WeatherOverlay*>();
        Q_ASSERT(overlay != nullptr);
        return *overlay;
    }

    /// With a wind of 2 m/s and a light that can go up and down.
    static model::Project breezyProject()
    {
        model::Project project = model::newProject();
        project.wind.enabled = true;
        project.wind.velocity = {2.0F, 0.0F, 0.0F};
        project.light.red = project.light.green = project.light.blue = 0.5F;
        return project;
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void aKeysChangeIsKeptByWhateverComesNext_data()
    {
        QTest::addColumn<bool>("hovers");
        QTest::newRow("painting in the paint area") << false;
        QTest::newRow("pointing at a style") << true;
    }
    void aKeysChangeIsKeptByWhateverComesNext()
    {
        QFETCH(bool, hovers);
        openWindow(breezyProject());
        view::WeatherOverlay& overlay = openWeather();
        QVERIFY(overlay.handleKey(Qt::Key_PageUp, {}));
        QVERIFY(session().document().previewing());
        if (hovers) {
            model::EditSession look;
            session().document().show(look, {.policy = model::EditPolicy::Drop},
                                      {.aspect = model::Change::Aspect::GroupList},
                                      [](model::Project& project) { project.groups.front().visible = false; });
        } else {
            drag(m_window->paintView(), paintPoint(0.45F, 0.5F), paintPoint(0.55F, 0.5F));
        }
        QVERIFY(std::abs(glm::length(kept().wind.velocity) - 2.5F) < 1e-4F);
        QCOMPARE(stack().count(), hovers ? 1 : 2);
        overlay.settle(); // The pause that was still running ends nothing and adds nothing.
        QCOMPARE(stack().count(), hovers ? 1 : 2);
    }

    void aKeysChangeIsOneStepAfterAPause_data()
    {
        QTest::addColumn<int>("pressed");
        QTest::addColumn<float>("windMs");
        QTest::addColumn<float>("green");
        QTest::newRow("stronger wind") << int(Qt::Key_PageUp) << 2.5F << 0.5F;
        QTest::newRow("weaker wind") << int(Qt::Key_PageDown) << 1.5F << 0.5F;
        QTest::newRow("more green light") << int(Qt::Key_G) << 2.0F << 0.55F;
    }
    void aKeysChangeIsOneStepAfterAPause()
    {
        QFETCH(int, pressed);
        QFETCH(float, windMs);
        QFETCH(float, green);
        openWindow(breezyProject());
        const QByteArray before = savedBytes("weather-before.hairpaint");
        const auto isAsWanted = [&] {
            return std::abs(glm::length(kept().wind.velocity) - windMs) < 1e-4F &&
                   std::abs(kept().light.green - green) < 1e-4F;
        };
        view::WeatherOverlay& overlay = openWeather();
        QVERIFY(overlay.isVisible());
        overlay.setPause(1);
        QTest::keyClick(&overlay, static_cast<Qt::Key>(pressed));
        QTRY_COMPARE_WITH_TIMEOUT(stack().count(), 1, kPatienceMs);
        QVERIFY(isAsWanted());
        QVERIFY(!session().document().previewing());
        const QByteArray after = savedBytes("weather-after.hairpaint");
        QTest::keyClick(&overlay, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(stack().index(), 0);
        QVERIFY(savedBytes("weather-undone.hairpaint") == before);
        QTest::keyClick(&overlay, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(isAsWanted());
        QVERIFY(savedBytes("weather-redone.hairpaint") == after);
        QVERIFY(!overlay.pausing()); // Nothing else comes.
        QCOMPARE(stack().count(), 1);
        QVERIFY(isAsWanted());
    }

    void theLightsDialogFollowsTheKeys()
    {
        openWindow(breezyProject());
        m_window->actions().find(QLatin1StringView("hair.lightDialog"))->trigger();
        auto* dialog = m_window->findChild<view::LightDialog*>();
        const auto says = [dialog](const QString& text) {
            const auto labels = dialog->findChildren<QLabel*>();
            return std::ranges::any_of(labels, [&text](const QLabel* label) { return label->text() == text; });
        };
        QVERIFY(says(QStringLiteral("R 50  G 50  B 50 %")));
        view::WeatherOverlay& overlay = openWeather();
        for (const Qt::Key pressed : {Qt::Key_R, Qt::Key_R, Qt::Key_G})
            QTest::keyClick(&overlay, pressed);
        QTest::keyClick(&overlay, Qt::Key_B, Qt::ShiftModifier);
        QVERIFY(says(QStringLiteral("R 60  G 55  B 45 %")));
        QTest::keyClick(&overlay, Qt::Key_Escape);
        QCOMPARE(stack().count(), 1);
        QVERIFY(says(QStringLiteral("R 60  G 55  B 45 %")));
        stack().undo();
        QVERIFY(says(QStringLiteral("R 50  G 50  B 50 %")));
    }

    void windAndLightAreAStepEachAndNeitherIsLost()
    {
        openWindow(breezyProject());
        view::WeatherOverlay& overlay = openWeather();
        QTest::keyClick(&overlay, Qt::Key_PageUp);
        QTest::keyClick(&overlay, Qt::Key_R);
        QVERIFY(std::abs(glm::length(shown().wind.velocity) - 2.5F) < 1e-4F);
        QVERIFY(std::abs(shown().light.red - 0.55F) < 1e-4F);
        QTest::keyClick(&overlay, Qt::Key_Escape);
        QCOMPARE(stack().count(), 2);
        QVERIFY(std::abs(glm::length(kept().wind.velocity) - 2.5F) < 1e-4F);
        QVERIFY(std::abs(kept().light.red - 0.55F) < 1e-4F);
    }

    void undoTakesBackWhatIsNotKeptYetAndNothingElse_data()
    {
        QTest::addColumn<int>("pressed");
        QTest::addColumn<bool>("stepBefore");
        QTest::newRow("wind on a fresh project") << int(Qt::Key_PageUp) << false;
        QTest::newRow("light on a fresh project") << int(Qt::Key_B) << false;
        QTest::newRow("wind after another step") << int(Qt::Key_PageUp) << true;
        QTest::newRow("light after another step") << int(Qt::Key_B) << true;
    }
    void undoTakesBackWhatIsNotKeptYetAndNothingElse()
    {
        QFETCH(int, pressed);
        QFETCH(bool, stepBefore);
        openWindow(breezyProject());
        if (stepBefore)
            session().document().push(model::setBackgroundCommand(session().document(), 0xFF123456));
        const int steps = stepBefore ? 1 : 0;
        const QByteArray before = savedBytes("weather-before.hairpaint");
        view::WeatherOverlay& overlay = openWeather();
        overlay.setPause(kPatienceMs); // Not over before the undo, however busy the machine is.
        QTest::keyClick(&overlay, static_cast<Qt::Key>(pressed));
        QTest::keyClick(&overlay, Qt::Key_Z, Qt::ControlModifier);
        for (const bool pauseIsOver : {false, true}) {
            if (pauseIsOver)
                endPause(overlay);
            QCOMPARE(stack().index(), steps);
            QVERIFY(!session().document().previewing());
            QVERIFY(savedBytes("weather-after.hairpaint") == before);
        }
        // The next key starts from there.
        QTest::keyClick(&overlay, Qt::Key_PageUp);
        QTest::keyClick(&overlay, Qt::Key_Escape);
        QVERIFY(std::abs(glm::length(kept().wind.velocity) - 2.5F) < 1e-4F);
    }

    void aSkinToneIsChosenFromTheMenuAndUndone()
    {
        openWindow(app::starterProject());
        session().setPaused(true);
        const QImage clay = picture();
        const auto actionOf = [this](const char* id) { return m_window->actions().find(QLatin1StringView(id)); };
        QAction* brown = actionOf("hair.skin.brown");
        QVERIFY(brown != nullptr && actionOf("hair.skin.clay")->isChecked());
        brown->trigger();
        QVERIFY(kept().skin == model::SkinTone::Brown);
        QVERIFY(brown->isChecked() && !actionOf("hair.skin.clay")->isChecked());
        QCOMPARE(stack().count(), 1);
        QVERIFY(difference(clay, picture()) > 0.03);
        brown->trigger(); // Again: no step more.
        QCOMPARE(stack().count(), 1);
        actionOf("edit.undo")->trigger();
        QVERIFY(kept().skin == model::SkinTone::Clay);
        QVERIFY(difference(clay, picture()) < 0.001);
    }

    void goingElsewhereKeepsTheChange()
    {
        openWindow(breezyProject());
        view::WeatherOverlay& overlay = openWeather();
        QTest::keyClick(&overlay, Qt::Key_PageUp);
        m_window->paintView().setFocus();
        QCOMPARE(stack().count(), 1);
        QVERIFY(std::abs(glm::length(kept().wind.velocity) - 2.5F) < 1e-4F);
    }

    void aStrokeRightAfterAKeyKeepsBoth()
    {
        openWindow(breezyProject());
        (void)openWeather();
        view::HeadView& area = m_window->headView();
        area.setFocus();
        QTest::keyClick(&area, Qt::Key_PageUp);
        const QPoint forehead = area.rect().center() - QPoint(0, area.height() / 4);
        drag(area, forehead, forehead + QPoint(20, 0));
        QCOMPARE(stack().count(), 2);
        QVERIFY(std::abs(glm::length(kept().wind.velocity) - 2.5F) < 1e-4F);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowWeather, Widgets)
#include "test_window_weather.moc"
