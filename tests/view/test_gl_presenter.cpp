// The QOpenGLWidget of the 3D area, in a real window: run on xcb under Xvfb.
#include "tests/support/test_program.h"
#include "tests/support/view_fixture.h"
#include "view/head_view.h"

#include <QMainWindow>
#include <QOpenGLWidget>
#include <QSignalSpy>
#include <QTest>

using namespace hairpaint;

namespace {

int lightness(const QImage& image, QPoint at)
{
    return image.isNull() ? -1 : image.pixelColor(at).lightness();
}

} // namespace

class GlPresenterTest : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_editor = std::make_unique<test::Editor>(test::makeProject(test::makeBallHead()));
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
        QTRY_VERIFY(drawn.count() >= 1);
        auto* canvas = m_area->findChild<QOpenGLWidget*>();
        QVERIFY(canvas != nullptr);
        const QImage shown = canvas->grabFramebuffer();
        const QPoint middle(shown.width() / 2, shown.height() / 2);
        QVERIFY(lightness(shown, middle) > lightness(shown, {10, 10}) + 30);
        QVERIFY(!m_area->rendererDescription().isEmpty());
        const QImage picture = m_area->grabPicture({120, 100});
        QCOMPARE(picture.size(), QSize(120, 100));
        QVERIFY(lightness(picture, {60, 50}) > lightness(picture, {3, 3}) + 30);
    }

    void itIsDrawnAgainInAnotherWindow()
    {
        QSignalSpy drawn(m_area, &view::HeadView::frameDrawn);
        m_window->show();
        QTRY_VERIFY(drawn.count() >= 1);
        // As when a dock floats: Qt makes the context anew.
        QMainWindow other;
        other.resize(480, 400);
        other.setCentralWidget(m_window->takeCentralWidget());
        drawn.clear();
        other.show();
        QTRY_VERIFY(drawn.count() >= 1);
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

private:
    std::unique_ptr<test::Editor> m_editor;
    std::unique_ptr<QMainWindow> m_window;
    view::HeadView* m_area = nullptr; ///< Owned by a window.
};

HAIRPAINT_TEST(GlPresenterTest, Widgets)
#include "test_gl_presenter.moc"
