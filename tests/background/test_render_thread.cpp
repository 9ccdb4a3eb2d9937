// The thread that draws off screen ends when it is told to, not when its picture is done.
#include "sim/motion/simulation.h"
#include "tests/support/await.h"
#include "tests/support/painted_ball.h"
#include "tests/support/test_program.h"
#include "view/head_area/render_thread.h"

#include <QThread>
#include <QtTest>

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

using namespace hairpaint;
using namespace hairpaint::test;

class RenderThreadTest : public QObject
{
    Q_OBJECT
private:
#if defined(__SANITIZE_THREAD__)
    static constexpr QSize kLarge{240, 240};
#else
    static constexpr QSize kLarge{800, 800};
#endif
    static constexpr int kHairs = 12'000;

    /// A still picture of hair that takes long to draw.
    static view::Shot stillShot()
    {
        sim::Simulation simulation;
        simulation.setInput(paintedBall(kHairs, 500));
        simulation.advance(1.0 / 60.0);
        auto frame = std::make_shared<sim::StrandFrame>();
        simulation.writeFrame(*frame);
        rendering::Scene scene;
        scene.head = std::make_shared<const sim::HeadMesh>(makeBallHead());
        scene.hair = frame;
        scene.camera.targetWo = glm::vec3(0.0F);
        scene.camera.distanceM = 0.6F;
        return {.scene = scene, .allHairs = frame->hairCount, .still = true};
    }

    /// What the thread tells, heard on it while it draws.
    struct Told
    {
        void listenTo(view::RenderThread& thread)
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
        Told told;
        auto thread = std::make_unique<view::RenderThread>();
        told.listenTo(*thread);
        thread->draw(shot, kLarge);
        const bool isDone = awaitUntil([&] {
            const std::optional<view::RenderThread::Frame> frame = thread->takeFrame();
            return frame && !frame->refines;
        });
        thread.reset(); // It tells of a frame after that can be taken.
        return isDone ? told.frames.load() : 0;
    }

private Q_SLOTS:
    void closingGivesUpTheFinePicture()
    {
        const view::Shot shot = stillShot();
        QVERIFY(shot.allHairs > 10'000);
        const int all = stepsOf(shot);
        QVERIFY(all > 1);
        Told told;
        auto thread = std::make_unique<view::RenderThread>();
        told.listenTo(*thread);
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
        const view::Shot still = stillShot();
        const int all = stepsOf(still);
        QVERIFY(all > 1);
        Told told;
        view::RenderThread thread;
        told.listenTo(thread);
        told.holdsAfter = all - 1;
        thread.draw(still, kLarge);
        QVERIFY(awaitUntil([&] { return told.isHeld.load(); }));
        const int pieces = told.pieces;
        (void)thread.takeFrame();
        view::Shot moving = still;
        moving.still = false;
        thread.draw(moving, kLarge / 8);
        told.isLetGo = true;
        QVERIFY(awaitUntil([&] { return told.frames == all; }));
        const auto frame = thread.takeFrame();
        QVERIFY(frame);
        QCOMPARE(frame->image.size(), kLarge / 8);
        QCOMPARE(told.pieces.load(), pieces);
        QCOMPARE(told.frames.load(), all);
    }
};

HAIRPAINT_TEST(RenderThreadTest, Gui)
#include "test_render_thread.moc"
