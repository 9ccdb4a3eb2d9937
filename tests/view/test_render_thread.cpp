// The thread that draws off screen ends when it is told to, not when its picture is done.
#include "head_fixture.h"
#include "tests/support/await.h"
#include "tests/support/test_program.h"
#include "view/head/render_thread.h"

#include <QSignalSpy>
#include <QThread>

#include <atomic>
#include <thread>

using namespace hairpaint;
using namespace hairpaint::test;

class RenderThreadTest : public QObject
{
    Q_OBJECT
private:
    static constexpr QSize kLarge{800, 800};

    /// Of hair that takes long to be drawn finely.
    static view::Shot stillShot(HeadFixture& f)
    {
        f.area.hide();
        const model::LayerAddress at = f.editor.state.target();
        f.editor.document.apply({}, [at](model::Project& project) {
            project.layer(at.group, at.map, at.layer)->raster = sim::TiledRaster(256, 2, {65535, 65535});
        });
        f.area.setFrame(f.frame());
        const rendering::Scene scene = f.area.pictureScene();
        return {.scene = scene, .allHairs = scene.hair->hairCount, .still = true};
    }

    /// What the thread tells, heard on it while it draws.
    struct Told
    {
        explicit Told(view::RenderThread& thread)
        {
            QObject::connect(&thread, &view::RenderThread::frameReady, [this] { ++frames; });
            QObject::connect(&thread, &view::RenderThread::pieceDrawn, [this] {
                ++pieces;
                if (frames != holdsAfter)
                    return;
                isHeld = true;
                while (!isLetGo && !QThread::currentThread()->isInterruptionRequested())
                    std::this_thread::yield();
            });
        }
        std::atomic<int> frames = 0;
        std::atomic<int> pieces = 0;
        std::atomic<int> holdsAfter = -1; ///< After so many frames the next piece waits until it is let go.
        std::atomic<bool> isHeld = false;
        std::atomic<bool> isLetGo = false;
    };

    /// How many steps it takes until the picture is as fine as it gets; 0 where that never comes.
    static int stepsOf(const view::Shot& shot)
    {
        view::RenderThread thread;
        QSignalSpy ready(&thread, &view::RenderThread::frameReady);
        thread.draw(shot, kLarge);
        for (int steps = 1; ready.wait(kPatienceMs); ++steps)
            if (const auto frame = thread.takeFrame(); frame && !frame->refines)
                return steps;
        return 0;
    }

private Q_SLOTS:
    void closingGivesUpTheFinePicture()
    {
        HeadFixture f;
        const view::Shot shot = stillShot(f);
        QVERIFY(shot.allHairs > 10'000);
        const int all = stepsOf(shot);
        QVERIFY(all > 1);
        auto thread = std::make_unique<view::RenderThread>();
        Told told(*thread);
        told.holdsAfter = all - 1; // In the last and longest step.
        thread->draw(shot, kLarge);
        QVERIFY(awaitUntil([&] { return told.isHeld.load(); }));
        const int pieces = told.pieces;
        thread.reset();
        QCOMPARE(told.pieces.load(), pieces);
        QCOMPARE(told.frames.load(), all - 1);
    }

    void anotherPictureEndsTheFineOne()
    {
        HeadFixture f;
        const view::Shot still = stillShot(f);
        const int all = stepsOf(still);
        QVERIFY(all > 1);
        view::RenderThread thread;
        Told told(thread);
        told.holdsAfter = all - 1;
        thread.draw(still, kLarge);
        QVERIFY(awaitUntil([&] { return told.isHeld.load(); }));
        const int pieces = told.pieces;
        QCoreApplication::processEvents(); // Of the frames before.
        (void)thread.takeFrame();
        QSignalSpy ready(&thread, &view::RenderThread::frameReady);
        view::Shot moving = still;
        moving.still = false;
        thread.draw(moving, kLarge / 8);
        told.isLetGo = true;
        QVERIFY(ready.wait(kPatienceMs));
        const auto frame = thread.takeFrame();
        QVERIFY(frame);
        QCOMPARE(frame->image.size(), kLarge / 8);
        QCOMPARE(told.pieces.load(), pieces);
        QCOMPARE(told.frames.load(), all);
    }
};

HAIRPAINT_TEST(RenderThreadTest, Widgets)
#include "test_render_thread.moc"
