// The QOpenGLWidget of the 3D area, in a real window: run on xcb under Xvfb.
#include "head_fixture.h"
#include "tests/support/head_picture.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/head_area/gl_presenter.h"

#include <epoxy/gl.h>

#include <QDeadlineTimer>
#include <QMainWindow>
#include <QOpenGLWidget>
#include <QSignalSpy>
#include <QTest>

#include <memory>
#include <utility>

using namespace hairpaint;

namespace {

int lightness(const QImage& image, QPoint at)
{
    return image.isNull() ? -1 : image.pixelColor(at).lightness();
}

/// The canvas alone, and what it tells.
struct Presented
{
    explicit Presented(view::Shot still) : shot(std::move(still))
    {
        presenter.widget().resize(240, 200);
        QObject::connect(&presenter, &view::FramePresenter::refining, &presenter, [this](bool on) { refines = on; });
        QObject::connect(&presenter, &view::FramePresenter::frameDrawn, &presenter,
                         [this](const rendering::FrameStatistics& statistics) {
                             ++frames;
                             hairs = statistics.drawnHairs;
                         });
    }
    void present(bool still)
    {
        shot.still = still;
        presenter.present(shot);
    }
    /// How many turns of the event loop it took until a picture was drawn; 0 where none came.
    [[nodiscard]] int turnsToNextFrame()
    {
        const int before = frames;
        int turns = 0;
        const QDeadlineTimer giveUp(test::kPatienceMs);
        while (frames == before && !giveUp.hasExpired()) {
            QCoreApplication::processEvents();
            ++turns;
        }
        return frames == before ? 0 : turns;
    }

    /// Until the picture is as fine as it gets; false where that never comes.
    [[nodiscard]] bool refined()
    {
        while (refines)
            if (turnsToNextFrame() == 0)
                return false;
        return hairs == shot.allHairs;
    }

    view::Shot shot;
    QWidget window;
    view::GlPresenter presenter{&window};
    bool refines = false;
    int frames = 0;
    std::size_t hairs = 0; ///< In the last picture.
};

} // namespace

