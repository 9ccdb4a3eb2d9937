// Somebody who knows nothing clicks, drags and types at random: nothing may break, and undo leads back to the start.
#include "app/session/large_memory.h"
#include "model/document/edit_command.h"
#include "model/document/group_commands.h"
#include "model/document/scene_commands.h"
#include "model/files/preset_file.h"
#include "model/styles/preset.h"
#include "tests/app/program.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"
#include "view/panels/sidebar.h"

#include <QAbstractSlider>
#include <QDialog>
#include <QMenu>

#include <algorithm>
#include <array>
#include <random>

#if defined(HAIRPAINT_ASAN)
#include <sanitizer/allocator_interface.h>
#elif defined(__GLIBC__)
#include <malloc.h>
#endif

namespace hairpaint::app {

namespace {

/// Closes whatever asks for something; leaves dialogs that show how far work is.
class Closer : public QObject
{
public:
    Closer() { startTimer(10); }

protected:
    void timerEvent(QTimerEvent* /*event*/) override
    {
        if (QWidget* popup = QApplication::activePopupWidget())
            QMetaObject::invokeMethod(popup, &QWidget::close, Qt::QueuedConnection);
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (dialog != nullptr && dialog->inherits("QMessageBox"))
            QMetaObject::invokeMethod(
                dialog, [dialog] { dialog->done(QDialog::Rejected); }, Qt::QueuedConnection);
        else if (dialog != nullptr && (dialog->inherits("QFileDialog") || dialog->inherits("QColorDialog")))
            QMetaObject::invokeMethod(dialog, &QDialog::reject, Qt::QueuedConnection);
    }
};

constexpr int kFifths = 5;
constexpr int kRestsAFifth = 8;
constexpr int kLongRun = 10'000; ///< Actions from which on memory can be expected to have settled.

/// What the program has asked for and not given back; 0 where that is not known.
qint64 allocatedBytes()
{
#if defined(HAIRPAINT_ASAN)
    return static_cast<qint64>(__sanitizer_get_current_allocated_bytes());
#elif defined(__GLIBC__)
    const struct mallinfo2 all = mallinfo2();
    return static_cast<qint64>(all.uordblks) + static_cast<qint64>(all.hblkhd);
#else
    return 0;
#endif
}

/// So many, or as the environment says: HAIRPAINT_MONKEY_ACTIONS=100000 HAIRPAINT_MONKEY_SEED=7 (and
/// QTEST_FUNCTION_TIMEOUT, in ms, for what takes more than five minutes).
int fromEnvironment(const char* name, int otherwise)
{
    const int value = qEnvironmentVariableIntValue(name);
    return value > 0 ? value : otherwise;
}

} // namespace

class TestMonkey : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    std::mt19937 m_random;
    model::Preset m_style;
    model::Project m_project;

    /// With small maps, on which all that is done takes less time.
    static model::Project smallProject()
    {
        constexpr int kMapSize = 256;
        model::Project project = model::newProject();
        project.groups = {model::makeGroup(project, project.groups.front().name, kMapSize)};
        return project;
    }

    unsigned below(unsigned count) { return static_cast<unsigned>(m_random() % count); }

    QPoint pointIn(const QWidget& area)
    {
        return {static_cast<int>(below(static_cast<unsigned>(area.width()))),
                static_cast<int>(below(static_cast<unsigned>(area.height())))};
    }

    Qt::KeyboardModifiers modifiers()
    {
        constexpr std::array<Qt::KeyboardModifier, 6> kOften{Qt::NoModifier,      Qt::NoModifier,    Qt::NoModifier,
                                                             Qt::ControlModifier, Qt::ShiftModifier, Qt::AltModifier};
        return kOften[below(kOften.size())];
    }

    void dragSomewhere(QWidget& area)
    {
        const std::array<Qt::MouseButton, 5> buttons{Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::RightButton,
                                                     Qt::MiddleButton};
        const Qt::MouseButton button = buttons[below(buttons.size())];
        const Qt::KeyboardModifiers held = modifiers();
        QWidget* const target =
            area.childAt(area.rect().center()) != nullptr && below(2) == 0 ? area.childAt(area.rect().center()) : &area;
        QTest::mousePress(target, button, held, pointIn(*target));
        for (unsigned i = 0; i < below(6); ++i)
            QTest::mouseMove(target, pointIn(*target));
        if (below(20) == 0)
            QTest::keyClick(&m_window->paintView(), Qt::Key_Z, Qt::ControlModifier); // In the middle of it.
        QTest::mouseRelease(target, button, held, pointIn(*target));
    }

