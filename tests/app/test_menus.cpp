// The menus of the real window: what is on is seen to be on.
#include "app/main_window.h"
#include "model/files/project_file.h"
#include "view/head_view.h"
#include "view/paint_view.h"
#include "view/resources.h"

#include <QSettings>
#include <QStandardPaths>
#include <QtTest>

namespace hairpaint::app {

class TestMenus : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<MainWindow> m_window;

    [[nodiscard]] bool checked(const char* id) { return m_window->actions().find(QLatin1StringView(id))->isChecked(); }
    void trigger(const char* id) { m_window->actions().find(QLatin1StringView(id))->trigger(); }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
        view::initResources();
        m_window = std::make_unique<MainWindow>(model::newProject(), QString());
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanupTestCase() { m_window.reset(); }

    void whatCanBeOnShowsATickAndNoIcon()
    {
        int switches = 0;
        for (const view::KeyBinding& binding : m_window->actions().bindings()) {
            QCOMPARE(binding.action->isIconVisibleInMenu(), !binding.action->isCheckable());
            switches += binding.action->isCheckable() ? 1 : 0;
        }
        QVERIFY(switches > 8);
    }

    void theAreasShownAreTicked()
    {
        QVERIFY(checked("view.both"));
        trigger("view.head");
        QVERIFY(checked("view.head") && !checked("view.both") && !checked("view.paint"));
        QVERIFY(m_window->headView().isVisible() && !m_window->paintView().isVisible());
        trigger("view.head");
        QVERIFY(checked("view.head"));
        trigger("view.paint");
        QVERIFY(checked("view.paint") && !checked("view.head"));
        QVERIFY(!m_window->headView().isVisible() && m_window->paintView().isVisible());
        trigger("view.both");
        QVERIFY(checked("view.both") && !checked("view.paint"));
    }

    void theThemeInUseIsTicked()
    {
        QVERIFY(checked("view.dark") && !checked("view.light"));
        trigger("view.light");
        QVERIFY(checked("view.light") && !checked("view.dark"));
        QCOMPARE(view::Theme::current().kind, view::ThemeKind::Light);
        trigger("view.dark");
        QVERIFY(checked("view.dark") && !checked("view.light"));
    }
};

} // namespace hairpaint::app

QTEST_MAIN(hairpaint::app::TestMenus)
#include "test_menus.moc"
