// Where no OpenGL driver is found the 3D area says so and the rest works.
#include "tests/support/test_program.h"
#include "tests/support/view_fixture.h"
#include "view/head/render_thread.h"
#include "view/head_view.h"

#include <QSignalSpy>
#include <QTest>

using namespace hairpaint;

class HeadViewWithoutGlTest : public QObject
{
    Q_OBJECT
public:
    static void initMain()
    {
        // The loader then finds no driver at all.
        qputenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json");
        qputenv("LIBGL_DRIVERS_PATH", "/nonexistent");
    }

private Q_SLOTS:
    void whoListensLateHearsHowItStarted()
    {
        view::RenderThread thread;
        QVERIFY(!thread.waitForStart().works);
        QSignalSpy started(&thread, &view::RenderThread::started);
        QTRY_COMPARE(started.count(), 1);
    }

    void aSentenceStandsInForTheHead()
    {
        test::Editor editor(test::makeProject(test::makeBallHead()));
        view::HeadView area(editor.state, view::Theme::of(view::ThemeKind::Dark));
        QSignalSpy unavailable(&area, &view::HeadView::glUnavailable);
        area.resize(480, 400);
        area.show();
        QTRY_COMPARE(unavailable.count(), 1);
        QVERIFY(!area.missingText().isEmpty());
        QVERIFY(area.grabPicture({64, 64}).isNull());
        // What needs no picture goes on.
        QVERIFY(area.skinAt({240, 200}).has_value());
        QTest::mouseClick(&area, Qt::LeftButton, Qt::NoModifier, {240, 200});
        QCOMPARE(editor.document.undoStack().count(), 1);
    }
};

HAIRPAINT_TEST(HeadViewWithoutGlTest, Widgets)
#include "test_head_view_without_gl.moc"
