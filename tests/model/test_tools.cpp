// Every tool: what is shown while it works is what stays; undo and Esc leave no trace; the selection holds.
#include "model/document/scene_commands.h"
#include "model/tools/tool_list.h"
#include "tests/model/tool_studio.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

/// Tools that paint, each on every map.
void addToolRows()
{
    QTest::addColumn<QString>("tool");
    QTest::addColumn<int>("map");
    QTest::addColumn<bool>("mirror");
    for (const char* tool : {"brush", "eraser", "gradient", "fill", "shape"})
        for (const MapSpec& spec : mapSpecs())
            for (const bool mirror : {false, true})
                QTest::addRow("%s on %s%s", tool, spec.id, mirror ? ", mirrored" : "")
                    << QString::fromLatin1(tool) << static_cast<int>(spec.kind) << mirror;
}

/// Something to erase and to fill around.
void prepare(Studio& studio)
{
    studio.settings.opacity = 1.0F;
    studio.settings.brushSizeM = 0.05F;
    studio.press(kBrush, 0.2F, 0.3F);
    studio.move(kBrush, 0.6F, 0.7F);
    studio.release(kBrush, 0.5F, 0.5F);
    studio.document.undoStack().clear();
}

void randomStroke(Studio& studio, const QString& tool, std::mt19937& random, bool released)
{
    const auto unit = [&random] { return static_cast<float>(random() % 1000) / 1000.0F; };
    studio.settings.opacity = 0.3F + 0.7F * unit();
    studio.settings.hardness = unit();
    studio.settings.brushSizeM = 0.005F + 0.05F * unit();
    studio.settings.pressureOpacity = random() % 2 == 0;
    studio.settings.shape = static_cast<ShapeKind>(random() % 2);
    studio.settings.gradient = static_cast<GradientKind>(random() % 2);
    studio.press(tool, unit(), unit(), unit());
    for (int i = 0; i < 6; ++i)
        studio.move(tool, 1.2F * unit() - 0.1F, 1.2F * unit() - 0.1F, unit());
    studio.move(tool, 0.5F, 0.4F, 0.5F);
    if (released)
        studio.release(tool, 0.5F, 0.4F);
}

/// Columns reflected at the middle.
bool isSymmetric(const sim::TiledRaster& raster)
{
    for (int y = 0; y < raster.size(); ++y)
        for (int x = 0; x < raster.size() / 2; ++x)
            if (raster.texel(x, y) != raster.texel(raster.size() - 1 - x, y))
                return false;
    return true;
}

} // namespace

class TestTools : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void thePreviewIsTheCommit_data() { addToolRows(); }
    void thePreviewIsTheCommit();
    void cancellingLeavesNoTrace_data() { addToolRows(); }
    void cancellingLeavesNoTrace();
    void nothingIsPaintedOutsideTheSelection_data() { addToolRows(); }
    void nothingIsPaintedOutsideTheSelection();
    void lockedAndHiddenLayersStayAsTheyAre_data() { addToolRows(); }
    void lockedAndHiddenLayersStayAsTheyAre();
    void mirroredStrokesAreSymmetric_data() { addToolRows(); }
    void mirroredStrokesAreSymmetric();
    void undoDuringAStrokeOnlyCancelsIt();
    void anyOtherChangeCommitsTheStroke();
    void oneStrokeIsOneStepNamedAfterToolAndMap();
    void toolsHaveTheirOwnIdsKeysAndHints();
    void eachEventTellsOnlyTheTilesItTouched();
};

