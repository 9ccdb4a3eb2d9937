// What is worn, edited in the 3D area.
#include "model/document/scene_commands.h"
#include "tests/support/head_picture.h"
#include "tests/support/test_program.h"
#include "tests/view/head_fixture.h"
#include "view/head_area/head_overlay.h"
#include "view/head_area/worn_outline.h"

#include <QUndoStack>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

/// Two ellipsoids in a ball, shown.
struct WornFixture : HeadFixture
{
    WornFixture()
    {
        add(model::WornKind::Ellipsoid, {.centreHd = {0.0F, 0.0F, 0.0F}, .semiAxesM = {0.05F, 0.08F, 0.06F}});
        add(model::WornKind::Ellipsoid, {.centreHd = {0.0F, -0.1F, 0.0F}, .semiAxesM = glm::vec3(0.03F)});
        editor.state.options().setCollidersShown(true);
    }
    /// Its id. No undo step is left.
    model::Id add(model::WornKind kind, const sim::Ellipsoid& shape)
    {
        const model::Id id = editor.document.project().nextId;
        editor.document.push(addWornCommand(editor.document, {.kind = kind, .shape = shape}));
        editor.document.undoStack().clear();
        return id;
    }
    [[nodiscard]] const std::vector<model::Worn>& all() { return editor.document.project().worn; }
    [[nodiscard]] const sim::Ellipsoid& first() { return all().front().shape; }
    [[nodiscard]] QUndoStack& stack() { return editor.document.undoStack(); }
    [[nodiscard]] QPointF shown(glm::vec3 positionHd) { return area.positionOf(positionHd).value_or(QPointF()); }
    /// An end of the first one's axis, on its outline.
    [[nodiscard]] QPoint end(glm::vec3 axis) { return shown(first().centreHd + axis * first().semiAxesM).toPoint(); }
};

const glm::vec3 kRight(1.0F, 0.0F, 0.0F);
const glm::vec3 kUp(0.0F, 1.0F, 0.0F);

} // namespace

