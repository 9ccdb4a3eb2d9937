// Edits own what they show: whoever comes next ends them first, by their policy, and nothing done is lost.
#include "model/document/layer_commands.h"
#include "model/document/scene_commands.h"
#include "model/tools/selecting/clipboard.h"
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <random>
#include <utility>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

const QString kShape = QStringLiteral("shape");

const Change kAir{.aspect = Change::Aspect::Environment};

void blow(Project& project)
{
    project.wind.velocity = {4.0F, 0.0F, 0.0F};
}

/// Clicks the corners of a polygon that covers the middle of the map; it stays open.
void clickPolygon(Studio& studio)
{
    studio.settings.shape = ShapeKind::Polygon;
    for (const auto& [u, v] : {std::pair(0.3F, 0.3F), std::pair(0.7F, 0.3F), std::pair(0.7F, 0.7F)}) {
        studio.press(kShape, u, v);
        studio.release(kShape, u, v);
    }
}

} // namespace

class TestEditSession : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void anotherEditCommitsWhatIsChanged();
    void anotherEditDropsWhatIsOnlyLookedAt();
    void aCommandIsMadeOfWhatIsThereAfterTheEditEnded_data();
    void aCommandIsMadeOfWhatIsThereAfterTheEditEnded();
    void undoTakesBackAPolygonCornerByCorner();
    void undoOfALookTakesBackTheStepBelow();
    void anEditOfSeveralPartsIsOneStepWithTheSameBytes();
    void anEditThatChangesNothingLeavesNoStep();
    void anEditEndsWithItsOwner();
    void aPendingPolygonShowsItsCornersAndTheNextLine();
    void anyEditsPreviewEqualsItsCommitAndUndoGivesBackTheStart();
    void everyChangeRaisesTheRevision();
};

void TestEditSession::anotherEditCommitsWhatIsChanged()
{
    Studio studio;
    EditSession weather;
    studio.document.show(weather, {.text = QStringLiteral("Wind")}, kAir, blow);
    QVERIFY(weather.active());
    studio.press(kBrush, 0.5F, 0.5F);
    QVERIFY(!weather.active());
    QCOMPARE(studio.document.committed().wind.velocity.x, 4.0F);
    studio.release(kBrush, 0.5F, 0.5F);
    QCOMPARE(studio.document.undoStack().count(), 2);
    QCOMPARE(studio.document.undoStack().text(0), QStringLiteral("Wind"));
    // What its owner still says afterwards does nothing.
    weather.preview(kAir, [](Project& project) { project.wind = {}; });
    weather.commit();
    QCOMPARE(studio.document.project().wind.velocity.x, 4.0F);
    QCOMPARE(studio.document.undoStack().count(), 2);
}

void TestEditSession::anotherEditDropsWhatIsOnlyLookedAt()
{
    Studio studio;
    const Project before = studio.document.committed();
    EditSession look;
    studio.document.show(look, {.policy = EditPolicy::Drop}, {.aspect = Change::Aspect::GroupList},
                         [](Project& project) { project.groups.front().settings.greatestLengthM = 0.9F; });
    QVERIFY(!studio.document.canUndo());
    studio.document.settle(); // Saving leaves it: nothing would be lost.
    QVERIFY(look.active());
    EditSession weather;
    studio.document.show(weather, {}, kAir, blow);
    QVERIFY(!look.active());
    weather.drop();
    QVERIFY(sameProjects(studio.document.project(), before));
    QCOMPARE(studio.document.undoStack().count(), 0);
}

void TestEditSession::aCommandIsMadeOfWhatIsThereAfterTheEditEnded_data()
{
    QTest::addColumn<int>("what");
    QTest::newRow("paste") << 0;
    QTest::newRow("clear a part") << 1;
    QTest::newRow("a layer's properties") << 2;
}

