// Combing in the real window, in both areas.
#include "sim/groom/direction_texel.h"
#include "sim/skin/skin_frame.h"
#include "tests/app/window_fixture.h"
#include "tests/support/test_program.h"

namespace hairpaint::app {

class TestWindowComb : public QObject, private WindowFixture
{
    Q_OBJECT
private:
    [[nodiscard]] QWidget& paper() { return m_window->paintView(); }

    /// Hd, where the direction map says that hair at a point of the paper goes.
    [[nodiscard]] glm::vec3 directionAt(glm::vec2 uv)
    {
        const model::HairGroup& group = session().document().project().groups.front();
        const sim::TiledRaster& layer = group.map(model::MapKind::Direction).layers.front().raster;
        const auto point = session().document().project().head->skin->atUv(uv);
        return sim::SkinFrame::at(*point).toHd(sim::directionOf(layer.sampleNearest(uv)));
    }

private Q_SLOTS:
    void initTestCase() { prepareApplication(); }
    void cleanup() { m_window.reset(); }

    void aStrokeLaysHairAlongItself_data()
    {
        QTest::addColumn<bool>("onTheHead");
        QTest::newRow("on the paper") << false;
        QTest::newRow("on the head") << true;
    }
    void aStrokeLaysHairAlongItself()
    {
        QFETCH(bool, onTheHead);
        openWindow(model::newProject());
        key(Qt::Key_2);
        QCOMPARE(editor().target().map(), model::MapKind::Length);
        key(Qt::Key_C);
        QCOMPARE(editor().tools().active().id(), model::ToolId::Comb);
        QCOMPARE(editor().target().map(), model::MapKind::Direction);
        key(Qt::Key_2); // Another map is looked at; the comb brings its own back.

        const view::HeadView& head = m_window->headView();
        const QPoint middle(300, 200);
        const QPoint start = onTheHead ? middle - QPoint(30, 0) : paintPoint(0.45F, 0.5F);
        const QPoint end = onTheHead ? middle + QPoint(30, 0) : paintPoint(0.55F, 0.5F);
        QWidget* area = &paper();
        if (onTheHead) {
            const auto there = head.skinAt(QPointF(middle)).value_or(sim::SurfacePoint{});
            area = onHead(there.uv.x, there.uv.y).first;
        }
        const auto pointAt = [&](QPoint position) {
            if (onTheHead)
                return head.skinAt(QPointF(position)).value_or(sim::SurfacePoint{});
            const glm::vec2 uv = m_window->paintView().uvAt(QPointF(position));
            return session().document().project().head->skin->atUv(uv).value_or(sim::SurfacePoint{});
        };
        const glm::vec3 directionHd = glm::normalize(pointAt(end).positionHd - pointAt(start).positionHd);
        const glm::vec2 uv = pointAt((start + end) / 2).uv;

        QTest::mouseMove(area, start);
        QTest::mousePress(area, Qt::LeftButton, {}, start);
        for (int i = 1; i <= 15; ++i)
            QTest::mouseMove(area, start + (end - start) * i / 15);
        QVERIFY(editor().tools().stroking());
        QCOMPARE(editor().target().map(), model::MapKind::Direction);
        QTest::mouseRelease(area, Qt::LeftButton, {}, end);
        QCOMPARE(stack().count(), 1);
        QCOMPARE(stack().text(0), QStringLiteral("Comb on Direction"));

        const glm::vec3 laid = directionAt(uv);
        QVERIFY2(glm::dot(glm::normalize(laid), directionHd) > 0.97F,
                 qPrintable(QStringLiteral("%1").arg(glm::dot(glm::normalize(laid), directionHd))));
        QVERIFY(std::abs(glm::length(laid) - 0.9F) < 0.05F);
        key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(glm::length(directionAt(uv)), 0.0F);
    }

    void theFieldIsSeenOnThePaper()
    {
        openWindow(model::newProject());
        key(Qt::Key_0);
        QCOMPARE(editor().target().map(), model::MapKind::Direction);
        const QImage before = paper().grab().toImage();
        key(Qt::Key_C);
        drag(paper(), paintPoint(0.4F, 0.5F), paintPoint(0.6F, 0.5F));
        const QImage after = paper().grab().toImage();
        QVERIFY(difference(before, after) > 0.005);
    }
};

} // namespace hairpaint::app

HAIRPAINT_TEST(hairpaint::app::TestWindowComb, Widgets)
#include "test_window_comb.moc"