    void pressSomeKey()
    {
        // No file is opened, saved or left by keys: their dialogs belong to other tests.
        constexpr std::array kKeys{
            Qt::Key_B,      Qt::Key_E,      Qt::Key_C,        Qt::Key_G,   Qt::Key_U,           Qt::Key_M,
            Qt::Key_I,      Qt::Key_P,      Qt::Key_Y,        Qt::Key_X,   Qt::Key_H,           Qt::Key_W,
            Qt::Key_1,      Qt::Key_2,      Qt::Key_3,        Qt::Key_4,   Qt::Key_5,           Qt::Key_6,
            Qt::Key_7,      Qt::Key_8,      Qt::Key_9,        Qt::Key_0,   Qt::Key_Space,       Qt::Key_Escape,
            Qt::Key_Return, Qt::Key_Delete, Qt::Key_Left,     Qt::Key_Tab, Qt::Key_BracketLeft, Qt::Key_BracketRight,
            Qt::Key_F2,     Qt::Key_F8,     Qt::Key_Backspace};
        key(kKeys[below(kKeys.size())]);
    }

    void triggerSomething()
    {
        constexpr std::array kActions{
            "edit.undo",       "edit.undo",       "edit.undo",        "edit.redo",      "edit.redo",
            "edit.cut",        "edit.copy",       "edit.paste",       "edit.fill",      "edit.clear",
            "edit.all",        "edit.none",       "edit.invert",      "edit.mirror",    "map.addLayer",
            "map.removeLayer", "map.layerUp",     "map.layerDown",    "hair.wind",      "hair.pause",
            "hair.reset",      "hair.nod",        "hair.shake",       "hair.turn",      "hair.addCollider",
            "hair.removeWorn", "hair.face",       "hair.removeGroup", "hair.hold",      "view.both",
            "view.head",       "view.paint",      "view.swap",        "view.panels",    "view.wireframe",
            "view.night",      "view.colliders",  "view.directions",  "look.front",     "look.back",
            "look.top",        "tool.swapValues", "tool.smaller",     "tool.larger",    "view.fit",
            "view.home",       "edit.duplicate",  "file.newBald",     "hair.windDialog"};
        const char* id = kActions[below(kActions.size())];
        if (QLatin1StringView(id) == QLatin1StringView("file.newBald") && below(20) != 0)
            return;
        if (QAction* action = m_window->actions().find(QLatin1StringView(id)); action != nullptr && action->isEnabled())
            action->trigger();
    }

    void clickSomeStyle()
    {
        auto* strip = m_window->findChild<view::StyleStrip*>();
        if (strip->isVisible())
            QTest::mouseClick(strip->childAt(strip->rect().center()) != nullptr ? strip->childAt(strip->rect().center())
                                                                                : strip,
                              Qt::LeftButton, {}, QPoint(static_cast<int>(below(800)), 30));
    }

