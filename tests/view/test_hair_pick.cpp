// Taking hold of hair in the 3D area.
#include "head_fixture.h"
#include "sim/groom/direction_texel.h"
#include "sim/skin/skin_frame.h"
#include "tests/support/test_program.h"
#include "view/picking/hair_pick.h"

#include <QTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

constexpr float kHairM = 0.05F;

/// The ball, with straight hair of 5 cm standing all over it.
struct HairyBall : HeadFixture
{
    HairyBall()
    {
        fill(model::MapKind::Density, 65535);
        standing = std::make_shared<sim::StrandFrame>(*frame());
        for (sim::GroupFrame& one : standing->groups) {
            const sim::Groom& groom = *one.groom;
            for (std::size_t slot = 0; slot < groom.roots->count(); ++slot)
                for (int i = 0; i < groom.nodes && groom.isDrawn(slot); ++i)
                    groom.blocks().setNode(one.positions, groom.frameStrand(slot), static_cast<std::size_t>(i),
                                           groom.roots->positionHd[slot] +
                                               groom.roots->normalHd[slot] * (kHairM * static_cast<float>(i) /
                                                                              static_cast<float>(groom.nodes - 1)));
        }
        area.setFrame(standing);
        editor.state.tools().setHair(standing);
        editor.state.tools().choose(model::ToolId::Grab);
        steps = editor.document.undoStack().count();
    }

    [[nodiscard]] std::optional<model::GrabbedHair> near(QPointF at, float furthestM = 10.0F) const
    {
        return view::hairNear(at, *standing, editor.state.target().group(), area.camera(), QSizeF(area.size()),
                              furthestM);
    }
    [[nodiscard]] glm::vec3 directionAt(const sim::SurfacePoint& point) const
    {
        const auto map = editor.document.resolved(editor.state.target().group(), model::MapKind::Direction);
        return sim::SkinFrame::at(point).toHd(sim::directionOf(map->sampleNearest(point.uv)));
    }

    std::shared_ptr<sim::StrandFrame> standing;
    int steps = 0; ///< Number of steps of the history before anything is grabbed.
};

} // namespace

class TestHairPick : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theHairUnderThePointerIsFound()
    {
        const HairyBall f;
        // Beside the ball, 3 cm up a hair that stands out to the right.
        const QPointF at = f.area.positionOf({kBallM + 0.03F, 0.0F, 0.0F}).value_or(QPointF());
        const std::optional<model::GrabbedHair> hair = f.near(at);
        QVERIFY(hair.has_value());
        QVERIFY(QLineF(f.area.positionOf(hair->positionHd).value_or(QPointF()), at).length() <= view::kHairReachPx);
        QVERIFY(std::abs(glm::length(hair->positionHd) - kBallM - hair->alongM) < 0.003F);
        QVERIFY(hair->alongM > 0.015F && hair->alongM <= kHairM + 1e-4F);
        QVERIFY(glm::distance(glm::normalize(hair->root.positionHd), glm::normalize(hair->positionHd)) < 0.05F);
    }

    void theNearestToTheEyeIsTaken()
    {
        const HairyBall f;
        const std::optional<model::GrabbedHair> hair = f.near(QPointF(kMiddle));
        QVERIFY(hair.has_value());
        QVERIFY(hair->positionHd.z > kBallM + 0.8F * kHairM);
        QVERIFY(hair->root.positionHd.z > 0.9F * kBallM);
    }

    void nothingIsFoundFarFromHairBehindTheSkinOrInAnotherGroup()
    {
        const HairyBall f;
        QVERIFY(!f.near(QPointF(kBackground)));
        QVERIFY(!f.near(QPointF(kMiddle), f.area.camera().distanceM - kBallM - 2.0F * kHairM));
        QVERIFY(!view::hairNear(QPointF(kMiddle), *f.standing, f.editor.state.target().group() + 1, f.area.camera(),
                                QSizeF(f.area.size()), 10.0F));
    }

    void draggedHairGoesWithThePointerBesideTheHeadToo()
    {
        HairyBall f;
        const glm::vec3 heldHd(kBallM + 0.03F, 0.0F, 0.0F);
        const QPointF from = f.area.positionOf(heldHd).value_or(QPointF());
        const QPointF to = f.area.positionOf(heldHd + glm::vec3(-0.01F, 0.05F, 0.0F)).value_or(QPointF());
        const sim::SurfacePoint root = f.near(from.toPoint()).value_or(model::GrabbedHair{}).root;
        QTest::mousePress(&f.area, Qt::LeftButton, {}, from.toPoint());
        QVERIFY(f.editor.state.tools().stroking());
        f.move(from + (to - from) * 0.5, Qt::LeftButton, {});
        f.move(to, Qt::LeftButton, {});
        const glm::vec3 live = f.directionAt(root);
        QVERIFY2(live.y > 0.5F, qPrintable(QString::number(double(live.y))));
        QCOMPARE(f.editor.document.undoStack().count(), f.steps);
        QTest::mouseRelease(&f.area, Qt::LeftButton, {}, to.toPoint());
        QCOMPARE(f.editor.document.undoStack().count(), f.steps + 1);
        QCOMPARE(f.editor.document.undoStack().undoText(), QStringLiteral("Grab"));
        f.editor.document.undo();
        QCOMPARE(f.directionAt(root), glm::vec3(0.0F));
    }

    void escapeLetsGo()
    {
        HairyBall f;
        QTest::mousePress(&f.area, Qt::LeftButton, {}, kMiddle);
        f.move(kMiddle + QPoint(60, 0), Qt::LeftButton, {});
        QVERIFY(f.editor.document.previewing());
        QTest::keyClick(&f.area, Qt::Key_Escape);
        QVERIFY(!f.editor.state.tools().stroking());
        QCOMPARE(f.editor.document.undoStack().count(), f.steps);
    }

    void withoutHairBelowTheViewIsOrbited()
    {
        HairyBall f;
        f.area.setFrame(std::make_shared<sim::StrandFrame>());
        const rendering::Camera before = f.area.camera();
        f.drag(kMiddle, kMiddle + QPoint(50, 0));
        QVERIFY(f.area.camera().azimuthRad < before.azimuthRad - 0.1F);
        QCOMPARE(f.editor.document.undoStack().count(), f.steps);
    }
};

HAIRPAINT_TEST(TestHairPick, Widgets)
#include "test_hair_pick.moc"