void TestTools::thePreviewIsTheCommit()
{
    QFETCH(QString, tool);
    QFETCH(int, map);
    QFETCH(bool, mirror);
    Studio studio;
    studio.map = static_cast<MapKind>(map);
    prepare(studio);
    studio.mirror = mirror;
    std::mt19937 random(static_cast<unsigned>(map) + 17);
    const Project first = studio.document.committed();
    for (int stroke = 0; stroke < 2; ++stroke) {
        randomStroke(studio, tool, random, false);
        const Project previewed = studio.document.project();
        const auto shown = studio.shown();
        studio.release(tool, 0.5F, 0.4F);
        QVERIFY(!studio.tool(tool).active());
        QVERIFY(!studio.document.previewing());
        QVERIFY(sameProjects(studio.document.committed(), previewed));
        QCOMPARE(studio.shown(), shown);
        const Document fresh(studio.document.committed());
        QVERIFY(*fresh.resolved(studio.context().target.group, studio.map) == *shown);
    }
    const Project last = studio.document.committed();
    if (tool != QLatin1String("fill")) // A click may fill what has the value already.
        QVERIFY(!sameProjects(first, last));
    while (studio.document.undoStack().canUndo())
        studio.document.undo();
    QVERIFY(sameProjects(studio.document.committed(), first));
    while (studio.document.undoStack().canRedo())
        studio.document.redo();
    QVERIFY(sameProjects(studio.document.committed(), last));
}

void TestTools::cancellingLeavesNoTrace()
{
    QFETCH(QString, tool);
    QFETCH(int, map);
    QFETCH(bool, mirror);
    Studio studio;
    studio.map = static_cast<MapKind>(map);
    prepare(studio);
    studio.mirror = mirror;
    const Project first = studio.document.committed();
    const sim::TiledRaster shown = *studio.shown();
    std::mt19937 random(4);
    randomStroke(studio, tool, random, false);
    QVERIFY(studio.tool(tool).active());
    ToolContext context = studio.context();
    studio.tool(tool).cancel(context);
    QVERIFY(!studio.tool(tool).active());
    QVERIFY(!studio.document.previewing());
    QVERIFY(sameProjects(studio.document.project(), first));
    QVERIFY(*studio.shown() == shown);
    QCOMPARE(studio.document.undoStack().count(), 0);
    studio.release(tool, 0.5F, 0.5F);
    QCOMPARE(studio.document.undoStack().count(), 0);
}

void TestTools::nothingIsPaintedOutsideTheSelection()
{
    QFETCH(QString, tool);
    QFETCH(int, map);
    QFETCH(bool, mirror);
    Studio studio;
    studio.map = static_cast<MapKind>(map);
    prepare(studio);
    studio.mirror = mirror;
    const sim::TiledRaster before = studio.layer();
    studio.selection.setRectangle(QRectF(0.25, 0.375, 0.375, 0.25)); // u 64..160, v 96..160: rows 96..160.
    std::mt19937 random(21);
    for (int i = 0; i < 2; ++i)
        randomStroke(studio, tool, random, true);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            if (x < 64 || x >= 160 || y < 96 || y >= 160)
                QCOMPARE(studio.layer().texel(x, y), before.texel(x, y));
}

void TestTools::lockedAndHiddenLayersStayAsTheyAre()
{
    QFETCH(QString, tool);
    QFETCH(int, map);
    for (const bool locked : {true, false}) {
        Project project = patchProject();
        Layer& layer = project.groups.front().map(static_cast<MapKind>(map)).layers.front();
        layer.locked = locked;
        layer.visible = locked;
        Studio studio(std::move(project));
        studio.map = static_cast<MapKind>(map);
        std::mt19937 random(3);
        randomStroke(studio, tool, random, true);
        QVERIFY(!studio.tool(tool).active());
        QCOMPARE(studio.document.undoStack().count(), 0);
    }
}

void TestTools::mirroredStrokesAreSymmetric()
{
    QFETCH(QString, tool);
    QFETCH(int, map);
    Studio studio;
    studio.map = static_cast<MapKind>(map);
    studio.mirror = true;
    prepare(studio);
    QVERIFY(isSymmetric(studio.layer()));
    std::mt19937 random(8);
    for (int i = 0; i < 3; ++i)
        randomStroke(studio, tool, random, true);
    QVERIFY(isSymmetric(studio.layer()));
}

void TestTools::undoDuringAStrokeOnlyCancelsIt()
{
    Studio studio;
    prepare(studio);
    studio.press(kBrush, 0.2F, 0.2F);
    studio.release(kBrush, 0.2F, 0.2F);
    const Project before = studio.document.committed();
    studio.press(kBrush, 0.5F, 0.5F);
    studio.move(kBrush, 0.7F, 0.5F);
    studio.document.undo();
    QVERIFY(!studio.tool(kBrush).active());
    QCOMPARE(studio.document.undoStack().index(), 1);
    QVERIFY(sameProjects(studio.document.project(), before));
    studio.document.undo();
    QCOMPARE(studio.document.undoStack().index(), 0);
}

