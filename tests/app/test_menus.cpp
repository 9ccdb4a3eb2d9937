// The menus of the real window, where what is on is seen to be on, and its panels.
#include "app/library.h"
#include "app/main_window.h"
#include "model/commands/commands.h"
#include "model/files/project_file.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/head_view.h"
#include "view/paint_view.h"
#include "view/panels/option_bar.h"
#include "view/panels/sidebar.h"
#include "view/panels/status_readout.h"
#include "view/panels/style_strip.h"
#include "view/panels/tool_bar.h"
#include "view/resources.h"
#include "view/theme.h"
#include "view/widgets/drop_hint.h"
#include "view/widgets/focus_ring.h"

#include <QDir>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMimeData>
#include <QStandardPaths>
#include <QToolButton>
#include <QtTest>

#include <algorithm>

namespace hairpaint::app {

class TestMenus : public QObject
{
    Q_OBJECT
private:
    std::unique_ptr<MainWindow> m_window;

    [[nodiscard]] bool checked(const char* id) { return m_window->actions().find(QLatin1StringView(id))->isChecked(); }
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
    void trigger(const char* id) { m_window->actions().find(QLatin1StringView(id))->trigger(); }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        SettingsStore().clear();
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

    void browsAndLashesAreASwitch()
    {
        model::Document& document = m_window->session().document();
        const std::vector<model::HairGroup> before = document.committed().groups;
        const int steps = document.undoStack().count();
        QVERIFY(!checked("hair.face"));
        trigger("hair.face");
        QCOMPARE(document.undoStack().count(), steps + 1);
        QCOMPARE(document.committed().groups.size(), before.size() + 2);
        QVERIFY(checked("hair.face"));
        const auto frame = [this] { return m_window->session().frame(); };
        QTRY_VERIFY_WITH_TIMEOUT(frame() && frame()->hairCount > 500, test::kPatienceMs);
        trigger("hair.face"); // They are hidden, and stay.
        QVERIFY(!checked("hair.face"));
        QCOMPARE(document.committed().groups.size(), before.size() + 2);
        trigger("hair.face");
        QVERIFY(checked("hair.face"));
        QCOMPARE(document.undoStack().count(), steps + 3);
        for (int i = 0; i < 3; ++i)
            document.undo();
        QVERIFY(document.committed().groups == before);
        QVERIFY(!document.previewing());
    }

    void theHeadNodsShakesAndTurnsWhileTheHairIsNotPaused()
    {
        int poses = 0;
        const auto counting = connect(&m_window->headView(), &view::HeadView::poseWanted, this, [&] { ++poses; });
        for (const char* id : {"hair.nod", "hair.shake", "hair.turn"}) {
            QAction* action = m_window->actions().find(QLatin1StringView(id));
            QVERIFY(action != nullptr && action->isEnabled() && !action->isCheckable());
            QVERIFY(action->toolTip().size() > action->text().size());
            const int before = poses;
            action->trigger();
            QTRY_VERIFY_WITH_TIMEOUT(poses > before, test::kPatienceMs);
            trigger("hair.pause");
            QVERIFY(!action->isEnabled());
            trigger("hair.pause");
        }
        disconnect(counting);
        QVERIFY(!m_window->session().document().previewing());
        m_window->headView().resetCamera();
    }

    void theCollidersAreASwitchOutsideUndo()
    {
        const int steps = m_window->session().document().undoStack().count();
        QVERIFY(!checked("view.colliders") && !m_window->session().editor().collidersShown());
        trigger("view.colliders");
        QVERIFY(checked("view.colliders") && m_window->session().editor().collidersShown());
        trigger("view.colliders");
        QVERIFY(!checked("view.colliders"));
        QCOMPARE(m_window->session().document().undoStack().count(), steps);
    }

    void aColliderIsRemovedAndAdded()
    {
        model::Document& document = m_window->session().document();
        const std::vector<sim::Ellipsoid> before = document.project().ellipsoids;
        const QAction* add = m_window->actions().find(QLatin1StringView("hair.addCollider"));
        const QAction* remove = m_window->actions().find(QLatin1StringView("hair.removeCollider"));
        QVERIFY(before.size() < model::kMostEllipsoids && add->isEnabled() && !remove->isEnabled());
        trigger("view.colliders");
        m_window->session().editor().setChosenCollider(1);
        QVERIFY(remove->isEnabled());
        trigger("hair.removeCollider");
        QCOMPARE(document.project().ellipsoids.size(), before.size() - 1);
        QVERIFY(add->isEnabled() && !remove->isEnabled());
        trigger("hair.addCollider");
        QCOMPARE(document.project().ellipsoids.size(), before.size());
        QVERIFY(remove->isEnabled());
        std::vector<sim::Ellipsoid> most(model::kMostEllipsoids, before.front());
        document.push(setEllipsoidsCommand(document, most, QStringLiteral("most")));
        QVERIFY(!add->isEnabled());
        document.undo();
        document.undo();
        document.undo();
        QVERIFY(document.project().ellipsoids == before);
        m_window->session().editor().setChosenCollider(std::nullopt);
        trigger("view.colliders");
    }