    void act(int number)
    {
        actSomehow();
        if (number % 8 != 0)
            return;
        QCoreApplication::processEvents();
        // Without a loop that runs nobody else does it.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

    void actSomehow()
    {
        switch (below(10)) {
        case 0:
        case 1:
        case 2:
            return dragSomewhere(m_window->paintView());
        case 3:
        case 4:
            return dragSomewhere(m_window->headView());
        case 5:
        case 6:
            return pressSomeKey();
        case 7:
        case 8:
            return triggerSomething();
        default:
            break;
        }
        if (below(12) == 0)
            clickSomeStyle();
        else if (auto* sidebar = m_window->findChild<view::Sidebar*>(); sidebar->isVisible())
            QTest::mouseClick(sidebar->childAt(pointIn(*sidebar)) != nullptr ? sidebar->childAt(pointIn(*sidebar))
                                                                             : sidebar,
                              Qt::LeftButton, {}, QPoint(10, 5));
    }

    /// One and the same head rests in one and the same view, whatever was done before.
    void rest()
    {
        model::Document& document = session().document();
        document.push(model::setWindCommand(document, {.enabled = false}));
        const auto wearAsFirst = [this](model::Project& project) { project.worn = m_project.worn; };
        document.push(
            shownEditCommand(document, {{{.aspect = model::Change::Aspect::Environment}, wearAsFirst}}, {}, QString()));
        editor().target().setMap(model::MapKind::Density);
        // A copy of all replaces whatever was copied.
        for (const char* id : {"view.both", "view.home", "view.fit", "look.front", "edit.none", "edit.copy"})
            m_window->actions().find(QLatin1StringView(id))->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(session().hair() == Session::Hair::Current, kPatienceMs);
        awaitFinePicture();
        QTRY_VERIFY_WITH_TIMEOUT(!Jobs::anyLeft(), kPatienceMs);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        returnFreedMemory();
    }

    [[nodiscard]] double megabytesAtRest()
    {
        session().document().push(model::applyPresetCommand(session().document(), m_style));
        rest();
        return static_cast<double>(test::residentBytes(QCoreApplication::applicationPid())) / 1e6;
    }

private Q_SLOTS:
    void initTestCase()
    {
        returnLargeMemory(); // As the program does.
        prepareApplication();
        m_style = model::loadPreset(QStringLiteral(":/presets/bob.hairpreset")).value();
    }
    void cleanup() { m_window.reset(); }

    void randomActionsBreakNothing()
    {
        const int actions = fromEnvironment("HAIRPAINT_MONKEY_ACTIONS", 400);
        m_random.seed(static_cast<unsigned>(fromEnvironment("HAIRPAINT_MONKEY_SEED", 1)));
        m_project = actions < kLongRun ? smallProject() : model::newProject();
        openWindow(m_project);
        // So little that long runs forget their first steps, and hold no more from then on.
        session().document().setUndoBudget(std::size_t{64} << 20U);
        const Closer closer;
        std::array<double, kFifths> megabytes{}; // What each fifth of the actions held, on average,
        std::array<double, kFifths> atRest{};    // and what it held where nothing but the past differs.
        const int restEvery = actions / (kFifths * kRestsAFifth);
        for (int i = 0; i < actions; ++i) {
            act(i);
            const auto fifth = static_cast<std::size_t>(qint64{i} * kFifths / actions);
            if (actions >= kLongRun && i % restEvery == restEvery - 1)
                atRest[fifth] += megabytesAtRest() / kRestsAFifth;
            megabytes[fifth] += static_cast<double>(test::residentBytes(QCoreApplication::applicationPid())) * kFifths /
                                (1e6 * actions);
        }
        m_window->findChild<view::StyleStrip*>()->setFocus();
        model::Document& document = session().document();
        document.settle();
        const auto saved =
            model::saveProject(document.committed(), m_folder.filePath(QStringLiteral("first.hairpaint")), {});
        QVERIFY2(saved, saved ? "" : qPrintable(saved.error().message));
        const QByteArray after = savedBytes("after.hairpaint");
        QVERIFY(model::loadProject(m_folder.filePath(QStringLiteral("after.hairpaint"))));
        const int steps = stack().index();
        while (document.canUndo() && stack().index() > 0)
            document.undo();
        while (stack().index() < steps)
            document.redo();
        QVERIFY(savedBytes("again.hairpaint") == after);
        qInfo("%d actions, %d steps; MB in each fifth: %.0f %.0f %.0f %.0f %.0f", actions, steps, megabytes[0],
              megabytes[1], megabytes[2], megabytes[3], megabytes[4]);
        if (actions < kLongRun)
            return;
        qInfo("with one style at rest: %.0f %.0f %.0f %.0f %.0f", atRest[0], atRest[1], atRest[2], atRest[3],
              atRest[4]);
#if !defined(HAIRPAINT_ASAN) // Which holds freed memory back.
        QVERIFY(atRest[4] <= 1.05 * atRest[1]);
#endif
    }

    /// The same actions from the same content, again and again: what leaks does in every round, what is kept for later
    /// comes once.
    void actionsLeaveNothingBehind()
    {
        constexpr int kRounds = 4;
        constexpr int kActions = 60;
        constexpr qint64 kMostBytes = qint64{kActions} * 5'000;
        constexpr qsizetype kMostWidgets = kActions / 10;
        m_project = smallProject();
        openWindow(m_project);
        const Closer closer;
        std::array<qint64, kRounds> bytes{};
        std::array<qsizetype, kRounds> widgets{};
        for (std::size_t round = 0; round < kRounds && !QTest::currentTestFailed(); ++round) {
            m_random.seed(static_cast<unsigned>(fromEnvironment("HAIRPAINT_MONKEY_SEED", 1)));
            for (int i = 0; i < kActions; ++i)
                act(i);
            session().document().settle();
            session().document().replace(m_project, model::ResolvedMaps(m_project)); // No step is left of the past.
            rest();
            QTRY_VERIFY_WITH_TIMEOUT(session().resting(), kPatienceMs);
            bytes.at(round) = allocatedBytes();
            widgets.at(round) = QApplication::allWidgets().size();
            qInfo("round %d: %.3f MB, %d widgets", static_cast<int>(round), static_cast<double>(bytes.at(round)) * 1e-6,
                  static_cast<int>(widgets.at(round)));
        }
        QVERIFY(std::min(bytes[2] - bytes[1], bytes[3] - bytes[2]) < kMostBytes);
        QVERIFY(std::min(widgets[2] - widgets[1], widgets[3] - widgets[2]) < kMostWidgets);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestMonkey, Widgets)
#include "test_monkey.moc"