class TestWornDrag : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void anOutlineIsDraggedInThePlaneOfTheScreen()
    {
        WornFixture f;
        const std::vector<model::Worn> before = f.all();
        const QPointF centre = f.shown(f.first().centreHd);
        const QPoint from = f.end(kRight);
        f.drag(from, from + QPoint(40, -25));
        QCOMPARE(f.editor.state.options().chosenWorn(), before.front().id);
        const QPointF moved = f.shown(f.first().centreHd) - centre;
        QVERIFY(std::abs(moved.x() - 40.0) < 1.0 && std::abs(moved.y() + 25.0) < 1.0);
        QVERIFY(f.first().semiAxesM == before.front().shape.semiAxesM);
        QVERIFY(f.all()[1] == before[1]);
        QCOMPARE(f.stack().count(), 1);
        QCOMPARE(f.stack().text(0), QStringLiteral("Move collider"));
        f.editor.document.undo();
        QVERIFY(f.all() == before);
    }

    void anAxisOfTheChosenOneIsDraggedByItsEnd_data()
    {
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::newRow("alone") << Qt::KeyboardModifiers();
        QTest::newRow("with the others") << Qt::KeyboardModifiers(Qt::ShiftModifier);
    }
    void anAxisOfTheChosenOneIsDraggedByItsEnd()
    {
        QFETCH(Qt::KeyboardModifiers, modifiers);
        WornFixture f;
        const sim::Ellipsoid before = f.first();
        QTest::mouseClick(&f.area, Qt::LeftButton, {}, f.end(kRight));
        QCOMPARE(f.stack().count(), 0); // Only chosen.
        const QPoint from = f.end(kUp);
        f.drag(from, from - QPoint(0, 30), Qt::LeftButton, modifiers);
        QVERIFY(std::abs(f.end(kUp).y() - (from.y() - 30)) <= 1);
        QVERIFY(f.first().centreHd == before.centreHd);
        const glm::vec3 grown = f.first().semiAxesM / before.semiAxesM;
        QVERIFY(grown.y > 1.1F);
        const float others = modifiers.testFlag(Qt::ShiftModifier) ? grown.y : 1.0F;
        QVERIFY(std::abs(grown.x - others) < 1e-4F && std::abs(grown.z - others) < 1e-4F);
        QCOMPARE(f.stack().text(0), QStringLiteral("Size collider"));
    }

    void withShiftTheOutlineSizesAll()
    {
        WornFixture f;
        const sim::Ellipsoid before = f.first();
        const QPoint from = f.end(kRight);
        const QPoint centre = f.shown(before.centreHd).toPoint();
        f.drag(from, centre + (from - centre) * 2, Qt::LeftButton, Qt::ShiftModifier);
        QVERIFY(glm::distance(f.first().semiAxesM, 2.0F * before.semiAxesM) < 0.004F);
        QVERIFY(f.first().centreHd == before.centreHd);
    }

    void escCancelsADrag()
    {
        WornFixture f;
        const std::vector<model::Worn> before = f.all();
        const QPoint from = f.end(kRight);
        QTest::mousePress(&f.area, Qt::LeftButton, {}, from);
        f.move(from + QPoint(50, 0), Qt::LeftButton, {});
        QVERIFY(f.all() != before);
        QVERIFY(f.editor.document.groomInput().colliders == contactShapes(f.all())); // Hair hears of it.
        QTest::keyClick(&f.area, Qt::Key_Escape);
        QVERIFY(f.all() == before);
        QTest::mouseRelease(&f.area, Qt::LeftButton, {}, from + QPoint(50, 0));
        QCOMPARE(f.stack().count(), 0);
        QVERIFY(f.all() == before);
    }

    void elsewhereAndWhileTheyAreHiddenToolsWorkAsEver()
    {
        WornFixture f;
        const std::vector<model::Worn> before = f.all();
        const QPoint outline = f.end(kRight);
        f.drag(kMiddle + QPoint(12, 14), kMiddle + QPoint(16, 20));
        QCOMPARE(f.stack().count(), 1);
        f.editor.state.options().setCollidersShown(false);
        QCOMPARE(f.editor.state.options().chosenWorn(), 0);
        f.drag(outline, outline + QPoint(10, 10));
        QCOMPARE(f.stack().count(), 2);
        QVERIFY(f.all() == before);
        QVERIFY(f.stack().text(0).startsWith(QStringLiteral("Brush")));
    }

    void theyAreAddedAndRemoved()
    {
        WornFixture f;
        f.area.removeWorn(); // None is chosen.
        QCOMPARE(f.stack().count(), 0);
        const QPoint position = kMiddle + QPoint(30, 10);
        QTest::mouseMove(&f.area, position);
        f.area.addWorn(model::WornKind::Ellipsoid);
        QCOMPARE(f.all().size(), std::size_t{3});
        QCOMPARE(f.editor.state.options().chosenWorn(), f.all().back().id);
        QCOMPARE(f.stack().text(0), QStringLiteral("Add collider"));
        f.area.removeWorn();
        QCOMPARE(f.all().size(), std::size_t{2});
        QCOMPARE(f.editor.state.options().chosenWorn(), 0);
        QCOMPARE(f.stack().text(1), QStringLiteral("Remove collider"));
        f.editor.document.undo();
        QCOMPARE(f.all().size(), std::size_t{3});
        for (std::size_t i = 0; i < model::wornSpec(model::WornKind::Ellipsoid).limit; ++i)
            f.area.addWorn(model::WornKind::Ellipsoid);
        QCOMPARE(f.all().size(), model::wornSpec(model::WornKind::Ellipsoid).limit); // A file holds no more.
    }

    void aBodyIsGrippedWhereItIsSeen()
    {
        WornFixture f;
        f.editor.state.options().setCollidersShown(false);
        const glm::vec3 before(0.03F, 0.02F, kBallM + 0.01F);
        const glm::vec3 behind(-0.03F, 0.02F, -kBallM - 0.01F);
        const model::Id ball = f.add(model::WornKind::Ball, {.centreHd = before, .semiAxesM = glm::vec3(0.015F)});
        f.add(model::WornKind::Ball, {.centreHd = behind, .semiAxesM = glm::vec3(0.015F)});
        const std::vector<model::Worn> all = f.all();
        const auto shapeOf = [&](model::Id id) { return f.editor.document.project().wornThing(id)->shape; };
        const QPoint at = f.shown(before).toPoint();
        f.drag(at, at + QPoint(25, -10));
        QCOMPARE(f.editor.state.options().chosenWorn(), ball);
        const QPointF moved = f.shown(shapeOf(ball).centreHd) - f.shown(before);
        QVERIFY(std::abs(moved.x() - 25.0) < 1.0 && std::abs(moved.y() + 10.0) < 1.0);
        QCOMPARE(f.stack().count(), 1);
        QCOMPARE(f.stack().text(0), QStringLiteral("Move ball"));
        // Chosen it is moved by its middle, too: no handle lies there.
        const QPoint middle = f.shown(shapeOf(ball).centreHd).toPoint();
        f.drag(middle, middle + QPoint(-5, 0));
        QCOMPARE(f.stack().text(1), QStringLiteral("Move ball"));
        f.editor.document.undo();
        QVERIFY(f.editor.document.groomInput().colliders == contactShapes(f.all()));
        f.editor.document.undo();
        QVERIFY(f.all() == all);
        // The skin is nearer than the other one: the tool paints.
        const QPoint hidden = f.shown(behind).toPoint();
        f.drag(hidden, hidden + QPoint(6, 6));
        QVERIFY(f.all() == all);
        QVERIFY(f.stack().text(0).startsWith(QStringLiteral("Brush")));
        QCOMPARE(f.editor.state.options().chosenWorn(), 0); // Let go of by the press.
        // Nor is it in reach by its outline and its handles, which are seen when it is chosen.
        f.editor.state.options().setChosenWorn(all.back().id);
        const QPoint rim = f.shown(behind + 0.015F * kRight).toPoint();
        f.drag(rim, rim + QPoint(6, 6));
        QVERIFY(f.all() == all);
        QVERIFY(f.stack().text(1).startsWith(QStringLiteral("Brush")));
    }

    void aBallStaysRoundByItsHandles()
    {
        WornFixture f;
        f.editor.state.options().setCollidersShown(false);
        const auto* overlay = f.area.findChild<view::HeadOverlay*>();
        QVERIFY(overlay->wornOutlines().empty());
        const glm::vec3 centre(0.0F, 0.0F, kBallM + 0.01F);
        const model::Id ball = f.add(model::WornKind::Ball, {.centreHd = centre, .semiAxesM = glm::vec3(0.02F)});
        QTest::mouseClick(&f.area, Qt::LeftButton, {}, f.shown(centre).toPoint());
        QCOMPARE(f.editor.state.options().chosenWorn(), ball);
        QCOMPARE(overlay->wornOutlines().size(), std::size_t{3}); // Only the chosen thing has outlines.
        const QPoint top = f.shown(centre + 0.02F * kUp).toPoint();
        f.drag(top, top - QPoint(0, 20));
        const sim::Ellipsoid shape = f.editor.document.project().wornThing(ball)->shape;
        QVERIFY(shape.semiAxesM.y > 0.025F && shape.semiAxesM == glm::vec3(shape.semiAxesM.y));
        QVERIFY(shape.centreHd == centre);
        QCOMPARE(f.stack().text(0), QStringLiteral("Size ball"));
        f.area.removeWorn();
        QVERIFY(f.editor.document.project().wornThing(ball) == nullptr);
        QVERIFY(overlay->wornOutlines().empty());
        QCOMPARE(f.stack().text(1), QStringLiteral("Remove ball"));
    }

    /// A bow stands on the skin: it goes over it, turns with it and by its handle.
    void whatStandsOnTheSkinIsMovedOverItAndTurned()
    {
        WornFixture f;
        f.editor.state.options().setCollidersShown(false);
        QTest::mouseMove(&f.area, kMiddle);
        f.area.addWorn(model::WornKind::Bow);
        const model::Worn before = f.all().back();
        f.stack().clear();
        const auto zOf = [](const model::Worn& worn) { return worn.shape.rotation * glm::vec3(0.0F, 0.0F, 1.0F); };
        QVERIFY(zOf(before).z > 0.95F);
        // By a loop: between loops and tails the skin is seen, and painted.
        const glm::vec3 loop = before.shape.centreHd + before.shape.rotation * glm::vec3(0.02F, 0.004F, 0.012F);
        const QPoint at = f.shown(loop).toPoint();
        f.drag(at, at + QPoint(70, 0));
        const model::Worn moved = f.all().back();
        QCOMPARE(f.stack().count(), 1);
        QCOMPARE(f.stack().text(0), QStringLiteral("Move ribbon bow"));
        QVERIFY(std::abs(glm::length(moved.shape.centreHd) - glm::length(before.shape.centreHd)) < 1e-3F);
        QVERIFY(moved.shape.centreHd.x > 0.04F && zOf(moved).x > 0.4F);
        QVERIFY(moved.shape.semiAxesM == before.shape.semiAxesM && moved.anchor != before.anchor);
        const QPoint handle = f.shown(view::turnEndHd(moved)).toPoint();
        f.drag(handle, handle - QPoint(0, 40));
        const model::Worn turned = f.all().back();
        QCOMPARE(f.stack().count(), 2);
        QVERIFY(turned.shape.centreHd == moved.shape.centreHd && zOf(turned).y > zOf(moved).y + 0.3F);
        const QPoint again = f.shown(view::turnEndHd(turned)).toPoint();
        f.drag(again, again + QPoint(30, 0), Qt::LeftButton, Qt::ShiftModifier);
        QVERIFY(glm::distance(zOf(f.all().back()), zOf(turned)) < 1e-3F && f.all().back() != turned);
        for (int i = 0; i < 3; ++i)
            f.editor.document.undo();
        QVERIFY(f.all().back() == before);
    }

    void aBallIsPutOnTheSkinAndDrawn()
    {
        WornFixture f;
        f.editor.state.options().setCollidersShown(false);
        const QPoint position = kMiddle + QPoint(30, 10);
        QTest::mouseMove(&f.area, position);
        f.area.addWorn(model::WornKind::Ball);
        const model::Worn ball = f.all().back();
        QCOMPARE(ball.kind, model::WornKind::Ball);
        QCOMPARE(f.editor.state.options().chosenWorn(), ball.id);
        QVERIFY(!f.editor.state.options().collidersShown());
        QVERIFY(std::abs(glm::length(ball.shape.centreHd) - kBallM - ball.shape.semiAxesM.x) < 1e-3F);
        const std::vector<rendering::Solid> solids = f.area.pictureScene().solids;
        QCOMPARE(solids.size(), std::size_t{1});
        QVERIFY(solids.front().shape == ball.shape && solids.front().mesh != nullptr);
        const QImage picture = test::pictureOf(f.area, {480, 400});
        const QColor pixel = picture.pixelColor(f.shown(ball.shape.centreHd).toPoint());
        QVERIFY2(pixel.red() > pixel.blue() + 40, qPrintable(pixel.name()));
    }
};

HAIRPAINT_TEST(TestWornDrag, Widgets)
#include "test_worn_drag.moc"
