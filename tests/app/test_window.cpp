// The real window, driven with mouse and keys, 3D pixels included. Runs on platforms offscreen and xcb alike.
#include "app/window/first_activation.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"

#include <QMessageBox>

namespace hairpaint::app {

class TestWindow : public QObject, private WindowFixture
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }

    void cleanup() { m_window.reset(); }

    void paintingDensityGrowsHairAndUndoTakesItAway()
    {
        openWholeWindow(model::newProject());
        session().toggleWind();
        const QByteArray before = savedBytes("before.hairpaint");
        const QImage bald = picture();
        QCOMPARE(hairs(), std::size_t{0});

        key(Qt::Key_1);
        QCOMPARE(editor().target().map(), model::MapKind::Density);
        key(Qt::Key_B);
        drag(m_window->paintView(), paintPoint(0.40F, 0.5F), paintPoint(0.60F, 0.5F));
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 500, kPatienceMs);
        QVERIFY(!bald.isNull());
        QTRY_VERIFY_WITH_TIMEOUT(difference(bald, picture()) > 0.005, kPatienceMs);
        QCOMPARE(session().document().undoStack().undoText(), QStringLiteral("Brush on Density"));

        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(hairs(), std::size_t{0}, kPatienceMs);
        QVERIFY(savedBytes("after.hairpaint") == before);
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 500, kPatienceMs);
    }

    void escapeCancelsAStroke()
    {
        openWholeWindow(starterProject());
        const QByteArray before = savedBytes("escape-before.hairpaint");
        key(Qt::Key_2);
        view::PaintView& area = m_window->paintView();
        QTest::mousePress(&area, Qt::LeftButton, {}, paintPoint(0.5F, 0.5F));
        QTest::mouseMove(&area, paintPoint(0.55F, 0.5F));
        QVERIFY(editor().tools().stroking());
        QTest::keyClick(&area, Qt::Key_Escape);
        QVERIFY(!editor().tools().stroking());
        QTest::mouseRelease(&area, Qt::LeftButton, {}, paintPoint(0.55F, 0.5F));
        QCOMPARE(session().document().undoStack().count(), 0);
        QVERIFY(savedBytes("escape-after.hairpaint") == before);
    }

    void theHairMovesInTheWindAndStopsWhenPaused()
    {
        openWholeWindow(starterProject());
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 10'000, kPatienceMs);
        const std::uint64_t first = session().frame()->number;
        QTRY_VERIFY_WITH_TIMEOUT(session().frame()->number > first + 3, kPatienceMs);
        key(Qt::Key_F8);
        QVERIFY(session().paused());
        // What was under way when the key was pressed still comes: the frame that shows the stroke is the first after
        // it.
        const auto paintAndWait = [this](float u) {
            const std::size_t before = hairs();
            key(Qt::Key_1);
            editor().tools().choose(model::ToolId::Eraser);
            drag(m_window->paintView(), paintPoint(u, 0.5F), paintPoint(u, 0.6F));
            QTRY_VERIFY_WITH_TIMEOUT(hairs() < before, kPatienceMs);
        };
        paintAndWait(0.4F);
        const double stopped = session().frame()->simulatedSeconds;
        paintAndWait(0.6F);
        QCOMPARE(session().frame()->simulatedSeconds, stopped);
        QVERIFY(stopped > 0.0);
    }

    void aBrokenFileLeavesTheOpenProjectUntouched()
    {
        openWholeWindow(starterProject());
        const QByteArray before = savedBytes("kept.hairpaint");
        const QString broken = m_folder.filePath(QStringLiteral("broken.hairpaint"));
        QFile file(broken);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("no project");
        file.close();
        QString said;
        QTimer closer;
        connect(&closer, &QTimer::timeout, this, [&said] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                said = box->text();
                box->accept();
            }
        });
        closer.start(50);
        QVERIFY(!m_window->files().openPath(broken));
        QVERIFY2(said.contains(QStringLiteral("broken.hairpaint")), qPrintable(said));
        QVERIFY(savedBytes("kept-after.hairpaint") == before);
    }

    void aDialogThatOpensTakesTheKeys()
    {
        openWindow(test::smallProject());
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QDialog dialog(m_window.get());
        dialog.setModal(true);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
    }

    void theProgramBeginsOnceTheWindowHasTheKeys()
    {
        QWidget window;
        int begun = 0;
        const FirstActivation activation(window, [&begun] { ++begun; });
        test::handleDueEvents();
        QCOMPARE(begun, 0);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        test::handleDueEvents();
        QCOMPARE(begun, 1);
        QEvent again(QEvent::WindowActivate);
        QApplication::sendEvent(&window, &again);
        test::handleDueEvents();
        QCOMPARE(begun, 1);
    }

    void aClosedDialogGivesTheKeysBack_data()
    {
        QTest::addColumn<QByteArray>("action");
        for (const char* action : {"hair.lightDialog", "hair.windDialog", "edit.preferences", "help.help"})
            QTest::newRow(action) << QByteArray(action);
    }
    void aClosedDialogGivesTheKeysBack()
    {
        QFETCH(QByteArray, action);
        openWindow(starterProject());
        QTRY_VERIFY_WITH_TIMEOUT(m_window->isActiveWindow(), kPatienceMs);
        m_window->actions().find(QLatin1StringView(action))->trigger();
        const auto* dialog = m_window->findChild<QDialog*>();
        QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeWindow() == dialog, kPatienceMs);
        QTest::keyClick(QGuiApplication::focusWindow(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->isActiveWindow(), kPatienceMs);
    }

    void listsMenusAndTipsHaveTheProgramsFont()
    {
        openWindow(test::smallProject()); // Windows has fonts of its own for them.
        for (const char* kind : {"QAbstractItemView", "QMenu", "QMenuBar", "QMessageBox", "QTipLabel", "QStatusBar"})
            QCOMPARE(QApplication::font(kind).families(), QApplication::font().families());
    }

    void everyActionHasATextAndKeysAreUnique()
    {
        openWholeWindow(model::newProject());
        QHash<QKeySequence, QString> owners;
        for (const view::KeyBinding& binding : m_window->actions().bindings()) {
            QVERIFY(!binding.action->text().isEmpty());
            QVERIFY(!binding.name.isEmpty());
            for (const QKeySequence& key : binding.defaultKeys) {
                QVERIFY2(!owners.contains(key),
                         qPrintable(binding.action->objectName() + QLatin1Char(' ') + owners.value(key)));
                owners.insert(key, binding.action->objectName());
            }
        }
        QVERIFY(owners.size() > 30);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindow, Widgets)
#include "test_window.moc"