    void aNameWithAnAmpersandIsReadWhole()
    {
        model::Document& document = m_window->session().document();
        document.push(model::addGroupCommand(document, QStringLiteral("Salt & pepper")));
        const QAction* undo = m_window->actions().find(QLatin1StringView("edit.undo"));
        QVERIFY2(undo->text().contains(QStringLiteral("Salt && pepper")), qPrintable(undo->text()));
        QCOMPARE(undo->text().count(QLatin1Char('&')), 3);
        document.undo();
    }

    /// Not texts as menus have them, nor what an action would do just now.
    void theListOfKeysIsOfPlainWords()
    {
        model::Document& document = m_window->session().document();
        document.push(model::addGroupCommand(document, QStringLiteral("Fringe")));
        QStringList names;
        for (const view::KeyBinding& binding : m_window->actions().bindings()) {
            for (const QString& words : {binding.name, binding.section})
                for (const QChar mark : {QChar(u'&'), QChar(u'\t'), QChar(0x2026)})
                    QVERIFY2(!words.contains(mark), qPrintable(words));
            names.append(binding.name);
        }
        QVERIFY(names.contains(QStringLiteral("Undo")));
        document.undo();
        QVERIFY(names.contains(QStringLiteral("Preferences")));
    }

    void theMapMenuShowsAndChangesTheMapsSize()
    {
        model::Document& document = m_window->session().document();
        const view::EditorState& editor = m_window->session().editor();
        const auto size = [&] {
            return document.committed().group(editor.activeGroup())->map(editor.activeMap()).size;
        };
        auto* menu = m_window->findChild<QMenu*>(QStringLiteral("mapSizeMenu"));
        QVERIFY(menu != nullptr);
        const int before = size();
        Q_EMIT menu->aboutToShow();
        QAction* half = nullptr;
        for (QAction* action : menu->actions()) {
            QCOMPARE(action->isChecked(), action->data().toInt() == before);
            if (action->data().toInt() == before / 2)
                half = action;
        }
        if (half == nullptr)
            QFAIL("half the size is not offered");
        half->trigger();
        QCOMPARE(size(), before / 2);
        document.undo();
        QCOMPARE(size(), before);
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
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
        press(Qt::Key_F6, Qt::ShiftModifier);
        press(Qt::Key_F6, Qt::ShiftModifier);
        QVERIFY(isIn(*strip));
        press(Qt::Key_Right);
        press(Qt::Key_Right);
        const QWidget* third = QApplication::focusWidget();
        QVERIFY(isIn(*strip));
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
        const auto before = editor.activeTool().id();
        press(Qt::Key_Down);
        press(Qt::Key_Return);
        QVERIFY(editor.activeTool().id() != before);
        reach(*m_window->findChild<view::MapsPanel*>());
        const model::MapKind map = editor.activeMap();
        press(Qt::Key_Down);
        QVERIFY(editor.activeMap() != map);
        press(Qt::Key_Up);
        QCOMPARE(editor.activeMap(), map);
        editor.setActiveTool(before);
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

    void bracketsGoByTheirPlaceUntilTheyAreBoundAnew()
    {
        QAction* smaller = m_window->actions().find(QLatin1StringView("tool.smaller"));
        QCOMPARE(smaller->shortcut(), QKeySequence(Qt::Key_BracketLeft));
        const auto size = [this] { return m_window->session().editor().toolSettings().brushSizeM; };
        // Where a German keyboard types an umlaut.
#ifdef Q_OS_WIN
        constexpr quint32 kPlace = 0x1A;
#else
        constexpr quint32 kPlace = 34;
#endif
        const auto press = [this] {
            QKeyEvent event(QEvent::KeyPress, Qt::Key_Udiaeresis, Qt::NoModifier, kPlace, 0, 0);
            QApplication::sendEvent(&m_window->paintView(), &event);
        };
        const float before = size();
        press();
        QVERIFY(size() < before);
        QTest::keyClick(&m_window->paintView(), Qt::Key_BracketRight);
        QVERIFY(std::abs(size() - before) < 1e-6F);
        smaller->setShortcut(QKeySequence(Qt::Key_F12));
        press();
        QTest::keyClick(&m_window->paintView(), Qt::Key_BracketLeft);
        QVERIFY(std::abs(size() - before) < 1e-6F);
        QTest::keyClick(&m_window->paintView(), Qt::Key_F12);
        QVERIFY(size() < before);
        smaller->setShortcut(QKeySequence(Qt::Key_BracketLeft));
    }

    void digitsChooseMapsAndTheMenuTicksTheOneShown()
    {
        trigger("map.curl");
        for (const char* kind : {"map.length", "map.gel", "map.density"}) {
            const QAction* action = m_window->actions().find(QLatin1StringView(kind));
            QVERIFY(!action->isChecked());
            QTest::keyClick(&m_window->paintView(), static_cast<Qt::Key>(action->shortcut()[0].key()));
            QVERIFY(action->isChecked());
            QCOMPARE(QLatin1StringView(kind).mid(4),
                     QLatin1StringView(model::mapSpec(m_window->session().editor().activeMap()).id));
            // A tick that is chosen once more stays.
            m_window->actions().find(QLatin1StringView(kind))->trigger();
            QVERIFY(action->isChecked());
        }
    }

    void mapsPastTheTenthTakeNoKey()
    {
        for (int number = 1; number <= kDigits; ++number)
            QCOMPARE(digitOf(digitKey(number)), number);
        QCOMPARE(usualKey(digitKey(10)), Qt::Key_0);
        for (const int number : {0, 11, 12})
            QVERIFY(digitKey(number) == PhysicalKey::Other);
    }

    void nothingElseHidesThePanels()
    {
        const auto* panel = m_window->findChild<view::ToolBar*>();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_window->headView().setFocus();
        m_window->headView().setWeatherShown(true);
        QVERIFY(QApplication::focusWidget() != nullptr);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!m_window->headView().weatherShown());
        QVERIFY(panel->isVisible());
        m_window->headView().setFocus();
        trigger("view.paint");
        QVERIFY(panel->isVisible());
        trigger("view.both");
    }

