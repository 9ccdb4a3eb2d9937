// The thread that draws off screen ends when it is told to, not when its picture is done.
#include "head_fixture.h"
#include "tests/support/test_program.h"
#include "view/head/render_thread.h"

#include <QElapsedTimer>
#include <QSignalSpy>

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

    struct Steps
    {
        int count = 0;
        qint64 lastMs = 0;
    };

    /// Draws a still picture step by step, all of it or only so many; none where one does not come.
    static Steps refine(view::RenderThread& thread, const view::Shot& shot, int most = 100)
    {
        QSignalSpy ready(&thread, &view::RenderThread::frameReady);
        thread.draw(shot, kLarge);
        Steps steps;
        QElapsedTimer timer;
        for (bool refines = true; refines && steps.count < most; ++steps.count) {
            timer.start();
            if (!ready.wait(60'000))
                return {};
            if (const auto frame = thread.takeFrame())
                refines = frame->refines;
            steps.lastMs = timer.elapsed();
        }
        return steps;
    }

    static Steps allStepsOf(const view::Shot& shot)
    {
        view::RenderThread thread;
        return refine(thread, shot);
    }

    /// Into the last and longest step, as far as it takes here.
    static bool goIntoTheLast(view::RenderThread& thread, const view::Shot& shot, const Steps& all)
    {
        const int before = refine(thread, shot, all.count - 1).count;
        QTest::qWait(static_cast<int>(all.lastMs / 4));
        return before == all.count - 1;
    }

private Q_SLOTS:
    void closingGivesUpTheFinePicture()
    {
        HeadFixture f;
        const view::Shot shot = stillShot(f);
        QVERIFY(shot.allHairs > 10'000);
        const Steps all = allStepsOf(shot);
        QVERIFY(all.count > 1);
        auto thread = std::make_unique<view::RenderThread>();
        QVERIFY(goIntoTheLast(*thread, shot, all));
        QElapsedTimer timer;
        timer.start();
        thread.reset();
        QVERIFY(timer.elapsed() < all.lastMs / 2);
    }

    void anotherPictureEndsTheFineOne()
    {
        HeadFixture f;
        const view::Shot still = stillShot(f);
        const Steps all = allStepsOf(still);
        QVERIFY(all.count > 1);
        view::RenderThread thread;
        QVERIFY(goIntoTheLast(thread, still, all));
        QSignalSpy ready(&thread, &view::RenderThread::frameReady);
        view::Shot moving = still;
        moving.still = false;
        thread.draw(moving, kLarge / 8);
        QVERIFY(ready.wait(60'000));
        const auto frame = thread.takeFrame();
        QVERIFY(frame);
        QCOMPARE(frame->image.size(), kLarge / 8);
    }
};

HAIRPAINT_TEST(RenderThreadTest, Widgets)
#include "test_render_thread.moc"
