// The real window, driven with mouse and keys, 3D pixels included. Runs on platforms offscreen and xcb alike.
#include "tests/app/window_fixture.h"

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
        openWindow(model::newProject());
        session().toggleWind();
        const QByteArray before = savedBytes("before.hairpaint");
        const QImage bald = picture();
        QCOMPARE(hairs(), std::size_t{0});

        key(Qt::Key_1);
        QCOMPARE(editor().activeMap(), model::MapKind::Density);
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

    void paintingOnTheHeadGrowsHairThere()
    {
        openWindow(model::newProject());
        key(Qt::Key_1);
        view::HeadView& head = m_window->headView();
        const sim::SurfacePoint crown = *session().document().project().head->skin->atUv({0.5F, 0.47F});
        const QPoint place = head.positionOf(crown.positionHd).value().toPoint();
        QWidget* target = head.childAt(place) != nullptr ? head.childAt(place) : &head;
        const QPoint local = target->mapFrom(&head, place);
        drag(*target, local, local + QPoint(12, 4));
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 100, kPatienceMs);
        QCOMPARE(session().document().undoStack().count(), 1);
    }

    void gradientCopyAndPasteAreOneStepEach()
    {
        openWindow(starterProject());
        QUndoStack& stack = session().document().undoStack();
        key(Qt::Key_2);
        key(Qt::Key_G);
        drag(m_window->paintView(), paintPoint(0.5F, 0.65F), paintPoint(0.5F, 0.35F));
        QCOMPARE(stack.count(), 1);
        key(Qt::Key_M);
        drag(m_window->paintView(), paintPoint(0.45F, 0.55F), paintPoint(0.55F, 0.45F));
        QVERIFY(editor().selection().rectangle().has_value());
        key(Qt::Key_C, Qt::ControlModifier);
        key(Qt::Key_3);
        key(Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(stack.count(), 2);
        QVERIFY(stack.undoText().contains(QStringLiteral("Curl")));
        key(Qt::Key_Delete);
        QCOMPARE(stack.count(), 3);
    }

    void aStyleSavesAndReopensTheSame()
    {
        openWindow(model::newProject());
        const QString path = m_folder.filePath(QStringLiteral("style.hairpaint"));
        const QString style = model::listPresets({}).at(1).path;
        m_window->openFile(style);
        QCOMPARE(session().document().undoStack().count(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 10'000, kPatienceMs);
        const std::size_t count = hairs();
        const QByteArray bytes = savedBytes("style.hairpaint");
        QVERIFY(!bytes.isEmpty());
        session().document().markSaved();

        m_window->files().newProject();
        QVERIFY(m_window->files().openPath(path));
        QTRY_COMPARE_WITH_TIMEOUT(hairs(), count, kPatienceMs);
        QVERIFY(savedBytes("again.hairpaint") == bytes);
        QVERIFY(!session().document().modified());
    }

    void escapeCancelsAStroke()
    {
        openWindow(starterProject());
        const QByteArray before = savedBytes("escape-before.hairpaint");
        key(Qt::Key_2);
        view::PaintView& area = m_window->paintView();
        QTest::mousePress(&area, Qt::LeftButton, {}, paintPoint(0.5F, 0.5F));
        QTest::mouseMove(&area, paintPoint(0.55F, 0.5F));
        QVERIFY(editor().stroking());
        QTest::keyClick(&area, Qt::Key_Escape);
        QVERIFY(!editor().stroking());
        QTest::mouseRelease(&area, Qt::LeftButton, {}, paintPoint(0.55F, 0.5F));
        QCOMPARE(session().document().undoStack().count(), 0);
        QVERIFY(savedBytes("escape-after.hairpaint") == before);
    }

    void theHairMovesInTheWindAndStopsWhenPaused()
    {
        openWindow(starterProject());
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 10'000, kPatienceMs);
        const std::uint64_t first = session().frame()->number;
        QTRY_VERIFY_WITH_TIMEOUT(session().frame()->number > first + 3, kPatienceMs);
        key(Qt::Key_F8);
        QVERIFY(session().paused());
        // Frames that were on their way still come.
        std::uint64_t last = 0;
        for (int tries = 0; tries < 20 && last != session().frame()->number; ++tries) {
            last = session().frame()->number;
            QTest::qWait(500);
        }
        QCOMPARE(session().frame()->number, last);
        QTest::qWait(500);
        QCOMPARE(session().frame()->number, last);
    }

    void aBrokenFileLeavesTheOpenProjectUntouched()
    {
        openWindow(starterProject());
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

    void everyActionHasATextAndKeysAreUnique()
    {
        openWindow(model::newProject());
        QHash<QKeySequence, QString> owners;
        for (const view::KeyBinding& binding : m_window->actions().bindings()) {
            QVERIFY(!binding.action->text().isEmpty());
            if (binding.defaultKey.isEmpty())
                continue;
            QVERIFY2(!owners.contains(binding.defaultKey),
                     qPrintable(binding.action->objectName() + QLatin1Char(' ') + owners.value(binding.defaultKey)));
            owners.insert(binding.defaultKey, binding.action->objectName());
        }
        QVERIFY(owners.size() > 30);
    }
};

} // namespace hairpaint::app

QTEST_MAIN(hairpaint::app::TestWindow)
#include "test_window.moc"
