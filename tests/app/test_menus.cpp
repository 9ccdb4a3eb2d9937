// The menus of the real window, where what is on is seen to be on, and its panels.
#include "app/styles/library.h"
#include "app/window/main_window.h"
#include "app/window/menus/area_menu.h"
#include "model/document/group_commands.h"
#include "model/files/project_file.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/head_area/head_view.h"
#include "view/look/resources.h"
#include "view/paint_area/paint_view.h"
#include "view/panels/option_bar.h"
#include "view/panels/status_readout.h"
#include "view/panels/tool_bar.h"
#include "view/widgets/drop_hint.h"

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
    void trigger(const char* id) { m_window->actions().find(QLatin1StringView(id))->trigger(); }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        SettingsStore().clear();
        view::initResources();
        m_window = std::make_unique<MainWindow>(model::newProject());
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

    void viewCommandsOfAMenuAreForTheAreaThatThePointerCameFrom()
    {
        view::HeadView& head = m_window->headView();
        rendering::Camera moved = head.camera();
        const rendering::Camera home = moved;
        moved.azimuthRad += 1.0F;
        const auto enter = [](QWidget& area) {
            QEnterEvent event(QPointF(9.0, 9.0), QPointF(9.0, 9.0), area.mapToGlobal(QPointF(9.0, 9.0)));
            QCoreApplication::sendEvent(&area, &event);
        };
        enter(*m_window->findChild<view::PaintView*>());
        head.setCamera(moved);
        trigger("view.home");
        QCOMPARE(head.camera().azimuthRad, moved.azimuthRad);
        enter(head);
        trigger("view.home");
        QTRY_COMPARE_WITH_TIMEOUT(head.camera().azimuthRad, home.azimuthRad, test::kPatienceMs);
        head.setCamera(moved);
        enter(*m_window->findChild<view::PaintView*>());
        trigger("view.head"); // The only one that is shown.
        trigger("view.home");
        QTRY_COMPARE_WITH_TIMEOUT(head.camera().azimuthRad, home.azimuthRad, test::kPatienceMs);
        trigger("view.both");
    }

    void theHeadsMenuBeginsWithWhatIsDoneToHair()
    {
        const auto titles = [this](AreaMenu::Area area) {
            QStringList found;
            const AreaMenu menu(area, m_window->actions(), nullptr);
            for (const QAction* action : menu.actions())
                found += action->text().remove(QLatin1Char('&'));
            return found;
        };
        const QStringList head = titles(AreaMenu::Area::Head);
        QCOMPARE(head.indexOf(QStringLiteral("Tie and put on")), 3); // After undo, redo and a separator.
        QVERIFY(!head.contains(QStringLiteral("Paste")));
        const QStringList map = titles(AreaMenu::Area::Map);
        QVERIFY(map.contains(QStringLiteral("Paste")) && map.contains(QStringLiteral("Tie and put on")));
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
        QVERIFY(!checked("view.colliders") && !m_window->session().editor().options().collidersShown());
        trigger("view.colliders");
        QVERIFY(checked("view.colliders") && m_window->session().editor().options().collidersShown());
        trigger("view.colliders");
        QVERIFY(!checked("view.colliders"));
        QCOMPARE(m_window->session().document().undoStack().count(), steps);
    }

    void tiesComeBeforeCollidersInTheMenu()
    {
        QAction* ponytail = m_window->actions().find(QLatin1StringView("hair.addPonytail"));
        QVERIFY(ponytail);
        const QList<QMenu*> menus = m_window->findChildren<QMenu*>();
        const auto menu =
            std::ranges::find_if(menus, [&](const QMenu* one) { return one->actions().contains(ponytail); });
        QVERIFY(menu != menus.end());
        const QList<QAction*> offered = (*menu)->actions();
        QCOMPARE(offered.front(), ponytail);
        QCOMPARE(offered.back(), m_window->actions().find(QLatin1StringView("hair.addCollider")));
    }

    void whatIsWornIsAddedAndRemoved_data()
    {
        QTest::addColumn<model::WornKind>("kind");
        for (const model::WornSpec& spec : model::wornSpecs())
            if (!spec.tie && !spec.ownMesh) // A tie wants hair: test_tied_hair; a mesh wants a file: test_exchange.
                QTest::newRow(spec.id) << spec.kind;
    }

    void whatIsWornIsAddedAndRemoved()
    {
        QFETCH(model::WornKind, kind);
        const model::WornSpec& spec = model::wornSpec(kind);
        model::Document& document = m_window->session().document();
        const std::vector<model::Worn> before = document.project().worn;
        const auto count = [&] { return countOf(document.project().worn, kind); };
        const std::size_t first = count();
        QAction* add = m_window->actions().find(QLatin1StringView(QByteArray("hair.add") + spec.action));
        QAction* remove = m_window->actions().find(QLatin1StringView("hair.removeWorn"));
        QVERIFY(first < spec.limit && add->isEnabled() && !remove->isEnabled());
        QVERIFY(add->toolTip().contains(QString::number(spec.limit)));
        const int steps = document.undoStack().index();
        add->trigger();
        QCOMPARE(count(), first + 1);
        QVERIFY(remove->isEnabled());
        QCOMPARE(remove->text(), model::wornText(spec.removeTitle));
        remove->trigger();
        QVERIFY(document.project().worn == before);
        QVERIFY(add->isEnabled() && !remove->isEnabled());
        while (count() < spec.limit)
            add->trigger();
        QVERIFY(!add->isEnabled());
        while (document.undoStack().index() > steps)
            document.undo();
        QVERIFY(document.project().worn == before);
        m_window->session().editor().options().setChosenWorn(0);
        m_window->session().editor().options().setCollidersShown(false);
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
            return document.committed().group(editor.target().group())->map(editor.target().map()).size;
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

    void bracketsGoByTheirKeysUntilTheyAreBoundAnew()
    {
        QAction* smaller = m_window->actions().find(QLatin1StringView("tool.smaller"));
        QCOMPARE(smaller->shortcut(), QKeySequence(Qt::Key_BracketLeft));
        const auto size = [this] { return m_window->session().editor().tools().settings().brushSizeM; };
        // Where a German keyboard types an umlaut.
#ifdef Q_OS_WIN
        constexpr quint32 kKeyCode = 0x1A;
#else
        constexpr quint32 kKeyCode = 34;
#endif
        const auto press = [this] {
            QKeyEvent event(QEvent::KeyPress, Qt::Key_Udiaeresis, Qt::NoModifier, kKeyCode, 0, 0);
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
                     QLatin1StringView(model::mapSpec(m_window->session().editor().target().map()).id));
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
        m_window->session().editor().target().setMap(model::MapKind::Curl);
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
        MainWindow window(std::move(project));
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
