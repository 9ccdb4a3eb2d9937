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
private Q_SLOTS:
    void closingGivesUpTheFinePicture()
    {
        HeadFixture f;
        f.area.hide();
        const model::LayerAddress at = f.editor.state.target();
        f.editor.document.apply({}, [at](model::Project& project) {
            project.layer(at.group, at.map, at.layer)->raster = sim::TiledRaster(256, 2, {65535, 65535});
        });
        f.area.setFrame(f.frame());
        const rendering::Scene scene = f.area.pictureScene();
        QVERIFY(scene.hair && scene.hair->hairCount > 10'000);
        const view::Shot shot{.scene = scene, .allHairs = scene.hair->hairCount, .still = true};
        // All steps once: how many there are, and how long the last one takes.
        int steps = 0;
        qint64 lastMs = 0;
        const auto run = [&](int wanted) -> qint64 {
            auto thread = std::make_unique<view::RenderThread>();
            QSignalSpy ready(thread.get(), &view::RenderThread::frameReady);
            thread->draw(shot, {800, 800});
            QElapsedTimer timer;
            bool refines = true;
            for (int step = 0; refines && (wanted == 0 || step < wanted); ++step) {
                timer.start();
                if (!ready.wait(60'000))
                    return -1;
                if (const auto frame = thread->takeFrame())
                    refines = frame->refines;
                lastMs = timer.elapsed();
                steps = wanted == 0 ? step + 1 : steps;
            }
            timer.start();
            thread.reset();
            return timer.elapsed();
        };
        QVERIFY(run(0) >= 0);
        const qint64 wholeMs = lastMs;
        QVERIFY(steps > 1);
        const qint64 closingMs = run(steps - 1);
        QVERIFY(closingMs >= 0 && closingMs < wholeMs / 2);
    }
};

HAIRPAINT_TEST(RenderThreadTest, Widgets)
#include "test_render_thread.moc"
