// The 3D area tells still hair from moving hair, and shows what state its picture is in.
#include "head_fixture.h"
#include "model/document/scene_commands.h"
#include "tests/support/head_picture.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "view/head_area/frame_presenter.h"
#include "view/head_area/head_overlay.h"
#include "view/head_area/view_signs.h"

#include <QSignalSpy>

using namespace hairpaint;
using namespace hairpaint::test;

class HeadViewStillTest : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void hairThatHangsStillIsRefinedThoughItIsAwake()
    {
        HeadFixture f;
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        f.editor.state.hover().set(std::nullopt);
        const auto frame = std::make_shared<sim::StrandFrame>(*f.frame());
        frame->asleep = false;
        std::size_t drawn = 0;
        int frames = 0;
        connect(&f.area, &view::HeadView::frameDrawn, this, [&](const rendering::FrameStatistics& statistics) {
            drawn = statistics.drawnHairs;
            ++frames;
        });
        f.area.setFrame(frame);
        // Step by step: how many hairs the first picture has is the machine's affair (see test_detail_governor).
        QTRY_VERIFY_WITH_TIMEOUT(frames > 1 && drawn == frame->hairCount && !f.area.refining() && !f.area.awake(),
                                 kPatienceMs);

        // A drift that nobody sees leaves the fine picture alone.
        for (const float distanceM : {1e-5F, 2e-5F}) {
            f.area.setFrame(movedBy(*frame, distanceM));
            QVERIFY(!f.area.awake()); // Nothing is asked to be drawn.
        }
        const int before = frames;
        // What adds up to more than a pixel is shown at once, and refined anew.
        f.area.setFrame(movedBy(*frame, 0.01F));
        QTRY_VERIFY_WITH_TIMEOUT(frames > before + 1, kPatienceMs);
        QTRY_COMPARE_WITH_TIMEOUT(drawn, frame->hairCount, kPatienceMs);
    }

    /// While hair moves, a frame holds only the hairs that are drawn; the finest picture shows the rest once they come.
    void hairThatAStillPictureLacksIsShownWhenItComes()
    {
        HeadFixture f;
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        f.editor.state.hover().set(std::nullopt);
        const std::shared_ptr<const sim::StrandFrame> whole = f.frame();
        const auto coarse = std::make_shared<sim::StrandFrame>(*whole);
        for (sim::GroupFrame& group : coarse->groups)
            group.detail = 0.25F;
        rendering::FrameStatistics last;
        connect(&f.area, &view::HeadView::frameDrawn, this,
                [&](const rendering::FrameStatistics& statistics) { last = statistics; });
        f.area.setFrame(coarse);
        const auto finest = [&] {
            return last.drawnHairs > 0 && last.detail >= 1.0F && !f.area.refining() && !f.area.awake();
        };
        QTRY_VERIFY_WITH_TIMEOUT(finest(), kPatienceMs); // All hairs were asked for.
        QVERIFY(last.drawnHairs < whole->hairCount / 2);
        f.area.setFrame(whole);
        QTRY_COMPARE_WITH_TIMEOUT(last.drawnHairs, whole->hairCount, kPatienceMs);
    }

    void inputEndsTheRefining()
    {
        HeadFixture f;
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        const std::shared_ptr<const sim::StrandFrame> frame = f.frame();
        QSignalSpy drawn(&f.area, &view::HeadView::frameDrawn);
        // At once: another look at it may come too late.
        auto* signs = f.area.findChild<view::ViewSigns*>();
        std::optional<QString> whileRefining;
        QString after;
        connect(f.area.findChild<view::FramePresenter*>(), &view::FramePresenter::refining, this, [&](bool on) {
            if (!on || whileRefining)
                return;
            whileRefining = signs->text();
            f.wheel(kMiddle, 1);
            after = signs->text();
        });
        f.area.setFrame(frame);
        QTRY_VERIFY_WITH_TIMEOUT(whileRefining, kPatienceMs);
        QVERIFY(whileRefining->contains(QStringLiteral("Refining")));
        QVERIFY(after.isEmpty());
        drawn.clear();
        QTRY_VERIFY_WITH_TIMEOUT(!drawn.isEmpty(), kPatienceMs);
    }

    void aBrushOnTheFarSideShowsAsAGhostAndTheViewTurnsToIt()
    {
        HeadFixture f;
        const sim::Skin& skin = *f.editor.document.project().head->skin;
        const auto brushAt = [&](glm::vec3 positionHd, model::Area area) {
            const sim::SurfacePoint point = skin.nearest(positionHd);
            f.editor.state.hover().set(view::HoverPoint{.area = area, .uv = point.uv, .point = point});
            return point;
        };
        auto* overlay = f.area.findChild<view::HeadOverlay*>();
        brushAt({0.0F, 0.0F, kBallM}, model::Area::Paint);
        QVERIFY(overlay->ghost().isEmpty());
        const sim::SurfacePoint behind = brushAt({0.03F, 0.02F, -kBallM}, model::Area::Paint);
        QVERIFY(!overlay->ghost().isEmpty() && overlay->isVisible());
        QVERIFY(overlay->ghost().boundingRect().contains(f.area.positionOf(behind.positionHd).value()));
        f.area.turnToBrush();
        QTRY_VERIFY_WITH_TIMEOUT(overlay->ghost().isEmpty(), kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(std::remainder(f.area.camera().azimuthRad - 2.85F, 6.2832F)) < 0.1F,
                                 kPatienceMs);
        const std::optional<sim::SurfacePoint> seen = f.area.skinAt(f.area.positionOf(behind.positionHd).value());
        QVERIFY(seen && glm::distance(seen->positionHd, behind.positionHd) < 0.003F);
    }

    void hairOfTheHeadBeforeIsNotShown()
    {
        HeadFixture f;
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        const std::shared_ptr<const sim::StrandFrame> old = f.frame();
        f.area.setFrame(old);
        const QImage hairy = test::pictureOf(f.area, {480, 400});
        auto head = std::make_shared<model::Head>(*f.editor.document.project().head);
        head->skin = std::make_shared<sim::Skin>(test::makeBallHead());
        f.editor.document.push(model::setHeadCommand(f.editor.document, head, {}));
        f.area.setCamera(HeadFixture::camera());
        f.area.setFrame(old); // The simulation was still at it.
        const QImage bald = test::pictureOf(f.area, {480, 400});
        QVERIFY(differingPixels(hairy, bald, QRect(0, 0, 480, 400)) > 200);
        f.area.setFrame(f.frame());
        QVERIFY(differingPixels(test::pictureOf(f.area, {480, 400}), bald, QRect(0, 0, 480, 400)) > 200);
    }

    void aSignTellsThatTheHairIsPaused()
    {
        HeadFixture f;
        f.area.setHairPaused(true);
        auto* signs = f.area.findChild<view::ViewSigns*>();
        QVERIFY(signs->isVisible() && signs->text().contains(QStringLiteral("Paused")));
        f.area.setHairPaused(false);
        QVERIFY(!signs->text().contains(QStringLiteral("Paused")));
    }
};

HAIRPAINT_TEST(HeadViewStillTest, Widgets)
#include "test_head_view_still.moc"