void TestEditSession::aCommandIsMadeOfWhatIsThereAfterTheEditEnded()
{
    QFETCH(int, what);
    Studio studio;
    const LayerAddress at = studio.context().target;
    Selection corner;
    corner.setRectangle(QRectF(0.3, 0.3, 0.05, 0.05)); // In a tile that the polygon paints too.
    const Clip clip{.map = at.map,
                    .uvRect = QRectF(0.3, 0.3, 1.0 / 256.0, 1.0 / 256.0),
                    .width = 1,
                    .height = 1,
                    .texels = {{12345, 65535, 0, 0}}};
    clickPolygon(studio);
    QVERIFY(studio.tool(kShape).pending());
    Document& document = studio.document;
    if (what == 0)
        document.push(pasteCommand(document, at, clip, {}));
    else if (what == 1)
        document.push(clearCommand(document, at, corner, QStringLiteral("Clear")));
    else
        document.push(setLayerPropertiesCommand(document, at, {.name = QStringLiteral("x")}, QStringLiteral("Name")));
    QVERIFY(!studio.tool(kShape).active());
    QCOMPARE(document.undoStack().count(), 2);
    // The polygon's texels are there, in the tiles that both touched too.
    QCOMPARE(static_cast<int>(studio.layer().texel(140, 150)[1]), 65535);
    QCOMPARE(static_cast<int>(studio.layer().texel(100, 170)[1]), 65535);
    if (what == 0)
        QCOMPARE(static_cast<int>(studio.layer().texel(77, 178)[0]), 12345);
    document.undo();
    QCOMPARE(static_cast<int>(studio.layer().texel(140, 150)[1]), 65535);
    document.undo();
    QCOMPARE(static_cast<int>(studio.layer().texel(140, 150)[1]), 0);
}

void TestEditSession::undoTakesBackAPolygonCornerByCorner()
{
    Studio studio;
    const Project before = studio.document.committed();
    clickPolygon(studio);
    const sim::TiledRaster three = studio.layer();
    studio.press(kShape, 0.3F, 0.7F);
    studio.release(kShape, 0.3F, 0.7F);
    QVERIFY(studio.layer() != three);
    QVERIFY(studio.document.canUndo());
    studio.document.undo();
    QVERIFY(studio.tool(kShape).pending());
    QVERIFY(studio.layer() == three);
    studio.document.undo();
    studio.document.undo();
    QVERIFY(studio.tool(kShape).active()); // The first corner is left.
    studio.document.undo();
    QVERIFY(!studio.tool(kShape).active());
    QVERIFY(sameProjects(studio.document.project(), before));
    QCOMPARE(studio.document.undoStack().count(), 0);
}

void TestEditSession::undoOfALookTakesBackTheStepBelow()
{
    Document document(patchProject());
    document.push(setBackgroundCommand(document, 0xFF102030));
    EditSession look;
    document.show(look, {.policy = EditPolicy::Drop}, kAir, blow);
    QSignalSpy ended(&document, &Document::editEnded);
    document.undo();
    QCOMPARE(ended.count(), 1);
    QCOMPARE(document.undoStack().index(), 0);
    QVERIFY(document.project().background != 0xFF102030);
}

void TestEditSession::anEditOfSeveralPartsIsOneStepWithTheSameBytes()
{
    Document document(patchProject());
    const Project before = document.committed();
    const LayerAddress length = firstLayer(document, MapKind::Length);
    const LayerAddress gel = firstLayer(document, MapKind::Gel);
    sim::TiledRaster raster = document.committed().layer(length.group, length.map, length.layer)->raster;
    raster.setTexel(3, 3, {1000, 65535, 0, 0});
    EditSession edit = document.begin({.text = QStringLiteral("All")});
    edit.previewTiles(length, {{0, raster.tile(0)}});
    edit.preview({.aspect = Change::Aspect::Settings, .group = length.group},
                 [](Project& project) { project.groups.front().settings.greatestLengthM = 0.7F; });
    edit.previewTiles(gel, {{5, raster.tile(0)}});
    edit.preview(kAir, blow);
    const Project shown = document.project();
    QVERIFY(sameProjects(document.committed(), before));
    edit.commit();
    QCOMPARE(document.undoStack().count(), 1);
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("All"));
    QVERIFY(sameProjects(document.committed(), shown));
    QVERIFY(document.resolved(gel.group, gel.map)->texel(64 + 3, 64 + 3) == sim::Texel({1000, 0, 0, 0}));
    document.undo();
    QVERIFY(sameProjects(document.committed(), before));
    document.redo();
    QVERIFY(sameProjects(document.committed(), shown));
}

void TestEditSession::anEditThatChangesNothingLeavesNoStep()
{
    Document document(patchProject());
    EditSession edit;
    const sim::Wind wind = document.committed().wind;
    document.show(edit, {}, kAir, blow);
    document.show(edit, {}, kAir, [wind](Project& project) { project.wind = wind; });
    edit.commit();
    QVERIFY(!edit.active());
    QCOMPARE(document.undoStack().count(), 0);
    QVERIFY(document.project().wind == wind);
}

