// Dialogs open beside the head, inside the screen, and where the user left them.
#include "app/settings/dialog_positions.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"
#include "view/dialogs/light_dialog.h"
#include "view/dialogs/wind_dialog.h"

#include <QScreen>

namespace hairpaint::app {

class TestDialogPositions : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    template<typename Dialog>
    Dialog* shown(const char* action)
    {
        m_window->actions().find(QLatin1StringView(action))->trigger();
        auto* dialog = m_window->findChild<Dialog*>();
        return dialog != nullptr && QTest::qWaitForWindowExposed(dialog) ? dialog : nullptr;
    }
    [[nodiscard]] QRect headArea()
    {
        const view::HeadView& head = m_window->headView();
        return {head.mapToGlobal(QPoint(0, 0)), head.size()};
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void theHeadStaysSeen_data()
    {
        QTest::addColumn<QRect>("screen");
        QTest::addColumn<QRect>("window");
        QTest::addColumn<QRect>("head");
        QTest::addColumn<QSize>("dialog");
        QTest::addColumn<double>("mostHidden"); // The greatest fraction of the 3D area that may be hidden.
        const QRect large(0, 0, 1920, 1080);
        const QRect small(0, 0, 960, 600);
        const QSize light(420, 520);
        QTest::newRow("paint area on the left")
            << large << QRect(200, 60, 1440, 900) << QRect(780, 124, 580, 650) << light << 0.0;
        QTest::newRow("paint area on the right")
            << large << QRect(200, 60, 1440, 900) << QRect(244, 124, 580, 650) << light << 0.0;
        QTest::newRow("no paint area") << large << QRect(0, 0, 1440, 900) << QRect(44, 64, 1110, 680) << light << 0.0;
        QTest::newRow("no paint area, full screen") << large << large << QRect(44, 64, 1590, 860) << light << 0.13;
        QTest::newRow("a small screen") << small << QRect(0, 0, 1100, 680) << QRect(440, 64, 380, 430) << light << 0.1;
        QTest::newRow("wide, on a small screen")
            << small << QRect(0, 0, 960, 600) << QRect(350, 64, 330, 380) << QSize(608, 391) << 0.55;
        QTest::newRow("larger than the screen")
            << small << QRect(0, 0, 1100, 680) << QRect(440, 64, 380, 430) << QSize(500, 700) << 0.2;
        QTest::newRow("no 3D area") << large << QRect(0, 0, 1440, 900) << QRect() << light << 0.0;
    }
    void theHeadStaysSeen()
    {
        QFETCH(QRect, screen);
        QFETCH(QRect, window);
        QFETCH(QRect, head);
        QFETCH(QSize, dialog);
        QFETCH(double, mostHidden);
        const QPoint at = positionBesideHead(dialog, {.window = window, .head = head, .screen = screen});
        const QRect inside = QRect(at, dialog) & screen;
        QCOMPARE(inside.topLeft(), at); // Its title can be reached.
        QCOMPARE(inside.size(), dialog.boundedTo(screen.size()));
        const QRect hidden = QRect(at, dialog) & head;
        const double area = hidden.isEmpty() ? 0.0 : 1.0 * hidden.width() * hidden.height();
        QVERIFY2(area <= mostHidden * head.width() * head.height(), qPrintable(QString::number(area)));
    }

    void aPositionOnAScreenThatIsGoneIsTakenBackInside_data()
    {
        QTest::addColumn<QPoint>("wanted");
        QTest::addColumn<QPoint>("at");
        QTest::newRow("inside") << QPoint(100, 80) << QPoint(100, 80);
        QTest::newRow("right of it") << QPoint(2500, 80) << QPoint(560, 80);
        QTest::newRow("left of it") << QPoint(-900, 80) << QPoint(0, 80);
        QTest::newRow("below it") << QPoint(100, 1200) << QPoint(100, 300);
        QTest::newRow("above it") << QPoint(100, -400) << QPoint(100, 0);
    }
    void aPositionOnAScreenThatIsGoneIsTakenBackInside()
    {
        QFETCH(QPoint, wanted);
        QFETCH(QPoint, at);
        QCOMPARE(insideScreen(wanted, {400, 300}, {0, 0, 960, 600}), at);
    }

    void aDialogStaysInsideTheScreenAlsoWhereItGrows()
    {
        openWindow(test::smallProject());
        const QRect screen = m_window->screen()->availableGeometry();
        QDialog dialog(m_window.get());
        dialog.resize(4000, 3000);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QVERIFY(screen.contains(dialog.geometry()));
        dialog.resize(200, 200);
        dialog.move(screen.bottomRight() - QPoint(240, 240));
        dialog.resize(300, 400); // As one does that shows more rows.
        QVERIFY(screen.contains(dialog.geometry()));
    }

    void aDialogOpensBesideTheHeadAndWhereItWasLeft()
    {
        openWindow(test::smallProject());
        m_window->move(0, 0);
        auto* light = shown<view::LightDialog>("hair.lightDialog");
        QVERIFY(light != nullptr);
        const QRect covered = light->geometry() & headArea();
        QVERIFY2(covered.isEmpty() || covered.width() * 4 < headArea().width(),
                 qPrintable(QString::number(covered.width())));
        const QPoint first = light->pos();
        QVERIFY(m_window->screen()->availableGeometry().contains(first));

        // Closed where it opened, it leaves the choice to the program.
        light->close();
        QVERIFY(!Settings().dialogPosition(QStringLiteral("hairpaint::view::LightDialog")));
        QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<view::LightDialog*>() == nullptr, kPatienceMs);
        light = shown<view::LightDialog>("hair.lightDialog");
        QCOMPARE(light->pos(), first);
        const QPoint wanted(first.x() / 2, first.y() + 90);
        light->move(wanted);
        light->close();
        QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<view::LightDialog*>() == nullptr, kPatienceMs);
        QCOMPARE(shown<view::LightDialog>("hair.lightDialog")->pos(), wanted);
        // Each has a position of its own.
        QVERIFY(shown<view::WindDialog>("hair.windDialog")->pos() != wanted);

        // The next start knows it; what is too far away comes back.
        m_window.reset();
        openWindow(test::smallProject());
        QCOMPARE(shown<view::LightDialog>("hair.lightDialog")->pos(), wanted);
        m_window.reset();
        Settings().setDialogPosition(QStringLiteral("hairpaint::view::LightDialog"), {9000, -5000});
        openWindow(test::smallProject());
        light = shown<view::LightDialog>("hair.lightDialog");
        QVERIFY(m_window->screen()->availableGeometry().contains(light->geometry()));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestDialogPositions, Widgets)
#include "test_dialog_positions.moc"
