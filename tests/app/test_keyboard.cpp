// The real window without a mouse: from area to area, round within one, and what Enter and Esc do there.
#include "app/window/main_window.h"
#include "model/files/project_file.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/head_area/head_view.h"
#include "view/look/resources.h"
#include "view/look/theme.h"
#include "view/paint_area/paint_view.h"
#include "view/panels/option_bar.h"
#include "view/panels/sidebar.h"
#include "view/panels/style_strip.h"
#include "view/panels/style_tile.h"
#include "view/panels/tool_bar.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/focus_ring.h"

#include <QStandardPaths>
#include <QUndoStack>
#include <QtTest>

#include <algorithm>
#include <memory>
#include <vector>

namespace hairpaint::app {

class TestKeyboard : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<MainWindow> m_window;

    [[nodiscard]] bool checked(const char* id) { return m_window->actions().find(QLatin1StringView(id))->isChecked(); }
    void trigger(const char* id) { m_window->actions().find(QLatin1StringView(id))->trigger(); }
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    static bool isIn(const QWidget& area)
    {
        const QWidget* focus = QApplication::focusWidget();
        return focus == &area || area.isAncestorOf(focus);
    }
    static QString focusName()
    {
        const QWidget* focus = QApplication::focusWidget();
        return focus == nullptr ? QStringLiteral("none")
                                : QStringLiteral("%1 %2").arg(QLatin1StringView(focus->metaObject()->className()),
                                                              focus->accessibleName());
    }
    /// In the order in which F6 goes through them.
    [[nodiscard]] std::vector<QWidget*> keyboardAreas() const
    {
        const MainWindow& window = *m_window;
        return {window.findChild<view::OptionBar*>(), window.findChild<view::ToolBar*>(),
                window.findChild<view::PaintView*>(), window.findChild<view::HeadView*>(),
                window.findChild<view::MapsPanel*>(), window.findChild<view::LayersPanel*>(),
                window.findChild<view::HairPanel*>(), window.findChild<view::StyleStrip*>()};
    }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        SettingsStore().clear();
        view::initResources();
        m_window = std::make_unique<MainWindow>(model::newProject());
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        const auto* strip = m_window->findChild<view::StyleStrip*>();
        const auto shown = [strip] {
            const QList<view::StyleTile*> tiles = strip->findChildren<view::StyleTile*>();
            return tiles.size() > 3 && std::ranges::all_of(tiles, &QWidget::isVisible);
        };
        QTRY_VERIFY_WITH_TIMEOUT(shown(), test::kPatienceMs);
    }
    void cleanupTestCase() { m_window.reset(); }

    void f11HidesThePanels()
    {
        const auto* panel = m_window->findChild<view::ToolBar*>();
        press(Qt::Key_F11);
        QVERIFY(!panel->isVisible() && checked("view.panels"));
        press(Qt::Key_F11);
        QVERIFY(panel->isVisible() && !checked("view.panels"));
    }

    void f6GoesFromAreaToAreaAndShiftBack()
    {
        const std::vector<QWidget*> areas = keyboardAreas();
        m_window->paintView().setFocus();
        const auto start = std::ranges::find(areas, static_cast<QWidget*>(&m_window->paintView())) - areas.begin();
        for (std::size_t i = 1; i <= areas.size(); ++i) {
            press(Qt::Key_F6);
            QVERIFY2(isIn(*areas[(static_cast<std::size_t>(start) + i) % areas.size()]), qPrintable(focusName()));
        }
        for (std::size_t i = 1; i <= areas.size(); ++i) {
            press(Qt::Key_F6, Qt::ShiftModifier);
            QVERIFY2(isIn(*areas[(static_cast<std::size_t>(start) + areas.size() - i) % areas.size()]),
                     qPrintable(focusName()));
        }
        // It comes back to where it was in an area, and leaves out what is hidden.
        auto* strip = m_window->findChild<view::StyleStrip*>();
        press(Qt::Key_F6);
        QVERIFY(isIn(m_window->headView()));
        trigger("view.panels");
        press(Qt::Key_F6);
        QVERIFY(isIn(m_window->paintView()));
        trigger("view.panels");
        for (const QWidget* area : {keyboardAreas()[1], keyboardAreas()[0], keyboardAreas()[7]}) {
            press(Qt::Key_F6, Qt::ShiftModifier);
            QVERIFY2(isIn(*area), qPrintable(focusName()));
        }
        press(Qt::Key_Right);
        QVERIFY2(isIn(*strip), qPrintable(focusName()));
        press(Qt::Key_Right);
        QVERIFY2(isIn(*strip), qPrintable(focusName()));
        const QWidget* third = QApplication::focusWidget();
        press(Qt::Key_F6);
        press(Qt::Key_F6, Qt::ShiftModifier);
        QCOMPARE(QApplication::focusWidget(), third);
    }

    void tabGoesRoundWithinAPanel()
    {
        int panels = 0;
        for (QWidget* area : keyboardAreas()) {
            m_window->paintView().setFocus();
            for (int i = 0; i < 20 && !isIn(*area); ++i)
                press(Qt::Key_F6);
            QWidget* first = QApplication::focusWidget();
            press(Qt::Key_Tab);
            if (!isIn(*area))
                continue; // It is a single stop, as a list or buttons that exclude each other are.
            press(Qt::Key_Backtab, Qt::ShiftModifier);
            QCOMPARE(QApplication::focusWidget(), first);
            ++panels;
            int stops = 0;
            do {
                press(Qt::Key_Tab);
                QVERIFY2(isIn(*area), qPrintable(focusName()));
                QVERIFY(++stops < 200);
            } while (QApplication::focusWidget() != first);
            QVERIFY(stops > 1);
        }
        QVERIFY(panels >= 4);
    }

    void tabInAnAreaGoesOnToTheNext()
    {
        m_window->paintView().setFocus();
        press(Qt::Key_Tab);
        QVERIFY(isIn(m_window->headView()));
        press(Qt::Key_Backtab, Qt::ShiftModifier);
        QVERIFY(isIn(m_window->paintView()));
        QVERIFY(m_window->findChild<view::ToolBar*>()->isVisible());
    }

    void theAreaThatAKeyChoseIsFramedUntilTheMouseTakesOver()
    {
        m_window->paintView().setFocus(Qt::OtherFocusReason);
        press(Qt::Key_F6);
        auto* ofHead = m_window->headView().findChild<view::FocusRing*>();
        const auto* ofPaint = m_window->paintView().findChild<view::FocusRing*>();
        QVERIFY(ofHead->isVisible() && !ofPaint->isVisible());
        QCOMPARE(ofHead->grab().toImage().pixelColor(0, 50), view::Theme::current().accent);
        QTest::mouseClick(&m_window->headView(), Qt::LeftButton, {}, QPoint(5, 5));
        QVERIFY(!ofHead->isVisible());
    }

    void enterPicksWhatHasTheFocus()
    {
        view::EditorState& editor = m_window->session().editor();
        const auto reach = [this](const QWidget& area) {
            for (int i = 0; i < 20 && !isIn(area); ++i)
                press(Qt::Key_F6);
        };
        reach(*m_window->findChild<view::ToolBar*>());
        const auto before = editor.tools().active().id();
        press(Qt::Key_Down);
        press(Qt::Key_Return);
        QVERIFY(editor.tools().active().id() != before);
        reach(*m_window->findChild<view::MapsPanel*>());
        const model::MapKind map = editor.target().map();
        press(Qt::Key_Down);
        QVERIFY(editor.target().map() != map);
        press(Qt::Key_Up);
        QCOMPARE(editor.target().map(), map);
        editor.tools().choose(before);
    }

    void aNumberIsTypedWhereTheKeysAre()
    {
        view::EditorState& editor = m_window->session().editor();
        editor.target().setMap(model::MapKind::Length);
        m_window->paintView().setFocus();
        while (!isIn(*m_window->findChild<view::OptionBar*>()))
            press(Qt::Key_F6);
        auto* slider = qobject_cast<view::BarSlider*>(QApplication::focusWidget());
        QVERIFY(slider != nullptr);
        press(Qt::Key_F2);
        QVERIFY(m_window->paintView().isVisible()); // It is no key of the window's here.
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("7"));
        press(Qt::Key_Return);
        QCOMPARE(slider->value(), 7.0);
        QCOMPARE(QApplication::focusWidget(), slider);
        press(Qt::Key_6);
        QCOMPARE(editor.target().map(), model::MapKind::Length);
        press(Qt::Key_Return);
        QCOMPARE(slider->value(), 6.0);
        // The mouse's user goes on with the map's keys.
        m_window->paintView().setFocus();
        slider->setFocus(Qt::MouseFocusReason);
        press(Qt::Key_6);
        QCOMPARE(editor.target().map(), model::MapKind::Colour);
        editor.target().setMap(model::MapKind::Length);
    }

    void escGoesFromAPanelToTheMap()
    {
        m_window->paintView().setFocus();
        for (int i = 0; i < 3; ++i)
            press(Qt::Key_F6);
        QVERIFY(!isIn(m_window->paintView()));
        press(Qt::Key_Escape);
        QVERIFY(isIn(m_window->paintView()));
    }

    void ctrlYRedoes()
    {
        model::Document& document = m_window->session().document();
        trigger("hair.face");
        const std::vector<model::HairGroup> after = document.committed().groups;
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(document.committed().groups != after);
        press(Qt::Key_Y, Qt::ControlModifier);
        QVERIFY(document.committed().groups == after);
        document.undo();
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestKeyboard, Widgets)
#include "test_keyboard.moc"
