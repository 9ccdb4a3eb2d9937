// Grab: what dragging hair leaves in the direction map and the length map.
#include "tests/model/head_studio.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

const QString kGrab = QStringLiteral("grab");
constexpr float kAlongM = 0.05F;

/// A studio whose hair stands on a patch of 20 cm in the plane z = 0.
struct Hand : HeadStudio
{
    explicit Hand(Project project = filledPatch(MapKind::Length, 26214)) : HeadStudio(std::move(project)) // 0.4
    {
        settings.hardness = 1.0F;
        settings.brushSizeM = 0.04F;
    }
    [[nodiscard]] HairEvent event(glm::vec3 rootHd, glm::vec3 targetHd, Qt::KeyboardModifiers modifiers = {})
    {
        const sim::SurfacePoint root = skin().nearest(rootHd);
        return {.hair = {.root = root, .positionHd = root.positionHd + root.normalHd * kAlongM, .alongM = kAlongM},
                .targetHd = targetHd,
                .modifiers = modifiers};
    }
    [[nodiscard]] HairHandler& grab() { return *tool(kGrab).hairHandler(); }
    /// Takes hold of hair that stands 5 cm up, and takes it there.
    void take(glm::vec3 rootHd, glm::vec3 targetHd, Qt::KeyboardModifiers modifiers = {})
    {
        ToolContext now = context();
        HairEvent held = event(rootHd, targetHd);
        held.targetHd = held.hair.positionHd;
        grab().pressHair(held, now);
        held.targetHd = (held.hair.positionHd + targetHd) * 0.5F;
        grab().moveHair(held, now);
        grab().moveHair(event(rootHd, targetHd, modifiers), now);
    }
    void letGo(glm::vec3 rootHd, glm::vec3 targetHd, Qt::KeyboardModifiers modifiers = {})
    {
        ToolContext now = context();
        grab().releaseHair(event(rootHd, targetHd, modifiers), now);
    }
    [[nodiscard]] glm::vec3 directionAt(glm::vec3 positionHd)
    {
        const sim::SurfacePoint point = skin().nearest(positionHd);
        return sim::SkinFrame::at(point).toHd(sim::directionOf(shown()->sampleNearest(point.uv)));
    }
    [[nodiscard]] float gelAt(glm::vec3 positionHd)
    {
        return document.resolved(context().target.group, MapKind::Gel)->sampleScalar(skin().nearest(positionHd).uv);
    }
    [[nodiscard]] float lengthAt(glm::vec3 positionHd)
    {
        return document.resolved(context().target.group, MapKind::Length)->sampleScalar(skin().nearest(positionHd).uv);
    }
};

const glm::vec3 kRoot(0.01F, 0.02F, 0.0F);

} // namespace

