// The 3D area driven by mouse, wheel and keys; its pictures come from an off-screen context.
#include "head_fixture.h"
#include "model/document/scene_commands.h"
#include "tests/support/head_picture.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/head_area/head_camera.h"
#include "view/head_area/head_overlay.h"
#include "view/head_area/head_view.h"
#include "view/head_area/puff_gesture.h"

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <random>

using namespace hairpaint;
using namespace hairpaint::test;

class HeadViewTest : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void raysAndProjectionAgree_data()
    {
        QTest::addColumn<float>("azimuth");
        QTest::addColumn<float>("elevation");
        QTest::newRow("front") << 0.0F << 0.0F;
        QTest::newRow("side and above") << 1.3F << 0.7F;
        QTest::newRow("straight down") << 0.4F << 1.5707963F;
    }
    void raysAndProjectionAgree()
    {
        QFETCH(float, azimuth);
        QFETCH(float, elevation);
        rendering::Camera camera = HeadFixture::camera();
        camera.azimuthRad = azimuth;
        camera.elevationRad = elevation;
        const QSizeF size(480.0, 400.0);
        for (const QPointF at : {QPointF(240, 200), QPointF(10, 30), QPointF(470, 390)}) {
            const view::RayWo ray = view::rayThrough(camera, at, size);
            const std::optional<QPointF> back = view::project(camera, ray.originWo + ray.directionWo * 0.5F, size);
            QVERIFY(back.has_value());
            QVERIFY(QLineF(*back, at).length() < 0.05);
        }
    }

    void paintingHitsTheSkinThatShowsThere_data()
    {
        QTest::addColumn<QPoint>("at");
        QTest::addColumn<bool>("turned");
        QTest::newRow("middle") << kMiddle << false;
        QTest::newRow("cheek") << QPoint(285, 230) << false;
        QTest::newRow("head turned") << QPoint(210, 170) << true;
    }
    void paintingHitsTheSkinThatShowsThere()
    {
        QFETCH(QPoint, at);
        QFETCH(bool, turned);
        HeadFixture f;
        if (turned) {
            auto frame = std::make_shared<sim::StrandFrame>();
            frame->pose.rotation = glm::angleAxis(0.6F, glm::vec3(0.0F, 1.0F, 0.0F));
            f.area.setFrame(frame);
        }
        const std::optional<sim::SurfacePoint> point = f.area.skinAt(at);
        QVERIFY(point.has_value());
        QVERIFY(QLineF(f.area.positionOf(point->positionHd).value_or(QPointF()), at).length() < 0.1);
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, at);
        QCOMPARE(f.editor.document.undoStack().count(), 1);
        QVERIFY(f.editor.density(point->uv) > 0.99F);
        // 5 cm beside it on the ball nothing is painted.
        const glm::vec3 beside = glm::normalize(point->positionHd + glm::vec3(0.0F, 0.05F, 0.0F)) * kBallM;
        QVERIFY(f.editor.density(f.editor.document.project().head->skin->nearest(beside).uv) < 0.01F);
    }

    void draggingTheBackgroundOrbitsAndPaintsNothing_data()
    {
        QTest::addColumn<QPoint>("from");
        QTest::addColumn<int>("button");
        QTest::addColumn<int>("modifiers");
        QTest::newRow("from the background") << kBackground << int(Qt::LeftButton) << int(Qt::NoModifier);
        QTest::newRow("Alt anywhere") << kMiddle << int(Qt::LeftButton) << int(Qt::AltModifier);
        QTest::newRow("right button anywhere") << kMiddle << int(Qt::RightButton) << int(Qt::NoModifier);
    }
    void draggingTheBackgroundOrbitsAndPaintsNothing()
    {
        QFETCH(QPoint, from);
        QFETCH(int, button);
        QFETCH(int, modifiers);
        HeadFixture f;
        const rendering::Camera before = f.area.camera();
        f.drag(from, from + QPoint(50, 40), Qt::MouseButton(button), Qt::KeyboardModifiers(modifiers));
        const rendering::Camera after = f.area.camera();
        QVERIFY(after.azimuthRad < before.azimuthRad - 0.1F);
        QVERIFY(after.elevationRad > before.elevationRad + 0.1F);
        QCOMPARE(after.distanceM, before.distanceM);
        QCOMPARE(f.editor.document.undoStack().count(), 0);
    }

    void theMiddleButtonPans()
    {
        HeadFixture f;
        const glm::vec3 held(0.0F, 0.0F, 0.0F);
        f.drag(kMiddle, kMiddle + QPoint(30, -20), Qt::MiddleButton);
        QVERIFY(QLineF(f.area.positionOf(held).value_or(QPointF()), kMiddle + QPoint(30, -20)).length() < 1.0);
    }

    void theWheelZoomsAtThePointer()
    {
        HeadFixture f;
        const float before = f.area.camera().distanceM;
        const QPointF at(300.0, 150.0);
        // A point at the target's depth.
        const glm::vec3 held(0.06F * (300.0F - 240.0F) / 50.0F, 0.0F, 0.0F);
        const QPointF heldAt = f.area.positionOf(held).value_or(QPointF());
        f.wheel(heldAt, 2);
        QVERIFY(f.area.camera().distanceM < before * 0.85F);
        QVERIFY(QLineF(f.area.positionOf(held).value_or(QPointF()), heldAt).length() < 1.0);
    }

    void aRightClickOpensTheMenuAndMovesNothing()
    {
        HeadFixture f;
        QSignalSpy menu(&f.area, &view::HeadView::contextMenuWanted);
        const rendering::Camera before = f.area.camera();
        QTest::mouseClick(&f.area, Qt::RightButton, Qt::NoModifier, kMiddle);
        QCOMPARE(menu.count(), 1);
        QCOMPARE(f.area.camera(), before);
    }

    void shiftAndRightDragTurnsTheLight()
    {
        HeadFixture f;
        std::vector<std::pair<model::LightSettings, bool>> wanted;
        connect(&f.area, &view::HeadView::lightWanted, &f.area,
                [&](const model::LightSettings& light, bool done) { wanted.emplace_back(light, done); });
        const model::LightSettings before = f.editor.document.project().light;
        f.drag(kMiddle, kMiddle + QPoint(60, 0), Qt::RightButton, Qt::ShiftModifier);
        QVERIFY(wanted.size() >= 2);
        QVERIFY(wanted.back().second);
        QVERIFY(!wanted.front().second);
        QVERIFY(wanted.back().first.azimuthRad > before.azimuthRad + 0.3F);
    }

    void theCollidersAreSeenAroundTheHeadAndGoWithIt()
    {
        HeadFixture f;
        const auto* overlay = f.area.findChild<view::HeadOverlay*>();
        QVERIFY(overlay != nullptr);
        const sim::Ellipsoid ellipsoid{.centreHd = {0.02F, 0.01F, 0.0F}, .semiAxesM = {0.05F, 0.08F, 0.06F}};
        auto head = std::make_shared<model::Head>(*f.editor.document.project().head);
        f.editor.document.push(model::setHeadCommand(f.editor.document, std::move(head), {ellipsoid}));
        QVERIFY(overlay->wornOutlines().empty());
        QVERIFY(f.editor.state.options().setCollidersShown(true));
        QCOMPARE(overlay->wornOutlines().size(), std::size_t{3});
        const auto touches = [&](glm::vec3 positionHd) {
            const QPointF at = f.area.positionOf(positionHd).value_or(QPointF());
            return std::ranges::count_if(overlay->wornOutlines(), [at](const QPolygonF& ellipse) {
                return std::ranges::any_of(ellipse, [at](QPointF p) { return QLineF(p, at).length() < 1e-2; });
            });
        };
        // Two of the three ellipses meet at each end of each axis.
        const auto endsAreTouched = [&] {
            return touches({0.07F, 0.01F, 0.0F}) == 2 && touches({0.02F, 0.09F, 0.0F}) == 2 &&
                   touches({0.02F, 0.01F, -0.06F}) == 2;
        };
        QVERIFY(endsAreTouched());
        f.area.setView(rendering::StandardView::Left);
        QTRY_VERIFY_WITH_TIMEOUT(!f.area.awake(), kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(endsAreTouched(), kPatienceMs);
        const auto frame = std::make_shared<sim::StrandFrame>(*f.frame());
        frame->pose.rotation = glm::angleAxis(0.7F, glm::vec3(0.0F, 1.0F, 0.0F));
        const std::vector<QPolygonF> before = overlay->wornOutlines();
        f.area.setFrame(frame);
        // They lie over a picture in which the head has not turned yet.
        QVERIFY(overlay->wornOutlines() == before);
        QTRY_VERIFY_WITH_TIMEOUT(endsAreTouched(), kPatienceMs);
        f.editor.document.undo();
        QVERIFY(overlay->wornOutlines().empty());
        f.editor.document.redo();
        QVERIFY(f.editor.state.options().setCollidersShown(false));
        QVERIFY(overlay->wornOutlines().empty() && overlay->isHidden());
    }

    void aFastPointerBlowsAPuffAndASlowOneDoesNot()
    {
        view::PuffGesture gesture;
        QVERIFY(!gesture.moved({0.0F, 0.1F, 0.0F}, 1.0));
        QVERIFY(!gesture.moved({0.001F, 0.1F, 0.0F}, 1.016));                              // 6 cm/s
        const std::optional<view::Puff> puff = gesture.moved({0.033F, 0.1F, 0.0F}, 1.032); // 2 m/s
        QVERIFY(puff.has_value());
        QVERIFY(puff->velocity.x > 0.5F && puff->velocity.x <= 2.5F);
        QVERIFY(std::abs(puff->velocity.y) < 1e-5F);
        QVERIFY(!gesture.moved({0.065F, 0.1F, 0.0F}, 1.040)); // Not twice in a moment.
        gesture.interrupt();
        QVERIFY(!gesture.moved({0.3F, 0.1F, 0.0F}, 1.1));
    }

    void thePointerSweepingThroughTheHairBlows()
    {
        HeadFixture f;
        QSignalSpy puffs(&f.area, &view::HeadView::puffWanted);
        ulong time = 1000;
        for (int i = 0; i <= 12; ++i) {
            const QPointF at(140.0 + 16.0 * i, 180.0);
            QMouseEvent event(QEvent::MouseMove, at, f.area.mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                              Qt::NoModifier);
            event.setTimestamp(time += 10);
            QApplication::sendEvent(&f.area, &event);
        }
        QVERIFY(puffs.count() >= 1);
    }

    void hoveringMarksThePointInBothAreas()
    {
        HeadFixture f;
        QTest::mouseMove(&f.area, kMiddle);
        QVERIFY(f.editor.state.hover().at().has_value());
        QCOMPARE(f.editor.state.hover().at()->area, model::Area::Head);
        QVERIFY(glm::length(f.editor.state.hover().at()->uv - f.area.skinAt(kMiddle)->uv) < 1e-6F);
        QTest::mouseMove(&f.area, kBackground);
        QVERIFY(!f.editor.state.hover().at().has_value());
    }

    void escCancelsTheStroke()
    {
        HeadFixture f;
        QTest::mousePress(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        const glm::vec2 uv = f.area.skinAt(kMiddle)->uv;
        QVERIFY(f.editor.density(uv) > 0.99F);
        QTest::keyClick(&f.area, Qt::Key_Escape);
        QTest::mouseRelease(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        QVERIFY(f.editor.density(uv) < 0.01F);
        QCOMPARE(f.editor.document.undoStack().count(), 0);
    }

    void fittingMakesRoomForHairThatStandsUp()
    {
        HeadFixture f;
        f.area.fit();
        const auto topOf = [&f] { return f.area.positionOf({0.0F, 0.1F, 0.0F})->y(); };
        QTRY_VERIFY_WITH_TIMEOUT(topOf() > 0.0, kPatienceMs);
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        const auto frame = std::make_shared<sim::StrandFrame>(*f.frame());
        // The first hair's last node, half a metre up and toward the eye.
        std::vector<float>& positions = frame->groups.front().positions;
        QVERIFY(!positions.empty());
        const glm::vec3 tip = glm::vec3(0.0F, 0.5F, 0.0F) + 0.1F * glm::normalize(f.area.camera().eyeWo());
        sim::StrandBlocks::store(positions.data(), tip);
        f.area.setFrame(frame);
        QVERIFY(f.area.positionOf(tip)->y() < 0.0);
        f.area.fit();
        QTRY_VERIFY_WITH_TIMEOUT(f.area.positionOf(tip)->y() > 0.0, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(!f.area.awake(), kPatienceMs); // The camera is there.
        QVERIFY(f.area.positionOf(tip)->y() < 0.2 * f.area.height());
        // Not for hair that is hidden.
        const auto hidden = std::make_shared<sim::StrandFrame>(*frame);
        const auto groom = std::make_shared<sim::Groom>(*frame->groups.front().groom);
        groom->visible = false;
        hidden->groups.front().groom = groom;
        f.area.setFrame(hidden);
        f.area.fit();
        QTRY_VERIFY_WITH_TIMEOUT(f.area.positionOf(tip)->y() < 0.0, kPatienceMs);
    }

    void standardViewsTurnThere()
    {
        HeadFixture f;
        f.area.setView(rendering::StandardView::Left);
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(f.area.camera().azimuthRad - 1.5708F) < 0.01F, kPatienceMs);
    }

    void hairAppearsWhereADabWasPainted()
    {
        HeadFixture f;
        model::ToolSettings settings = f.editor.state.tools().settings();
        settings.brushSizeM = 0.04F;
        f.editor.state.tools().setSettings(settings);
        f.area.setFrame(f.frame());
        const QImage before = test::pictureOf(f.area, {480, 400});
        QCOMPARE(before.size(), QSize(480, 400));
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        const std::shared_ptr<const sim::StrandFrame> frame = f.frame();
        QVERIFY(frame->hairCount > 100);
        f.area.setFrame(frame);
        const QImage after = test::pictureOf(f.area, {480, 400});
        QVERIFY(differingPixels(before, after, QRect(kMiddle - QPoint(30, 30), QSize(60, 60))) > 200);
        QCOMPARE(differingPixels(before, after, QRect(0, 0, 100, 400)), 0);
    }

    void theAreaShowsTheHead()
    {
        HeadFixture f;
        QSignalSpy drawn(&f.area, &view::HeadView::frameDrawn);
        QTRY_VERIFY_WITH_TIMEOUT(drawn.count() >= 1, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(!f.area.rendererDescription().isEmpty(), kPatienceMs);
        const QImage shown = f.area.grab().toImage();
        QVERIFY(shown.pixelColor(kMiddle).lightness() > shown.pixelColor(kBackground).lightness() + 30);
    }

    void itClosesWhileStillRefining()
    {
        for (int i = 0; i < 4; ++i) {
            HeadFixture f;
            QSignalSpy drawn(&f.area, &view::HeadView::frameDrawn);
            QTRY_VERIFY_WITH_TIMEOUT(drawn.count() >= 1, kPatienceMs);
        }
    }

    void nothingChangedNothingIsDrawn()
    {
        HeadFixture f;
        int drawn = 0;
        connect(&f.area, &view::HeadView::frameDrawn, this, [&] { ++drawn; });
        // Refinement of a still picture comes to an end.
        QTRY_VERIFY_WITH_TIMEOUT(drawn > 0 && !f.area.refining() && !f.area.awake(), kPatienceMs);
        const int before = drawn;
        QCoreApplication::processEvents();
        QVERIFY(!f.area.awake() && !f.area.refining());
        QCOMPARE(drawn, before);
    }
};

HAIRPAINT_TEST(HeadViewTest, Widgets)
#include "test_head_view.moc"