void TestTools::anyOtherChangeCommitsTheStroke()
{
    Studio studio;
    studio.press(kBrush, 0.5F, 0.5F);
    studio.document.push(setBackgroundCommand(studio.document, 0xFF445566));
    QVERIFY(!studio.tool(kBrush).active());
    QCOMPARE(studio.document.undoStack().count(), 2);
    QCOMPARE(studio.document.undoStack().text(0), QStringLiteral("Brush on Length"));
    QVERIFY(studio.layer().texel(128, 128)[1] == 65535);
    studio.press(kBrush, 0.2F, 0.5F);
    const EditSession other = studio.document.begin({});
    QCOMPARE(studio.document.undoStack().count(), 3);
}

void TestTools::oneStrokeIsOneStepNamedAfterToolAndMap()
{
    Studio studio;
    studio.press(kBrush, 0.2F, 0.2F);
    for (int i = 0; i < 20; ++i)
        studio.move(kBrush, 0.2F + 0.02F * static_cast<float>(i), 0.3F);
    studio.release(kBrush, 0.6F, 0.3F);
    QCOMPARE(studio.document.undoStack().count(), 1);
    QCOMPARE(studio.document.undoStack().undoText(), QStringLiteral("Brush on Length"));
    studio.press(QStringLiteral("eraser"), 0.2F, 0.2F);
    studio.release(QStringLiteral("eraser"), 0.2F, 0.2F);
    QCOMPARE(studio.document.undoStack().undoText(), QStringLiteral("Eraser on Length"));
    studio.press(QStringLiteral("eraser"), 0.9F, 0.9F); // Nothing there to erase: no step.
    studio.release(QStringLiteral("eraser"), 0.9F, 0.9F);
    QCOMPARE(studio.document.undoStack().count(), 2);
}

void TestTools::toolsHaveTheirOwnIdsKeysAndHints()
{
    QStringList ids, keys;
    for (const auto& tool : makeTools()) {
        ids << QString::fromLatin1(tool->name());
        keys << QKeySequence(tool->traits().key).toString();
        QVERIFY(!tool->title().isEmpty());
        QVERIFY(!tool->hint().isEmpty());
    }
    QCOMPARE(ids.join(QLatin1Char(' ')),
             QStringLiteral("brush eraser comb part grab fingers scissors gradient fill shape select picker"));
    QCOMPARE(keys.join(QLatin1Char(' ')), QStringLiteral("B E C P Y R K G Shift+G U M I"));
}

void TestTools::eachEventTellsOnlyTheTilesItTouched()
{
    Studio studio;
    studio.settings.brushSizeM = 0.01F; // 12.8 of 256 texels.
    std::vector<std::vector<int>> told;
    QObject::connect(&studio.document, &Document::changed, &studio.document,
                     [&](const Change& change) { told.push_back(change.tiles); });
    studio.press(kBrush, 32.0F / 256.0F, 1.0F - 32.0F / 256.0F);
    studio.move(kBrush, 96.0F / 256.0F, 1.0F - 32.0F / 256.0F);
    studio.move(kBrush, 97.0F / 256.0F, 1.0F - 32.0F / 256.0F); // Less than a dab's spacing.
    studio.move(kBrush, 98.0F / 256.0F, 1.0F - 32.0F / 256.0F);
    studio.release(kBrush, 98.0F / 256.0F, 1.0F - 32.0F / 256.0F);
    QCOMPARE(told.front(), std::vector<int>{0});
    QCOMPARE(told[1], (std::vector<int>{0, 1}));
    for (std::size_t i = 2; i + 1 < told.size(); ++i)
        QCOMPARE(told[i], std::vector<int>{1});
    QCOMPARE(told.back(), (std::vector<int>{0, 1}));
}

HAIRPAINT_TEST(TestTools, Gui)
#include "test_tools.moc"