void TestEditSession::anEditEndsWithItsOwner()
{
    Document document(patchProject());
    const Project before = document.committed();
    {
        EditSession edit;
        document.show(edit, {}, kAir, blow);
        EditSession other = std::move(edit);
        QVERIFY(!edit.active()); // NOLINT(bugprone-use-after-move): tested is that it is not.
        QVERIFY(other.active());
    }
    QVERIFY(!document.previewing());
    QVERIFY(sameProjects(document.project(), before));
    EditSession longer;
    {
        Document gone(patchProject());
        longer = gone.begin({});
        QVERIFY(longer.active());
    }
    QVERIFY(!longer.active());
}

void TestEditSession::aPendingPolygonShowsItsCornersAndTheNextLine()
{
    Studio studio;
    clickPolygon(studio);
    ToolContext context = studio.context();
    Tool& shape = studio.tool(kShape);
    shape.hover(paintEvent(studio.document, 0.4F, 0.8F, 1.0F, {}), context);
    const std::vector<OverlayShape> shapes = shape.overlay();
    QCOMPARE(shapes.size(), std::size_t{2});
    QCOMPARE(shapes.front().uvHandles.size(), 3);
    QVERIFY(std::abs(shapes.back().uvOutline.back().y() - 0.8) < 1e-6);
    QVERIFY(shape.key(Qt::Key_Backspace, {}, context));
    QCOMPARE(shape.overlay().front().uvHandles.size(), 2);
}

void TestEditSession::anyEditsPreviewEqualsItsCommitAndUndoGivesBackTheStart()
{
    std::mt19937 random(7);
    Document document(patchProject());
    const Project start = document.committed();
    for (int round = 0; round < 40; ++round) {
        EditSession edit = document.begin({.text = QStringLiteral("Round")});
        for (int part = 0; part < 3; ++part) {
            const auto map = static_cast<MapKind>(random() % kMapKindCount);
            const LayerAddress at = firstLayer(document, map);
            const auto value = static_cast<std::uint16_t>(random() % 4);
            switch (random() % 3) {
            case 0: {
                sim::TiledRaster raster = document.project().layer(at.group, at.map, at.layer)->raster;
                raster.setTexel(static_cast<int>(random() % 256), 10, {value, 0, 0, 0});
                edit.previewTiles(at, {{0, raster.tile(0)}, {1, raster.tile(1)}});
                break;
            }
            case 1:
                edit.preview({.aspect = Change::Aspect::LayerList, .group = at.group, .map = at.map},
                             [at, value](Project& project) {
                                 project.layer(at.group, at.map, at.layer)->opacity = static_cast<float>(value) / 4.0F;
                             });
                break;
            default:
                edit.preview({.aspect = Change::Aspect::Settings, .group = at.group}, [value](Project& project) {
                    project.groups.front().settings.greatestLengthM = 0.1F * static_cast<float>(value + 1);
                });
            }
        }
        const Project shown = document.project();
        const auto shownLength = document.resolved(document.project().groups.front().id, MapKind::Length);
        edit.commit();
        QVERIFY(sameProjects(document.committed(), shown));
        QVERIFY(*document.resolved(document.project().groups.front().id, MapKind::Length) == *shownLength);
    }
    while (document.canUndo())
        document.undo();
    QVERIFY(sameProjects(document.committed(), start));
}

void TestEditSession::everyChangeRaisesTheRevision()
{
    Document document(patchProject());
    std::uint64_t last = document.revision();
    const auto grew = [&] { return document.revision() > std::exchange(last, document.revision()); };
    document.push(setBackgroundCommand(document, 0xFF102030));
    QVERIFY(grew());
    QVERIFY(!document.groomInput().preview);
    EditSession edit;
    document.show(edit, {}, {.aspect = Change::Aspect::Environment},
                  [](Project& project) { project.background = 0xFF302010; });
    QVERIFY(grew());
    QVERIFY(document.groomInput().preview);
    QCOMPARE(document.groomInput().revision, document.revision());
    edit.drop();
    QVERIFY(grew());
    document.undo();
    QVERIFY(grew());
    document.replace(patchProject());
    QVERIFY(grew());
}

HAIRPAINT_TEST(TestEditSession, Gui)
#include "test_edit_session.moc"
