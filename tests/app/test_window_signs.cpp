// What a newcomer looks for in the real window: a bald head, views by key, words on what is saved.
#include "sim/solver/solver_layout.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"
#include "view/editing/brush_drag.h"
#include "view/head_area/view_signs.h"
#include "view/panels/status_readout.h"
#include "view/panels/style_strip.h"
#include "view/panels/style_tile.h"
#include "view/rendering/standard_views.h"

#include <QLabel>

#include <algorithm>

namespace hairpaint::app {

class TestWindowSigns : public QObject, private WindowFixture
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void aBaldHeadComesFirstAndIsPaintedOnDensity()
    {
        openWholeWindow(starterProject());
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 10'000, kPatienceMs);
        view::StyleTile* bald = m_window->findChild<view::StyleStrip*>()->findChildren<view::StyleTile*>().constFirst();
        QCOMPARE(bald->text(), QStringLiteral("Bald"));
        QTest::mouseClick(bald, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(hairs(), std::size_t{0}, kPatienceMs);
        QCOMPARE(stack().count(), 1);
        QCOMPARE(editor().target().map(), model::MapKind::Density);
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(hairs() > 10'000, kPatienceMs);

        editor().target().setMap(model::MapKind::Length);
        m_window->actions().find(QLatin1StringView("file.newBald"))->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(hairs(), std::size_t{0}, kPatienceMs);
        QCOMPARE(editor().target().map(), model::MapKind::Density);
        QVERIFY(!session().document().modified());
    }

    void theNumberPadTurnsTheViewAsInBlender_data()
    {
        QTest::addColumn<Qt::Key>("key");
        QTest::addColumn<bool>("opposite");
        QTest::addColumn<rendering::StandardView>("side");
        QTest::newRow("1") << Qt::Key_1 << false << rendering::StandardView::Front;
        QTest::newRow("Ctrl+1") << Qt::Key_1 << true << rendering::StandardView::Back;
        QTest::newRow("3") << Qt::Key_3 << false << rendering::StandardView::Right;
        QTest::newRow("Ctrl+3") << Qt::Key_3 << true << rendering::StandardView::Left;
        QTest::newRow("7") << Qt::Key_7 << false << rendering::StandardView::Top;
        QTest::newRow("Ctrl+7") << Qt::Key_7 << true << rendering::StandardView::Bottom;
        QTest::newRow("5") << Qt::Key_5 << false << rendering::StandardView::ThreeQuarter;
    }
    void theNumberPadTurnsTheViewAsInBlender()
    {
        QFETCH(Qt::Key, key);
        QFETCH(bool, opposite);
        QFETCH(rendering::StandardView, side);
        openWindow(model::newProject());
        const model::MapKind map = editor().target().map();
        rendering::Camera elsewhere = m_window->headView().camera();
        elsewhere.azimuthRad = -1.0F;
        elsewhere.elevationRad = 0.5F;
        m_window->headView().setCamera(elsewhere);
        m_window->paintView().setFocus();
        QTest::keyClick(&m_window->paintView(), key,
                        opposite ? Qt::KeypadModifier | Qt::ControlModifier : Qt::KeypadModifier);
        const rendering::Camera wanted =
            rendering::standardCamera(side, *session().document().project().head->shownMesh);
        QTRY_COMPARE_WITH_TIMEOUT(m_window->headView().camera().azimuthRad, wanted.azimuthRad, kPatienceMs);
        QCOMPARE(m_window->headView().camera().elevationRad, wanted.elevationRad);
        QCOMPARE(editor().target().map(), map); // The other digits are the maps'.
    }

    void theWindowTellsWhatIsSaved()
    {
        openWindow(model::newProject());
        auto* status = m_window->findChild<view::StatusReadout*>();
        QVERIFY(status->savedText().isEmpty());
        key(Qt::Key_1);
        drag(m_window->paintView(), paintPoint(0.5F, 0.5F), paintPoint(0.55F, 0.5F));
        QVERIFY(status->savedText().contains(QStringLiteral("Not saved")));
        QVERIFY(m_window->isWindowModified());
        m_window->files().setPath(m_folder.filePath(QStringLiteral("told.hairpaint")));
        QVERIFY(m_window->files().save());
        QVERIFY(!status->savedText().contains(QStringLiteral("Not")) && !status->savedText().isEmpty());
        key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(status->savedText().contains(QStringLiteral("Not saved")));
    }

    void pausedHairIsMarkedInBothAreas()
    {
        openWindow(model::newProject());
        const auto tells = [](const QWidget* widget) {
            const QList<QLabel*> labels = widget->findChildren<QLabel*>();
            return std::ranges::any_of(
                labels, [](const QLabel* label) { return label->text().contains(QStringLiteral("Paused")); });
        };
        const auto* status = m_window->findChild<view::StatusReadout*>();
        const auto* signs = m_window->headView().findChild<view::ViewSigns*>();
        for (const bool paused : {true, false}) {
            key(Qt::Key_F8);
            QCOMPARE(tells(status), paused);
            QCOMPARE(signs->text().contains(QStringLiteral("Paused")), paused);
        }
    }

    void aStillPictureHasNoRateOfFrames()
    {
        openWindow(model::newProject());
        const auto* status = m_window->findChild<view::StatusReadout*>();
        const auto tellsRate = [status] {
            const QList<QLabel*> labels = status->findChildren<QLabel*>();
            return std::ranges::any_of(
                labels, [](const QLabel* label) { return label->text().endsWith(QStringLiteral("fps")); });
        };
        key(Qt::Key_F8); // Paused: pictures come from here alone, once this one is as fine as it gets.
        QTRY_VERIFY_WITH_TIMEOUT(!tellsRate(), kPatienceMs);
        for (int i = 0; i < 2; ++i)
            Q_EMIT m_window->headView().frameDrawn({});
        QVERIFY(tellsRate());
        QTRY_VERIFY_WITH_TIMEOUT(!tellsRate(), kPatienceMs);
    }

    void noMoreFramesAreMadeThanAreDrawn()
    {
        model::Project project = starterProject();
        project.wind.enabled = true; // It never rests.
        project.wind.velocity = {3.0F, 0.0F, 0.0F};
        openWindow(std::move(project));
        rendering::FrameStatistics slow;
        slow.milliseconds = 10'000.0;
        std::uint64_t number = 0;
        double shown = 0.0;
        bool apart = false;
        QObject lives;
        connect(&session(), &Session::frameChanged, &lives, [&](const std::shared_ptr<const sim::StrandFrame>& frame) {
            for (int i = 0; i < 20; ++i) // However fast this machine is.
                Q_EMIT m_window->headView().frameDrawn(slow);
            // More time a frame than one advance of the simulation covers; frames that came while others were drawn are
            // counted too.
            const double passed = frame->simulatedSeconds - std::exchange(shown, frame->simulatedSeconds);
            const auto made = static_cast<double>(frame->number - number);
            apart = apart || (number > 0 && passed > 12.0 * sim::kStepSeconds * made);
            number = frame->number;
        });
        QTRY_VERIFY_WITH_TIMEOUT(apart, kPatienceMs);
    }

    void sizingTheBrushInThePaintAreaIsTold()
    {
        openWindow(model::newProject());
        view::PaintView& area = m_window->paintView();
        QTest::mousePress(&area, Qt::RightButton, Qt::ControlModifier, paintPoint(0.5F, 0.5F));
        QMouseEvent move(QEvent::MouseMove, paintPoint(0.6F, 0.5F), area.mapToGlobal(paintPoint(0.6F, 0.5F)),
                         Qt::NoButton, Qt::RightButton, Qt::ControlModifier);
        QApplication::sendEvent(&area, &move);
        const QString wanted = view::brushText(editor().tools().settings());
        const QList<QLabel*> labels = m_window->findChild<view::StatusReadout*>()->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == wanted; }));
        QTest::mouseRelease(&area, Qt::RightButton, Qt::ControlModifier, paintPoint(0.6F, 0.5F));
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowSigns, Widgets)
#include "test_window_signs.moc"