    void theSelectToolOffersWhatASelectionIsFor()
    {
        const auto* bar = m_window->findChild<view::OptionBar*>();
        const auto buttonOf = [&](const char* id) -> QToolButton* {
            for (QToolButton* button : bar->findChildren<QToolButton*>())
                if (button->defaultAction() == m_window->actions().find(QLatin1StringView(id)))
                    return button;
            return nullptr;
        };
        for (const char* tool : {"tool.select", "tool.brush"}) {
            trigger(tool);
            for (const char* id : {"edit.all", "edit.none", "edit.invert", "edit.cut", "edit.copy", "edit.paste",
                                   "edit.fill", "edit.clear"}) {
                QVERIFY2(buttonOf(id) != nullptr, id);
                QCOMPARE(buttonOf(id)->isVisible(), tool == QByteArray("tool.select"));
            }
        }
    }

    void aDraggedFileSaysWhatItWillDo_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("text");
        QTest::newRow("project") << QStringLiteral("a.hairpaint") << QStringLiteral("Let go to open the project");
        QTest::newRow("style") << QStringLiteral("a.HAIRPRESET") << QStringLiteral("Let go to apply the style");
        QTest::newRow("head") << QStringLiteral("a b.obj") << QStringLiteral("Let go to import the head");
        QTest::newRow("image") << QStringLiteral("a.tif") << QStringLiteral("Let go to load the image into Curl");
    }
    void aDraggedFileSaysWhatItWillDo()
    {
        QFETCH(QString, file);
        QFETCH(QString, text);
        m_window->session().editor().setActiveMap(model::MapKind::Curl);
        auto* hint = m_window->findChild<view::DropHint*>();
        QVERIFY(!hint->isVisible());
        QMimeData dragged;
        dragged.setUrls({QUrl::fromLocalFile(QDir::temp().filePath(file))});
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QVERIFY(hint->isVisible());
        QCOMPARE(hint->text(), text);
        QCOMPARE(hint->size(), m_window->centralWidget()->size());
        QDragLeaveEvent leave;
        QApplication::sendEvent(m_window.get(), &leave);
        QVERIFY(!hint->isVisible());
    }

    void draggedWordsAreNotTaken()
    {
        QMimeData dragged;
        dragged.setText(QStringLiteral("words"));
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
        enter.ignore();
        QApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(!enter.isAccepted());
        QVERIFY(!m_window->findChild<view::DropHint*>()->isVisible());
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

    void aLimitOnHairsIsNotedAtTheFoot()
    {
        model::Project project = starterProject();
        project.maxHairs = 2000;
        MainWindow window(std::move(project), QString());
        window.show();
        const QList<QLabel*> labels = window.findChild<view::StatusReadout*>()->findChildren<QLabel*>();
        QTRY_VERIFY_WITH_TIMEOUT(std::ranges::any_of(labels,
                                                     [](const QLabel* label) {
                                                         return label->text().endsWith(
                                                                    QStringLiteral(", limit reached")) &&
                                                                !label->toolTip().isEmpty();
                                                     }),
                                 30'000);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestMenus, Widgets)
#include "test_menus.moc"