class GlPresenterTest : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        test::Editor editor(test::makeProject(test::makeBallHead()));
        const model::LayerAddress at = editor.state.target().address();
        editor.document.apply({}, [at](model::Project& project) {
            project.layer(at.group, at.map, at.layer)->raster = sim::TiledRaster(256, 2, {32000, 65535});
            // Their number is what matters.
            project.groups.front().settings.nodesPerHair = sim::kLeastNodes;
            project.groups.front().settings.greatestLengthM = 0.02F;
        });
        const std::shared_ptr<const sim::Skin> skin = editor.document.project().head->skin;
        m_hairy.scene.head = std::shared_ptr<const sim::HeadMesh>(skin, &skin->mesh());
        m_hairy.scene.hair = test::HeadFixture::frameOf(editor);
        m_hairy.scene.camera = test::HeadFixture::camera();
        m_hairy.allHairs = m_hairy.scene.hair->hairCount;
        m_project = editor.document.committed();
        QVERIFY(m_hairy.allHairs > 70'000);
    }
    void init()
    {
        m_editor = std::make_unique<test::Editor>(m_project);
        m_area = new view::HeadView(m_editor->state, view::Theme::of(view::ThemeKind::Dark), view::PresenterChoice::Gl);
        rendering::Camera camera;
        camera.targetWo = glm::vec3(0.0F);
        camera.distanceM = 0.6F;
        m_area->setCamera(camera);
        m_window = std::make_unique<QMainWindow>();
        m_window->setCentralWidget(m_area);
        m_window->resize(480, 400);
    }
    void cleanup()
    {
        m_window.reset();
        m_editor.reset();
    }

    void theHeadIsDrawnIntoTheWindow()
    {
        QSignalSpy drawn(m_area, &view::HeadView::frameDrawn);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QTRY_VERIFY_WITH_TIMEOUT(drawn.count() >= 1, test::kPatienceMs);
        auto* canvas = m_area->findChild<QOpenGLWidget*>();
        QVERIFY(canvas != nullptr);
        const QImage shown = canvas->grabFramebuffer();
        const QPoint middle(shown.width() / 2, shown.height() / 2);
        QVERIFY(lightness(shown, middle) > lightness(shown, {10, 10}) + 30);
        QVERIFY(!m_area->rendererDescription().isEmpty());
        const QImage picture = test::pictureOf(*m_area, {120, 100});
        QCOMPARE(picture.size(), QSize(120, 100));
        QVERIFY(lightness(picture, {60, 50}) > lightness(picture, {3, 3}) + 30);
    }

    /// As after a reset of the driver, which none here can be made to do.
    void aLostContextCostsAFrame()
    {
        QSignalSpy drawn(m_area, &view::HeadView::frameDrawn);
        m_window->show();
        QTRY_VERIFY_WITH_TIMEOUT(drawn.count() >= 1, test::kPatienceMs);
        const QImage before = test::pictureOf(*m_area, {120, 100});
        QSignalSpy told(m_area, &view::HeadView::glUnavailable);
        const auto answers =
            std::exchange(epoxy_glGetGraphicsResetStatusARB, []() -> GLenum { return GL_UNKNOWN_CONTEXT_RESET_ARB; });
        drawn.clear();
        m_area->findChild<QOpenGLWidget*>()->update();
        QTRY_COMPARE_WITH_TIMEOUT(told.count(), 1, test::kPatienceMs);
        epoxy_glGetGraphicsResetStatusARB = answers;
        QTRY_VERIFY_WITH_TIMEOUT(drawn.count() >= 1, test::kPatienceMs);
        QVERIFY(m_area->findChild<QOpenGLWidget*>() == nullptr);
        const QImage after = test::pictureOf(*m_area, {120, 100});
        QVERIFY(std::abs(lightness(after, {60, 50}) - lightness(before, {60, 50})) < 6);
    }

    void itIsDrawnAgainInAnotherWindow()
    {
        QSignalSpy drawn(m_area, &view::HeadView::frameDrawn);
        m_window->show();
        QTRY_VERIFY_WITH_TIMEOUT(drawn.count() >= 1, test::kPatienceMs);
        // As when a dock floats: Qt makes the context anew.
        QMainWindow other;
        other.resize(480, 400);
        other.setCentralWidget(m_window->takeCentralWidget());
        drawn.clear();
        other.show();
        QTRY_VERIFY_WITH_TIMEOUT(drawn.count() >= 1, test::kPatienceMs);
        const QImage shown = m_area->findChild<QOpenGLWidget*>()->grabFramebuffer();
        QVERIFY(lightness(shown, {shown.width() / 2, shown.height() / 2}) > lightness(shown, {10, 10}) + 30);
    }

    void aClickOnTheHeadPaints()
    {
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QTest::mouseClick(m_area, Qt::LeftButton, Qt::NoModifier, m_area->rect().center());
        QCOMPARE(m_editor->document.undoStack().count(), 1);
    }

    void aStillPictureIsRefinedWhileEventsAreHandled()
    {
        Presented p(m_hairy);
        p.window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&p.window));
        p.present(false);
        QVERIFY(p.turnsToNextFrame() > 0);
        QVERIFY(!p.refines && p.hairs < p.shot.allHairs);
        p.present(true);
        const std::size_t moving = p.hairs;
        do {
            // Begun in one turn, stepped in others.
            QVERIFY(p.turnsToNextFrame() >= 2);
        } while (p.refines);
        QVERIFY(p.hairs > moving);
        QCOMPARE(p.hairs, p.shot.allHairs);
        // What is shown is what is saved.
        QImage shown = canvasOf(p).grabFramebuffer();
        QVERIFY(shown.reinterpretAsFormat(QImage::Format_RGB32)); // Not every system's window has an alpha.
        QCOMPARE(test::differingPixels(shown, p.presenter.grab(p.shot.scene, shown.size()), shown.rect()), 0);
    }

    void aRepaintShowsTheLastPictureAgain()
    {
        Presented p(m_hairy);
        p.window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&p.window));
        p.present(false);
        p.present(true);
        QVERIFY(p.turnsToNextFrame() > 0);
        while (p.refines && p.hairs < p.shot.allHairs / 4)
            QVERIFY(p.turnsToNextFrame() > 0);
        QVERIFY(p.refines);
        QCoreApplication::processEvents(); // The next one is begun.
        // While a finer one is under way, and after the last one.
        for (const bool finest : {false, true}) {
            QVERIFY(!finest || p.refined());
            const QImage before = canvasOf(p).grabFramebuffer();
            const int frames = p.frames;
            p.present(true); // Nothing new.
            QCOMPARE(test::differingPixels(canvasOf(p).grabFramebuffer(), before, before.rect()), 0);
            QCOMPARE(p.frames, frames);
        }
        // Another size is another picture.
        p.presenter.widget().resize(160, 200);
        QVERIFY(p.turnsToNextFrame() > 0);
        QVERIFY(p.refines && p.hairs < p.shot.allHairs);
        QVERIFY(p.refined());
    }

    void aSavedPictureDropsTheFineOneUnderWay()
    {
        Presented p(m_hairy);
        p.window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&p.window));
        p.present(true);
        QVERIFY(p.turnsToNextFrame() > 0);
        QVERIFY(p.refines);
        p.window.hide(); // Nothing is painted meanwhile.
        QCoreApplication::processEvents();
        const QSize size(60, 50);
        QVERIFY(!p.presenter.grab(p.shot.scene, size).isNull());
        const int frames = p.frames;
        for (int turn = 0; turn < 10; ++turn)
            QCoreApplication::processEvents();
        QCOMPARE(p.frames, frames);
        p.window.show();
        QVERIFY(p.turnsToNextFrame() > 0);
        QVERIFY(p.refines && p.hairs < p.shot.allHairs);
        QVERIFY(p.refined());
    }

    void inputDropsTheFinePictureUnderWay_data()
    {
        QTest::addColumn<bool>("moves");
        QTest::addColumn<bool>("still");
        QTest::newRow("the view turns") << true << false;
        QTest::newRow("nothing differs but may soon") << false << false;
        QTest::newRow("another still moment") << true << true;
    }

    void inputDropsTheFinePictureUnderWay()
    {
        QFETCH(bool, moves);
        QFETCH(bool, still);
        Presented p(m_hairy);
        p.window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&p.window));
        p.present(false);
        QVERIFY(p.turnsToNextFrame() > 0);
        const std::size_t moving = p.hairs;
        p.present(true);
        do {
            QVERIFY(p.turnsToNextFrame() > 0);
        } while (p.refines && 2 * p.hairs < 3 * moving);
        QVERIFY(p.refines);
        const std::size_t finer = p.hairs;
        const int frames = p.frames;
        QCoreApplication::processEvents(); // The next one is begun.
        QCOMPARE(p.frames, frames);
        if (moves)
            p.shot.scene.camera.azimuthRad += 0.5F;
        p.present(still);
        QVERIFY(p.turnsToNextFrame() > 0);
        QCOMPARE(p.frames, frames + 1);
        QVERIFY(p.hairs < finer);
        QCOMPARE(p.refines, still);
        p.present(true);
        QVERIFY(p.turnsToNextFrame() > 0);
        QVERIFY(p.refined());
    }

    void theWheelEndsTheRefiningInTheWindow()
    {
        m_area->setFrame(m_hairy.scene.hair);
        auto* presenter = m_area->findChild<view::FramePresenter*>();
        QVERIFY(presenter != nullptr);
        // The wheel turns as soon as refining begins: how long it would take depends on the machine.
        int begun = 0;
        bool refines = false;
        bool wentOn = false;
        std::size_t shown = 0;
        std::size_t shownAtTheEnd = 0;
        QObject watching; // Ends the connections before what they write to.
        QObject::connect(m_area, &view::HeadView::frameDrawn, &watching,
                         [&](const rendering::FrameStatistics& statistics) { shown = statistics.drawnHairs; });
        QObject::connect(presenter, &view::FramePresenter::refining, &watching, [&](bool on) {
            if (on && !refines && ++begun == 1)
                QMetaObject::invokeMethod(
                    &watching,
                    [&] {
                        wheelAtTheMiddle();
                        wentOn = refines;
                    },
                    Qt::QueuedConnection);
            if (!on && refines && begun == 1)
                shownAtTheEnd = shown;
            refines = on;
        });
        m_window->show();
        QTRY_VERIFY_WITH_TIMEOUT(shownAtTheEnd > 0, test::kPatienceMs);
        QVERIFY(wentOn);
        QVERIFY(shownAtTheEnd < m_hairy.allHairs);
        QTRY_VERIFY_WITH_TIMEOUT(begun > 1, test::kPatienceMs); // Still again.
    }

private:
    void wheelAtTheMiddle()
    {
        const QPointF middle = m_area->rect().center();
        QWheelEvent wheel(middle, m_area->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(m_area, &wheel);
    }

    [[nodiscard]] static QOpenGLWidget& canvasOf(Presented& p)
    {
        return *qobject_cast<QOpenGLWidget*>(&p.presenter.widget());
    }

    model::Project m_project; ///< Project of the hairy ball.
    view::Shot m_hairy;       ///< The ball with hair all over, too much for a moving picture.
    std::unique_ptr<test::Editor> m_editor;
    std::unique_ptr<QMainWindow> m_window;
    view::HeadView* m_area = nullptr; ///< Owned by a window.
};

HAIRPAINT_TEST(GlPresenterTest, Widgets)
#include "test_gl_presenter.moc"