class TestGrab : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void hairGoesTowardThePointer_data()
    {
        QTest::addColumn<float>("x");
        QTest::addColumn<float>("y");
        QTest::addColumn<float>("z");
        QTest::addColumn<float>("length");
        QTest::newRow("half flat to the right") << 0.04F << 0.0F << 0.03F << 0.8F;
        QTest::newRow("steeply up") << 0.0F << 0.03F << 0.04F << 0.6F;
        QTest::newRow("flat") << -0.05F << 0.0F << 0.0F << 1.0F;
        QTest::newRow("into the head: flat on it") << 0.03F << 0.0F << -0.03F << 1.0F;
    }
    void hairGoesTowardThePointer()
    {
        QFETCH(float, x);
        QFETCH(float, y);
        QFETCH(float, z);
        QFETCH(float, length);
        Hand hand;
        const glm::vec3 target = kRoot + glm::vec3(x, y, z);
        hand.take(kRoot, target);
        const glm::vec3 wanted = glm::normalize(glm::vec3(x, y, 0.0F)) * length;
        // Live, before it is let go, and all that the brush reaches.
        QCOMPARE(hand.document.undoStack().count(), 0);
        for (const glm::vec3 beside : {glm::vec3(0.0F), glm::vec3(0.015F, 0.0F, 0.0F), glm::vec3(0.0F, -0.015F, 0.0F)})
            QVERIFY(glm::distance(hand.directionAt(kRoot + beside), wanted) < 0.02F);
        QCOMPARE(hand.directionAt(kRoot + glm::vec3(0.025F, 0.0F, 0.0F)), glm::vec3(0.0F));
        hand.letGo(kRoot, target);
        QCOMPARE(hand.document.undoStack().count(), 1);
        QCOMPARE(hand.document.undoStack().undoText(), QStringLiteral("Grab"));
        QVERIFY(glm::distance(hand.directionAt(kRoot), wanted) < 0.02F);
        QCOMPARE(hand.lengthAt(kRoot), hand.lengthAt({-0.08F, -0.08F, 0.0F}));
        hand.document.undo();
        QCOMPARE(hand.directionAt(kRoot), glm::vec3(0.0F));
    }

    void aClickChangesNothing()
    {
        Hand hand;
        const glm::vec3 where = kRoot + glm::vec3(0.0F, 0.0F, kAlongM);
        hand.take(kRoot, where);
        hand.letGo(kRoot, where);
        QCOMPARE(hand.document.undoStack().count(), 0);
    }

    void withCtrlItIsAsLongAsThePointerIsAway_data()
    {
        QTest::addColumn<float>("factor");
        QTest::addColumn<float>("wanted");
        QTest::newRow("shorter") << 0.5F << 0.2F;
        QTest::newRow("longer") << 1.5F << 0.6F;
        QTest::newRow("longer than the map goes") << 4.0F << 1.0F;
    }
    void withCtrlItIsAsLongAsThePointerIsAway()
    {
        QFETCH(float, factor);
        QFETCH(float, wanted);
        Hand hand;
        const glm::vec3 target = kRoot + glm::vec3(factor * kAlongM, 0.0F, 0.0F);
        hand.take(kRoot, target, Qt::ControlModifier);
        QVERIFY(std::abs(hand.lengthAt(kRoot) - wanted) < 0.01F);
        // Let go of Ctrl, and it is as long as it was.
        ToolContext now = hand.context();
        hand.grab().moveHair(hand.event(kRoot, target), now);
        QVERIFY(std::abs(hand.lengthAt(kRoot) - 0.4F) < 0.001F);
        hand.letGo(kRoot, target, Qt::ControlModifier);
        QVERIFY(std::abs(hand.lengthAt(kRoot) - wanted) < 0.01F);
        QVERIFY(std::abs(hand.lengthAt({-0.05F, 0.0F, 0.0F}) - 0.4F) < 0.001F);
        QCOMPARE(hand.document.undoStack().count(), 1);
        hand.document.undo();
        QVERIFY(std::abs(hand.lengthAt(kRoot) - 0.4F) < 0.001F);
        QCOMPARE(hand.directionAt(kRoot), glm::vec3(0.0F));
    }

    void theShortestHairCountsInTheLength()
    {
        Project project = filledPatch(MapKind::Length, 32768); // Half of what lies between.
        project.groups.front().settings.shortestLengthM = 0.1F;
        project.groups.front().settings.greatestLengthM = 0.3F;
        Hand hand(std::move(project));
        hand.take(kRoot, kRoot + glm::vec3(1.25F * kAlongM, 0.0F, 0.0F), Qt::ControlModifier);
        QVERIFY(std::abs(hand.lengthAt(kRoot) - 0.75F) < 0.01F); // 25 cm.
    }

    void escapeLeavesNoTrace()
    {
        Hand hand;
        hand.take(kRoot, kRoot + glm::vec3(0.1F, 0.0F, 0.0F), Qt::ControlModifier);
        ToolContext now = hand.context();
        hand.tool(kGrab).cancel(now);
        QCOMPARE(hand.document.undoStack().count(), 0);
        QCOMPARE(hand.directionAt(kRoot), glm::vec3(0.0F));
        QVERIFY(std::abs(hand.lengthAt(kRoot) - 0.4F) < 0.001F);
    }

    void theOtherSideGoesTheOtherWay_data()
    {
        QTest::addColumn<bool>("mirror");
        QTest::newRow("mirrored") << true;
        QTest::newRow("not") << false;
    }
    void theOtherSideIsMirrored()
    {
        QFETCH(bool, mirror);
        Hand hand;
        hand.mirror = mirror;
        const glm::vec3 root(0.05F, 0.02F, 0.0F);
        hand.take(root, root + glm::vec3(0.04F, 0.0F, 0.03F));
        QVERIFY(glm::distance(hand.directionAt(root), glm::vec3(0.8F, 0.0F, 0.0F)) < 0.02F);
        const glm::vec3 other(mirror ? -0.8F : 0.0F, 0.0F, 0.0F);
        QVERIFY(glm::distance(hand.directionAt({-0.05F, 0.02F, 0.0F}), other) < 0.02F);
    }

    void onThePaperItLaysHairTowardThePointer()
    {
        Hand hand;
        hand.settings.flatness = 0.7F;
        hand.press(kGrab, 0.5F, 0.5F);
        hand.move(kGrab, 0.5F, 0.7F, 1.0F, Qt::ControlModifier);
        hand.release(kGrab, 0.5F, 0.7F);
        QVERIFY(glm::distance(hand.directionAt(glm::vec3(0.0F)), glm::vec3(0.0F, 0.7F, 0.0F)) < 0.02F);
        QCOMPARE(hand.directionAt({0.0F, 0.04F, 0.0F}), glm::vec3(0.0F));
        QCOMPARE(hand.document.undoStack().count(), 1);
    }

    void longHairGoesWhereItIsPulledThoughMostOfItHangs()
    {
        Hand hand;
        ToolContext now = hand.context();
        HairEvent event = hand.event(kRoot, {});
        event.hair.alongM = 0.3F;
        event.hair.positionHd = kRoot + glm::vec3(0.0F, 0.0F, 0.3F);
        event.targetHd = event.hair.positionHd;
        hand.grab().pressHair(event, now);
        event.targetHd = event.hair.positionHd + glm::vec3(0.05F, 0.0F, 0.0F);
        hand.grab().moveHair(event, now);
        // As far to the side as the 5 cm go up that such hair carries.
        QVERIFY(glm::distance(hand.directionAt(kRoot), glm::vec3(0.707F, 0.0F, 0.0F)) < 0.02F);
        hand.tool(kGrab).cancel(now);
    }

    void hairBeyondAPartingStays()
    {
        Hand hand;
        // To both sides of x = 0.
        for (const float side : {-1.0F, 1.0F}) {
            hand.settings.brushSizeM = 0.07F;
            hand.take({0.036F * side, 0.02F, 0.0F}, {0.136F * side, 0.02F, 0.02F});
            hand.letGo({0.036F * side, 0.02F, 0.0F}, {0.136F * side, 0.02F, 0.02F});
        }
        const glm::vec3 beyond(-0.008F, 0.02F, 0.0F);
        const glm::vec3 before = hand.directionAt(beyond);
        QVERIFY(before.x < -0.8F);
        hand.settings.brushSizeM = 0.04F;
        hand.take({0.008F, 0.02F, 0.0F}, {0.008F, 0.08F, 0.02F});
        QVERIFY(hand.directionAt({0.008F, 0.02F, 0.0F}).y > 0.8F);
        QVERIFY(hand.directionAt({0.016F, 0.02F, 0.0F}).y > 0.8F);
        QCOMPARE(hand.directionAt(beyond), before);
    }

    void pulledHairGetsTheGelThatKeepsItThere()
    {
        Hand hand;
        const glm::vec3 target = kRoot + glm::vec3(0.04F, 0.0F, 0.03F);
        QCOMPARE(hand.gelAt(kRoot), 0.0F);
        hand.take(kRoot, target);
        QVERIFY(std::abs(hand.gelAt(kRoot) - 0.3F) < 0.01F);
        hand.letGo(kRoot, target);
        QCOMPARE(hand.document.undoStack().count(), 1);
        hand.settings.grabGel = 0.2F; // It has more.
        hand.take(kRoot, target);
        hand.letGo(kRoot, target);
        QVERIFY(std::abs(hand.gelAt(kRoot) - 0.3F) < 0.01F);
        hand.document.undo();
        hand.document.undo();
        QCOMPARE(hand.gelAt(kRoot), 0.0F);
        hand.settings.grabGel = 0.0F;
        hand.take(kRoot, target);
        hand.letGo(kRoot, target);
        QCOMPARE(hand.gelAt(kRoot), 0.0F);
    }

    void besideHairThereIsNothingToGrab()
    {
        Hand hand;
        ToolContext now = hand.context();
        const sim::SurfacePoint point = hand.skin().nearest(kRoot);
        hand.tool(kGrab).press({.area = Area::Head, .uv = point.uv, .point = point}, now);
        QVERIFY(!hand.tool(kGrab).active());
    }
};

HAIRPAINT_TEST(TestGrab, Gui)
#include "test_grab.moc"
