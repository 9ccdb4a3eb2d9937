// Strokes over the 3D head, where the skin has gaps.
#include "tests/support/test_program.h"
#include "tests/support/view_fixture.h"
#include "view/head_area/head_view.h"

#include <QMouseEvent>
#include <QTest>

using namespace hairpaint;

class TestHeadStrokes : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aStrokeBreaksWhereTheSkinDoes_data()
    {
        QTest::addColumn<int>("events");
        QTest::newRow("slowly") << 60;
        QTest::newRow("in one leap") << 1;
    }
    void aStrokeBreaksWhereTheSkinDoes()
    {
        QFETCH(int, events);
        // A patch with a slit of 5 cm in the middle, as between ear and shoulder.
        sim::HeadMesh mesh = test::makePatchHead();
        std::erase_if(mesh.triangles, [&](const glm::uvec3& corners) {
            const float x = (mesh.uvs[corners.x].x + mesh.uvs[corners.y].x + mesh.uvs[corners.z].x) / 3.0F;
            return x > 0.375F && x < 0.625F;
        });
        test::Editor editor(test::makeProject(std::move(mesh)));
        view::HeadView area(editor.state, view::Theme::of(view::ThemeKind::Dark), view::PresenterChoice::Software);
        area.resize(480, 400);
        rendering::Camera camera;
        camera.targetWo = glm::vec3(0.0F);
        camera.distanceM = 0.6F;
        area.setCamera(camera);
        area.show();
        const QPointF from = area.positionOf({-0.07F, 0.0F, 0.0F}).value();
        const QPointF to = area.positionOf({0.07F, 0.0F, 0.0F}).value();
        const auto send = [&](QEvent::Type type, QPointF at) {
            QMouseEvent event(type, at, area.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                              type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(&area, &event);
        };
        send(QEvent::MouseButtonPress, from);
        for (int i = 1; i <= events; ++i)
            send(QEvent::MouseMove, from + (to - from) * i / events);
        send(QEvent::MouseButtonRelease, to);
        QCOMPARE(editor.document.undoStack().count(), 1);
        for (const float painted : {0.15F, 0.25F, 0.35F, 0.65F, 0.75F, 0.85F})
            QVERIFY2(editor.density({painted, 0.5F}) > 0.9F, qPrintable(QString::number(double(painted))));
        for (const float bare : {0.45F, 0.5F, 0.55F})
            QVERIFY2(editor.density({bare, 0.5F}) < 0.01F, qPrintable(QString::number(double(bare))));
    }
};

HAIRPAINT_TEST(TestHeadStrokes, Widgets)
#include "test_head_strokes.moc"
