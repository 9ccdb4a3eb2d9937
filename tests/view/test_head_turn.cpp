// The head in the 3D area turned by H and a drag, by motions, and back.
#include "head_fixture.h"
#include "tests/support/await.h"
#include "tests/support/test_program.h"
#include "view/head_area/head_turn.h"
#include "view/head_area/head_view.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace hairpaint;
using namespace hairpaint::test;

class HeadTurnTest : public QObject
{
    Q_OBJECT
private:
    static constexpr double kStepSeconds = 0.02;

    static view::HeadTurn& turnOf(HeadFixture& f) { return *f.area.findChild<view::HeadTurn*>(); }

    /// What moves the head goes on to its end, in the time of the test.
    static void goThrough(HeadFixture& f)
    {
        QVERIFY(turnOf(f).moving());
        while (turnOf(f).moving())
            turnOf(f).advance(kStepSeconds);
    }

private Q_SLOTS:
    void holdingHTurnsTheHead()
    {
        HeadFixture f;
        std::vector<sim::HeadPose> poses;
        connect(&f.area, &view::HeadView::poseWanted, &f.area,
                [&](const sim::HeadPose& pose) { poses.push_back(pose); });
        QTest::keyPress(&f.area, Qt::Key_H);
        f.drag(kMiddle, kMiddle + QPoint(80, 0));
        QTest::keyRelease(&f.area, Qt::Key_H);
        QVERIFY(!poses.empty());
        const glm::vec3 face = poses.back().rotation * glm::vec3(0.0F, 0.0F, 1.0F);
        QVERIFY(face.x > 0.3F);
        QCOMPARE(f.editor.document.undoStack().count(), 0);
        // Let go it comes back by itself, about the neck's base: the ball's, which has no landmarks.
        QVERIFY(f.area.awake());
        const std::size_t letGo = poses.size();
        QTRY_VERIFY_WITH_TIMEOUT(poses.size() > letGo, kPatienceMs);
        goThrough(f);
        QCOMPARE(poses.back(), sim::HeadPose{});
        for (const sim::HeadPose& pose : poses) {
            const glm::vec3 base(0.0F, -kBallM, 0.0F);
            QVERIFY(glm::distance(pose.rotation * base + pose.positionWo, base) < 1e-3F);
        }
    }

