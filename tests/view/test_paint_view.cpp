// The paint area driven by mouse, wheel, keys and pen.
#include "model/document/layer_commands.h"
#include "model/document/scene_commands.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/support/view_fixture.h"
#include "view/paint_area/paint_view.h"

#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>
#include <QUndoStack>
#include <QWheelEvent>

#include <cmath>

using namespace hairpaint;

namespace {

constexpr float kPatchSideM = 0.2F; ///< The patch maps it to one uv unit.

struct Fixture
{
    explicit Fixture(sim::HeadMesh mesh = test::makePatchHead())
        : editor(test::makeProject(std::move(mesh))), area(editor.state, view::Theme::of(view::ThemeKind::Dark))
    {
        area.resize(600, 600);
        area.show();
    }

    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = Qt::NoModifier,
              Qt::MouseButton button = Qt::LeftButton)
    {
        QTest::mousePress(&area, button, modifiers, from);
        for (int i = 1; i <= 10; ++i)
            QTest::mouseMove(&area, from + (to - from) * i / 10);
        QTest::mouseRelease(&area, button, modifiers, to);
    }

    void wheel(QPointF at, int notches)
    {
        QWheelEvent event(at, area.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&area, &event);
    }

    void pen(QEvent::Type type, QPointF at, double pressure, Qt::MouseButtons buttons,
             QPointingDevice::PointerType tip = QPointingDevice::PointerType::Pen)
    {
        QPointingDevice device(QStringLiteral("test pen"), 7, QInputDevice::DeviceType::Stylus, tip,
                               QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
        QTabletEvent event(type, &device, at, area.mapToGlobal(at), pressure, 0.0F, 0.0F, 0.0F, 0.0, 0.0F,
                           Qt::NoModifier, Qt::LeftButton, buttons);
        QApplication::sendEvent(&area, &event);
    }

    test::Editor editor;
    view::PaintView area;
};

/// Greatest distance of painted texels' centres from a point, m on the patch; -1 where nothing is painted.
float paintedReachM(const test::Editor& editor, glm::vec2 uv)
{
    const auto raster = editor.document.resolved(editor.state.target().group(), model::MapKind::Density);
    float reach = -1.0F;
    for (int y = 0; y < raster->size(); ++y) {
        for (int x = 0; x < raster->size(); ++x) {
            if (raster->texel(x, y)[0] == 0)
                continue;
            const glm::vec2 at((static_cast<float>(x) + 0.5F) / static_cast<float>(raster->size()),
                               1.0F - (static_cast<float>(y) + 0.5F) / static_cast<float>(raster->size()));
            reach = std::max(reach, glm::length(at - uv) * kPatchSideM);
        }
    }
    return reach;
}

bool differs(const QImage& a, const QImage& b, const QRect& rect)
{
    return a.copy(rect) != b.copy(rect);
}

} // namespace

