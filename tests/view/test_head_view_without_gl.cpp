// Where no OpenGL driver is found the hair is seen all the same.
#include "tests/support/head_picture.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/support/view_fixture.h"
#include "view/head_area/gpu_probe.h"
#include "view/head_area/head_view.h"

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
    void noGpuIsFound() { QVERIFY(!view::hasGpu()); }

    void theHeadIsDrawn()
    {
        test::Editor editor(test::makeProject(test::makeBallHead()));
        view::HeadView area(editor.state, view::Theme::of(view::ThemeKind::Dark));
        QSignalSpy drawn(&area, &view::HeadView::frameDrawn);
        area.resize(480, 400);
        area.show();
        QTRY_VERIFY_WITH_TIMEOUT(drawn.count() >= 1, test::kPatienceMs);
        QVERIFY(!area.rendererDescription().isEmpty());
        const QImage shown = area.grab().toImage();
        QVERIFY(shown.pixelColor(240, 200).lightness() > shown.pixelColor(10, 10).lightness() + 30);
        QCOMPARE(test::pictureOf(area, {64, 64}).size(), QSize(64, 64));
        QVERIFY(area.skinAt({240, 200}).has_value());
        QTest::mouseClick(&area, Qt::LeftButton, Qt::NoModifier, {240, 200});
        QCOMPARE(editor.document.undoStack().count(), 1);
    }
};

HAIRPAINT_TEST(HeadViewWithoutGlTest, Widgets)
#include "test_head_view_without_gl.moc"