    void theHeadTurnsAsFarAsANeckDoes()
    {
        HeadFixture f;
        std::vector<glm::vec3> faces;
        connect(&f.area, &view::HeadView::poseWanted, &f.area,
                [&](const sim::HeadPose& pose) { faces.push_back(pose.rotation * glm::vec3(0.0F, 0.0F, 1.0F)); });
        const auto drag = [&](QPoint pixels) {
            QTest::keyPress(&f.area, Qt::Key_H);
            QTest::mousePress(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
            f.move(kMiddle + pixels, Qt::LeftButton, Qt::NoModifier);
            const glm::vec3 face = faces.back();
            f.move(kMiddle, Qt::LeftButton, Qt::NoModifier);
            QTest::mouseRelease(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
            QTest::keyRelease(&f.area, Qt::Key_H);
            return face;
        };
        const auto radians = [](float degrees) { return degrees * std::numbers::pi_v<float> / 180.0F; };
        QVERIFY(std::abs(drag({2000, 0}).z - std::cos(radians(80.0F))) < 1e-4F);
        QVERIFY(std::abs(drag({0, 2000}).y + std::sin(radians(45.0F))) < 1e-4F);
        QVERIFY(std::abs(drag({0, -2000}).y - std::sin(radians(45.0F))) < 1e-4F);
        // From behind, too, what is seen follows the pointer.
        rendering::Camera behind = HeadFixture::camera();
        behind.azimuthRad = std::numbers::pi_v<float>;
        f.area.setCamera(behind);
        QVERIFY(drag({30, 0}).x > 0.1F);
        QVERIFY(drag({0, 30}).y > 0.1F);
    }

    void aMotionIsGoneThroughOnce_data()
    {
        QTest::addColumn<int>("motion");
        QTest::newRow("nod") << static_cast<int>(sim::NeckMotion::Nod);
        QTest::newRow("shake") << static_cast<int>(sim::NeckMotion::Shake);
        QTest::newRow("turn") << static_cast<int>(sim::NeckMotion::Turn);
    }

    void aMotionIsGoneThroughOnce()
    {
        QFETCH(int, motion);
        HeadFixture f;
        std::vector<sim::HeadPose> poses;
        connect(&f.area, &view::HeadView::poseWanted, &f.area,
                [&](const sim::HeadPose& pose) { poses.push_back(pose); });
        f.area.moveHead(static_cast<sim::NeckMotion>(motion));
        QTRY_VERIFY_WITH_TIMEOUT(!poses.empty() && poses.back() != sim::HeadPose{}, kPatienceMs);
        QVERIFY(f.area.awake());
        // Where the hair stands still the head does, too.
        f.area.setHairPaused(true);
        QVERIFY(!turnOf(f).moving());
        const std::size_t before = poses.size();
        turnOf(f).advance(kStepSeconds);
        handleDueEvents();
        QCOMPARE(poses.size(), before);
        f.area.setHairPaused(false);
        goThrough(f);
        QCOMPARE(poses.back(), sim::HeadPose{});
        const std::size_t all = poses.size();
        QVERIFY(all > before + 1);
        turnOf(f).advance(kStepSeconds);
        handleDueEvents();
        QCOMPARE(poses.size(), all);
        QCOMPARE(f.editor.document.undoStack().count(), 0);
    }

    void aDragEndsAMotionAndNoneBeginsInADrag()
    {
        HeadFixture f;
        std::vector<sim::HeadPose> poses;
        connect(&f.area, &view::HeadView::poseWanted, &f.area,
                [&](const sim::HeadPose& pose) { poses.push_back(pose); });
        f.area.moveHead(sim::NeckMotion::Turn);
        QTRY_VERIFY_WITH_TIMEOUT(!poses.empty() && poses.back() != sim::HeadPose{}, kPatienceMs);
        QTest::keyPress(&f.area, Qt::Key_H);
        QTest::mousePress(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        const std::size_t held = poses.size();
        f.area.moveHead(sim::NeckMotion::Nod);
        QVERIFY(!turnOf(f).moving());
        turnOf(f).advance(kStepSeconds);
        handleDueEvents();
        QCOMPARE(poses.size(), held);
        f.move(kMiddle + QPoint(-100, 0), Qt::LeftButton, Qt::NoModifier);
        QVERIFY((poses.back().rotation * glm::vec3(0.0F, 0.0F, 1.0F)).x < -0.3F);
        QTest::mouseRelease(&f.area, Qt::LeftButton, Qt::NoModifier, kMiddle);
        QTest::keyRelease(&f.area, Qt::Key_H);
        goThrough(f);
        QCOMPARE(poses.back(), sim::HeadPose{});
    }

    void resettingTheViewEndsAMotion()
    {
        HeadFixture f;
        std::vector<sim::HeadPose> poses;
        connect(&f.area, &view::HeadView::poseWanted, &f.area,
                [&](const sim::HeadPose& pose) { poses.push_back(pose); });
        f.area.moveHead(sim::NeckMotion::Turn);
        QTRY_VERIFY_WITH_TIMEOUT(!poses.empty() && poses.back() != sim::HeadPose{}, kPatienceMs);
        const std::size_t reset = poses.size();
        const auto aside = [&](std::size_t i) { return std::abs((poses[i].rotation * glm::vec3(0, 0, 1)).x); };
        f.area.resetCamera();
        goThrough(f);
        QCOMPARE(poses.back(), sim::HeadPose{});
        for (std::size_t i = reset; i < poses.size(); ++i)
            QVERIFY(aside(i) <= aside(i - 1));
    }
};

HAIRPAINT_TEST(HeadTurnTest, Widgets)
#include "test_head_turn.moc"