class PaintViewTest : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void undoOutlinesTheAreaForAMoment()
    {
        Fixture f;
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, QPoint(150, 400));
        QTest::mouseMove(&f.area, QPoint(500, 100));
        const auto bright = [&f](const QRect& rect) {
            const QImage picture = f.area.grab(rect).toImage();
            int count = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    count += qGray(picture.pixel(x, y)) > 140 ? 1 : 0;
            return count;
        };
        const QRect edge(5, 290, 310, 20);
        f.editor.document.undo();
        QVERIFY(f.editor.density(f.area.uvAt(QPoint(150, 400))) < 0.01F);
        QVERIFY(bright(edge) > 100);
        QCOMPARE(bright(QRect(320, 200, 250, 350)), 0);
        QTRY_COMPARE_WITH_TIMEOUT(bright(edge), 0, test::kPatienceMs);
        f.editor.document.redo();
        QVERIFY(f.editor.density(f.area.uvAt(QPoint(150, 400))) > 0.99F);
        QVERIFY(bright(edge) > 100);
        QTRY_COMPARE_WITH_TIMEOUT(bright(edge), 0, test::kPatienceMs);
    }
    void aClickPaintsUnderThePointerAndNowhereElse_data()
    {
        QTest::addColumn<QPoint>("at");
        QTest::addColumn<bool>("mirrored");
        QTest::addColumn<double>("rotation");
        QTest::newRow("upper left") << QPoint(170, 150) << false << 0.0;
        QTest::newRow("lower right") << QPoint(420, 470) << false << 0.0;
        QTest::newRow("mirrored view") << QPoint(170, 150) << true << 0.0;
        QTest::newRow("turned view") << QPoint(250, 300) << false << 40.0;
    }
    void aClickPaintsUnderThePointerAndNowhereElse()
    {
        QFETCH(QPoint, at);
        QFETCH(bool, mirrored);
        QFETCH(double, rotation);
        Fixture f;
        f.area.rotateBy(rotation);
        if (mirrored)
            f.area.mirrorView();
        const glm::vec2 uv = f.area.uvAt(at);
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, at);
        QVERIFY(f.editor.density(uv) > 0.99F);
        const float reachM = paintedReachM(f.editor, uv);
        QVERIFY2(std::abs(reachM - 0.01F) < 0.0015F, qPrintable(QString::number(static_cast<double>(reachM))));
        QCOMPARE(f.editor.document.undoStack().count(), 1);
    }

    void aDragIsOneUndoStepAndUndoTakesItAway()
    {
        Fixture f;
        f.drag({150, 300}, {450, 300});
        QVERIFY(f.editor.density(f.area.uvAt({300, 300})) > 0.99F);
        QCOMPARE(f.editor.document.undoStack().count(), 1);
        f.editor.document.undo();
        QCOMPARE(paintedReachM(f.editor, {0.5F, 0.5F}), -1.0F);
    }

    void escCancelsTheStroke()
    {
        Fixture f;
        QTest::mousePress(&f.area, Qt::LeftButton, Qt::NoModifier, {200, 200});
        QTest::mouseMove(&f.area, {260, 200});
        QVERIFY(f.editor.density(f.area.uvAt({200, 200})) > 0.99F);
        QTest::keyClick(&f.area, Qt::Key_Escape);
        QCOMPARE(paintedReachM(f.editor, {0.5F, 0.5F}), -1.0F);
        QTest::mouseMove(&f.area, {300, 200});
        QTest::mouseRelease(&f.area, Qt::LeftButton, Qt::NoModifier, {300, 200});
        QCOMPARE(paintedReachM(f.editor, {0.5F, 0.5F}), -1.0F);
        QCOMPARE(f.editor.document.undoStack().count(), 0);
    }

    void thePenPressureSetsTheSize_data()
    {
        QTest::addColumn<double>("pressure");
        QTest::newRow("full") << 1.0;
        QTest::newRow("half") << 0.5;
    }
    void thePenPressureSetsTheSize()
    {
        QFETCH(double, pressure);
        Fixture f;
        model::ToolSettings settings = f.editor.state.tools().settings();
        settings.pressureSize = true;
        settings.brushSizeM = 0.04F;
        f.editor.state.tools().setSettings(settings);
        const QPointF at(300.0, 300.0);
        f.pen(QEvent::TabletPress, at, pressure, Qt::LeftButton);
        f.pen(QEvent::TabletRelease, at, 0.0, Qt::NoButton);
        const float reachM = paintedReachM(f.editor, f.area.uvAt(at));
        QVERIFY2(std::abs(reachM - 0.02F * static_cast<float>(pressure)) < 0.0015F,
                 qPrintable(QString::number(static_cast<double>(reachM))));
    }

    void thePensOtherEndErases()
    {
        Fixture f;
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, {300, 300});
        const model::ToolId tool = f.editor.state.tools().active().id();
        f.pen(QEvent::TabletPress, {300, 300}, 1.0, Qt::LeftButton, QPointingDevice::PointerType::Eraser);
        f.pen(QEvent::TabletRelease, {300, 300}, 0.0, Qt::NoButton, QPointingDevice::PointerType::Eraser);
        QVERIFY(f.editor.density(f.area.uvAt({300, 300})) < 0.01F);
        QCOMPARE(f.editor.state.tools().active().id(), tool);
    }

    void theRingIsAsLargeAsTheBrush()
    {
        Fixture f;
        model::ToolSettings settings = f.editor.state.tools().settings();
        settings.brushSizeM = 0.06F;
        f.editor.state.tools().setSettings(settings);
        const QImage without = f.area.grab().toImage();
        QTest::mouseMove(&f.area, {300, 300});
        const QImage with = f.area.grab().toImage();
        const double perUv = f.area.positionOf({1.0F, 0.5F}).x() - f.area.positionOf({0.0F, 0.5F}).x();
        const int radiusPx = static_cast<int>(std::lround(0.03 / static_cast<double>(kPatchSideM) * perUv));
        // The line itself, and nothing halfway to it or well outside.
        for (const QPoint direction : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)}) {
            const QPoint line = QPoint(300, 300) + direction * radiusPx;
            QVERIFY(differs(without, with, QRect(line - QPoint(1, 1), QSize(3, 3))));
            QVERIFY(!differs(without, with, QRect(QPoint(300, 300) + direction * radiusPx / 2, QSize(1, 1))));
            QVERIFY(!differs(without, with, QRect(QPoint(300, 300) + direction * (radiusPx + 5), QSize(1, 1))));
        }
    }

    void theMirroredTwinShowsWhileMirroring()
    {
        Fixture f;
        const QPoint twin = f.area.positionOf({0.25F, 0.5F}).toPoint();
        const QPoint pointer = f.area.positionOf({0.75F, 0.5F}).toPoint();
        const QRect around(twin - QPoint(60, 60), QSize(121, 121));
        QTest::mouseMove(&f.area, pointer);
        const QImage off = f.area.grab().toImage();
        f.editor.state.options().setMirror(true);
        QVERIFY(differs(off, f.area.grab().toImage(), around));
    }

    void theOtherAreasHoverIsShownHere()
    {
        Fixture f;
        const QImage without = f.area.grab().toImage();
        const glm::vec2 uv(0.3F, 0.7F);
        f.editor.state.hover().set(view::HoverPoint{
            .area = model::Area::Head, .uv = uv, .point = f.editor.document.project().head->skin->atUv(uv)});
        const QPoint middle = f.area.positionOf(uv).toPoint();
        QVERIFY(differs(without, f.area.grab().toImage(), QRect(middle - QPoint(2, 2), QSize(5, 5))));
    }

    void theWheelZoomsAtThePointer()
    {
        Fixture f;
        const QPointF at(410.0, 180.0);
        const glm::vec2 before = f.area.uvAt(at);
        f.wheel(at, 3);
        QVERIFY(f.area.zoom() > 1.5);
        QVERIFY(glm::length(f.area.uvAt(at) - before) < 1e-4F);
        f.area.resetView();
        QVERIFY(std::abs(f.area.zoom() - 1.0) < 1e-9);
    }

    void draggingPans_data()
    {
        QTest::addColumn<bool>("space");
        QTest::newRow("with the middle button") << false;
        QTest::newRow("with Space") << true;
    }
    void draggingPans()
    {
        QFETCH(bool, space);
        Fixture f;
        const glm::vec2 held = f.area.uvAt({300, 300});
        if (space)
            QTest::keyPress(&f.area, Qt::Key_Space);
        f.drag({300, 300}, {340, 270}, Qt::NoModifier, space ? Qt::LeftButton : Qt::MiddleButton);
        if (space)
            QTest::keyRelease(&f.area, Qt::Key_Space);
        QVERIFY(QLineF(f.area.positionOf(held), QPointF(340, 270)).length() < 1.5);
        QCOMPARE(f.editor.document.undoStack().count(), 0);
        f.drag({300, 300}, {340, 270});
        QCOMPARE(f.editor.document.undoStack().count(), 1);
    }

    void ctrlAndRightDragSizeTheBrush()
    {
        Fixture f;
        const model::ToolSettings before = f.editor.state.tools().settings();
        f.drag({300, 300}, {380, 300}, Qt::ControlModifier, Qt::RightButton);
        QVERIFY(f.editor.state.tools().settings().brushSizeM > before.brushSizeM * 1.5F);
        QVERIFY(std::abs(f.editor.state.tools().settings().hardness - before.hardness) < 1e-5F);
        f.drag({300, 300}, {300, 400}, Qt::ControlModifier, Qt::RightButton);
        QVERIFY(f.editor.state.tools().settings().hardness < before.hardness - 0.2F);
        QCOMPARE(f.editor.document.undoStack().count(), 0);
    }

    void holdingODragsTheOpacity()
    {
        Fixture f;
        QTest::keyPress(&f.area, Qt::Key_O);
        f.drag({300, 300}, {200, 300});
        QTest::keyRelease(&f.area, Qt::Key_O);
        QVERIFY(f.editor.state.tools().settings().opacity < 0.8F);
        QCOMPARE(f.editor.document.undoStack().count(), 0);
    }

    void aDabRepaintsTheMapsPicture()
    {
        Fixture f;
        const QImage before = f.area.grab().toImage();
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, {200, 400});
        f.editor.state.hover().set(std::nullopt);
        const QImage after = f.area.grab().toImage();
        QVERIFY(differs(before, after, QRect(195, 395, 10, 10)));
        QVERIFY(!differs(before, after, QRect(350, 100, 100, 100)));
        QVERIFY(after.pixelColor(200, 400).green() > 150);
    }

    void whitePaperIsWhite()
    {
        Fixture f;
        f.editor.state.options().setWireframe(false);
        const QPoint at(300, 300);
        QVERIFY(f.area.grab().toImage().pixelColor(at).lightness() < 90);
        f.editor.state.options().setNightPaper(false);
        QVERIFY(f.area.grab().toImage().pixelColor(at).lightness() > 150);
    }

    void theSelectionMarches()
    {
        Fixture f;
        f.editor.state.options().setWireframe(false);
        const QImage without = f.area.grab().toImage();
        f.editor.state.tools().selection().setRectangle(QRectF(0.25, 0.25, 0.5, 0.5));
        const QImage first = f.area.grab().toImage();
        const QPoint corner = f.area.positionOf({0.25F, 0.75F}).toPoint();
        QVERIFY(differs(without, first, QRect(corner - QPoint(2, 2), QSize(60, 5))));
        QTRY_VERIFY_WITH_TIMEOUT(differs(first, f.area.grab().toImage(), QRect(corner - QPoint(2, 2), QSize(60, 5))),
                                 test::kPatienceMs);
    }

    void aLockedLayerIsNotPaintedAndTheReasonIsSaid()
    {
        Fixture f;
        const model::LayerAddress target = f.editor.state.target().address();
        model::LayerProperties properties =
            model::propertiesOf(*f.editor.document.project().layer(target.group, target.map, target.layer));
        properties.locked = true;
        f.editor.document.push(
            model::setLayerPropertiesCommand(f.editor.document, target, properties, QStringLiteral("Lock")));
        QSignalSpy refused(&f.editor.state, &view::EditorState::refused);
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, {300, 300});
        QCOMPARE(refused.count(), 1);
        QCOMPARE(paintedReachM(f.editor, {0.5F, 0.5F}), -1.0F);
    }

    void undoShowsTheMapThatChanged()
    {
        Fixture f;
        QTest::mouseClick(&f.area, Qt::LeftButton, Qt::NoModifier, {300, 300});
        f.editor.state.target().setMap(model::MapKind::Curl);
        f.editor.document.undo();
        QCOMPARE(f.editor.state.target().map(), model::MapKind::Density);
    }

    void aHeadsBackdropComesWhenItIsMadeAndTheNewestHeadWins()
    {
        test::Editor editor(test::makeProject(test::makePatchHead()));
        struct Job
        {
            std::function<view::BackdropPtr()> make;
            std::function<void(const view::BackdropPtr&)> done;
        };
        std::vector<Job> jobs;
        view::PaintView area(editor.state, view::Theme::of(view::ThemeKind::Dark),
                             [&jobs](const std::function<view::BackdropPtr()>& make, QObject*,
                                     const std::function<void(const view::BackdropPtr&)>& done) {
                                 jobs.push_back({make, done});
                             });
        area.resize(400, 400);
        const auto shown = [&area] { return area.grab().toImage(); };
        QCOMPARE(jobs.size(), std::size_t(1));
        const QImage bare = shown();
        auto ball = std::make_shared<model::Head>();
        ball->skin = std::make_shared<sim::Skin>(test::makeBallHead());
        editor.document.push(model::setHeadCommand(editor.document, ball, {}));
        QCOMPARE(jobs.size(), std::size_t(2));
        jobs[1].done(jobs[1].make());
        const QImage ofBall = shown();
        QVERIFY(ofBall != bare);
        jobs[0].done(jobs[0].make()); // The patch's, too late.
        QVERIFY(shown() == ofBall);
        jobs[1].done(nullptr); // Where it could not be made the map is shown without.
        QVERIFY(shown() != ofBall);
    }
};

HAIRPAINT_TEST(PaintViewTest, Widgets)
#include "test_paint_view.moc"
