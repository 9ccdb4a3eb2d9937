// A document takes no more than can be saved, and says so; maps can be made another size.
#include "model/document/layer_commands.h"
#include "model/document/paint_command.h"
#include "model/files/group_json.h"
#include "model/files/project_file.h"
#include "model/project/content_budget.h"
#include "tests/model/fixtures.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

/// One group whose length map alone is of this size, with `layers` empty layers.
Project projectOf(int size, int layers)
{
    Project project = patchProject();
    MapStack& length = project.groups.front().map(MapKind::Length);
    length.size = size;
    length.layers.clear();
    for (int i = 0; i < layers; ++i)
        length.layers.push_back(makeLayer(project, mapSpec(MapKind::Length), size, QStringLiteral("L")));
    return project;
}

/// All tiles hold pixels; they share them, so that the test does not need the memory that is counted.
void paintAllOver(Layer& layer)
{
    sim::TiledRaster one(256, 2);
    one.setTexel(1, 1, {40000, 65535, 0, 0});
    for (int index = 0; index < layer.raster.tileCount(); ++index)
        layer.raster.setTile(index, one.tile(0));
}

LayerTiles allOver(const Layer& layer)
{
    Layer painted = layer;
    paintAllOver(painted);
    LayerTiles tiles;
    for (int index = 0; index < painted.raster.tileCount(); ++index)
        tiles.emplace_back(index, painted.raster.tile(index));
    return tiles;
}

} // namespace

class TestContentBudget : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void layersThatCouldNotBeSavedAreRefused_data();
    void layersThatCouldNotBeSavedAreRefused();
    void paintingThatCouldNotBeSavedIsRefused();
    void tooManyLayersInAMapAreRefused();
    void whatIsTooLargeAlreadyCanBeMadeSmaller();
    void whatIsTooLargeAlreadyMayNotGrow();
    void whatIsPaintedTooMuchAlreadyMayNotGrow();
    void layersOfMapsThatAFileLacksCountToo();
    void aMapIsResized_data();
    void aMapIsResized();
    void resizingKeepsWhatIsPainted();
    void resizingBeyondTheBudgetIsRefused();
};

void TestContentBudget::layersThatCouldNotBeSavedAreRefused_data()
{
    QTest::addColumn<int>("size");
    QTest::addColumn<int>("fitting");
    QTest::newRow("4096") << 4096 << 16;
    QTest::newRow("8192") << 8192 << 4;
}

void TestContentBudget::layersThatCouldNotBeSavedAreRefused()
{
    QFETCH(int, size);
    QFETCH(int, fitting);
    Project project = projectOf(size, fitting);
    for (Layer& layer : project.groups.front().map(MapKind::Length).layers)
        paintAllOver(layer);
    QCOMPARE(excessOf(project.groups), ContentExcess::None);
    Document document(project);
    QSignalSpy refused(&document, &Document::refused);
    const LayerAddress at = firstLayer(document, MapKind::Length);
    // An empty one costs nothing; a copy of a painted one does.
    document.push(addLayerCommand(document, at.group, at.map, QStringLiteral("Empty")));
    QCOMPARE(document.undoStack().count(), 1);
    const Layer copy = *document.committed().layer(at.group, at.map, at.layer);
    document.push(insertLayerCommand(document, at.group, at.map, copy, 0, QStringLiteral("Duplicate")));
    QCOMPARE(document.undoStack().count(), 1);
    QCOMPARE(refused.count(), 1);
    QVERIFY(refused.front().front().toString().contains(QStringLiteral("1024")));
}

void TestContentBudget::paintingThatCouldNotBeSavedIsRefused()
{
    Project project = projectOf(4096, 17);
    MapStack& length = project.groups.front().map(MapKind::Length);
    for (std::size_t i = 0; i < 16; ++i)
        paintAllOver(length.layers[i]);
    const Layer last = length.layers.back();
    Document document(project);
    const Project before = document.committed();
    QSignalSpy refused(&document, &Document::refused);
    EditSession edit = document.begin({.text = QStringLiteral("Fill")});
    const Id group = document.committed().groups.front().id;
    edit.previewTiles({group, MapKind::Length, last.id}, allOver(last));
    edit.commit();
    QCOMPARE(refused.count(), 1);
    QCOMPARE(document.undoStack().count(), 0);
    QVERIFY(!document.previewing());
    QVERIFY(document.project().groups == before.groups);
}

void TestContentBudget::tooManyLayersInAMapAreRefused()
{
    Document document(projectOf(256, kMostLayersInMap));
    QSignalSpy refused(&document, &Document::refused);
    const LayerAddress at = firstLayer(document, MapKind::Length);
    document.push(addLayerCommand(document, at.group, at.map, QStringLiteral("One more")));
    QCOMPARE(refused.count(), 1);
    QCOMPARE(document.undoStack().count(), 0);
    QTemporaryDir folder;
    QVERIFY(saveProject(document.committed(), folder.filePath(QStringLiteral("full.hairpaint")), {}).has_value());
}

void TestContentBudget::whatIsTooLargeAlreadyCanBeMadeSmaller()
{
    Document document(projectOf(256, kMostLayersInMap + 2));
    document.push(removeLayerCommand(document, firstLayer(document, MapKind::Length)));
    QCOMPARE(document.undoStack().count(), 1);
}

void TestContentBudget::whatIsTooLargeAlreadyMayNotGrow()
{
    Document document(projectOf(256, kMostLayersInMap + 2));
    QSignalSpy refused(&document, &Document::refused);
    const LayerAddress at = firstLayer(document, MapKind::Length);
    document.push(addLayerCommand(document, at.group, at.map, QStringLiteral("One more")));
    QCOMPARE(refused.count(), 1);
    QCOMPARE(document.undoStack().count(), 0);
    // What is not too much may.
    document.push(addLayerCommand(document, at.group, MapKind::Gel, QStringLiteral("Elsewhere")));
    QCOMPARE(document.undoStack().count(), 1);
}

void TestContentBudget::whatIsPaintedTooMuchAlreadyMayNotGrow()
{
    Project project = projectOf(4096, 18);
    MapStack& length = project.groups.front().map(MapKind::Length);
    for (std::size_t i = 0; i < 17; ++i)
        paintAllOver(length.layers[i]);
    const Layer first = length.layers.front();
    const Layer last = length.layers.back();
    Document document(project);
    QSignalSpy refused(&document, &Document::refused);
    const Id group = document.committed().groups.front().id;
    document.push(
        paintCommand(document, {group, MapKind::Length, last.id}, allOver(last), QStringLiteral("Fill another")));
    QCOMPARE(refused.count(), 1);
    QCOMPARE(document.undoStack().count(), 0);
    document.push(paintCommand(document, {group, MapKind::Length, first.id}, {{0, last.raster.tile(0)}},
                               QStringLiteral("Clear a tile")));
    QCOMPARE(document.undoStack().count(), 1);
}

void TestContentBudget::layersOfMapsThatAFileLacksCountToo()
{
    // Length maps alone, which the file may hold; with the maps that each group gets they are too many to be saved.
    Project project;
    constexpr int kLayers = kMostLayers / kMostGroups;
    for (int g = 0; g < kMostGroups; ++g) {
        HairGroup group;
        group.id = project.takeId();
        MapStack length{.kind = MapKind::Length, .size = 256, .layers = {}};
        for (int layer = 0; layer < kLayers; ++layer)
            length.layers.push_back(makeLayer(project, mapSpec(MapKind::Length), 256, QStringLiteral("L")));
        group.maps.emplace_back(std::move(length));
        project.groups.push_back(std::move(group));
    }
    QVERIFY(checkGroupCounts(project.groups));
    QVERIFY(!groupsFromJson(groupsToJson(project.groups), project.nextId));
    project.groups.resize(kMostLayers / (kLayers + kMapKindCount));
    QVERIFY(groupsFromJson(groupsToJson(project.groups), project.nextId));
}

void TestContentBudget::aMapIsResized_data()
{
    QTest::addColumn<int>("map");
    QTest::addColumn<int>("size");
    for (const int size : {256, 512, 2048}) {
        QTest::addRow("length to %d", size) << static_cast<int>(MapKind::Length) << size;
        QTest::addRow("braid to %d", size) << static_cast<int>(MapKind::Braid) << size;
        QTest::addRow("colour to %d", size) << static_cast<int>(MapKind::Colour) << size;
    }
}

void TestContentBudget::aMapIsResized()
{
    QFETCH(int, map);
    QFETCH(int, size);
    const auto kind = static_cast<MapKind>(map);
    const MapSpec& spec = mapSpec(kind);
    constexpr int kBefore = 1024;
    Project project = patchProject();
    MapStack& stack = project.groups.front().map(kind);
    stack.size = kBefore;
    stack.layers = {makeLayer(project, spec, kBefore, QStringLiteral("L"))};
    // The left half is painted with one value.
    sim::Texel value{};
    for (int i = 0; i < spec.valueChannels; ++i)
        value[static_cast<std::size_t>(i)] = spec.bilinear() ? static_cast<std::uint16_t>(20000 + i) : 2;
    value[static_cast<std::size_t>(spec.valueChannels)] = 65535;
    for (int y = 0; y < kBefore; ++y)
        for (int x = 0; x < kBefore / 2; ++x)
            stack.layers.front().raster.setTexel(x, y, value);
    Document document(project);
    const Project before = document.committed();
    const Id group = before.groups.front().id;
    document.push(resizeMapCommand(document, group, kind, size));
    const MapStack& after = document.committed().groups.front().map(kind);
    QCOMPARE(after.size, size);
    QCOMPARE(document.resolved(group, kind)->size(), size);
    const sim::TiledRaster& raster = after.layers.front().raster;
    QCOMPARE(raster.size(), size);
    // Half coverage at the edge never mixes the value itself with what is not painted.
    for (const int x : {0, size / 4, size / 2 - 1})
        for (int i = 0; i < spec.valueChannels; ++i)
            QCOMPARE(raster.texel(x, size / 3)[static_cast<std::size_t>(i)], value[static_cast<std::size_t>(i)]);
    QCOMPARE(static_cast<int>(raster.texel(size / 4, 0)[static_cast<std::size_t>(spec.valueChannels)]), 65535);
    QCOMPARE(static_cast<int>(raster.texel(size * 3 / 4, 0)[static_cast<std::size_t>(spec.valueChannels)]), 0);
    document.undo();
    QVERIFY(sameProjects(document.committed(), before));
    QVERIFY(resizeMapCommand(document, group, kind, kBefore) == nullptr);
}

void TestContentBudget::resizingKeepsWhatIsPainted()
{
    // Twice as large and back again: the same texels but for rounding.
    Project project = patchProject();
    sim::TiledRaster& raster = project.groups.front().map(MapKind::Gel).layers.front().raster;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            raster.setTexel(x, y, {static_cast<std::uint16_t>(100 * x + 50 * y), 65535, 0, 0});
    Document document(project);
    const Id group = project.groups.front().id;
    const auto before = document.resolved(group, MapKind::Gel);
    document.push(resizeMapCommand(document, group, MapKind::Gel, 512));
    const auto large = document.resolved(group, MapKind::Gel);
    for (const glm::vec2 uv : {glm::vec2(0.2F, 0.3F), glm::vec2(0.5F, 0.77F), glm::vec2(0.91F, 0.4F)})
        QVERIFY(std::abs(before->sampleScalar(uv) - large->sampleScalar(uv)) < 1e-4F);
    document.push(resizeMapCommand(document, group, MapKind::Gel, 256));
    const auto back = document.resolved(group, MapKind::Gel);
    for (const glm::vec2 uv : {glm::vec2(0.2F, 0.3F), glm::vec2(0.5F, 0.77F), glm::vec2(0.91F, 0.4F)})
        QVERIFY(std::abs(before->sampleScalar(uv) - back->sampleScalar(uv)) < 1e-3F);
}

void TestContentBudget::resizingBeyondTheBudgetIsRefused()
{
    Project project = projectOf(256, 65);
    Document document(project);
    QSignalSpy refused(&document, &Document::refused);
    QVERIFY(resizeMapCommand(document, project.groups.front().id, MapKind::Length, 8192) == nullptr);
    QCOMPARE(refused.count(), 1);
    QVERIFY(resizeMapCommand(document, project.groups.front().id, MapKind::Length, 4096) != nullptr);
}

HAIRPAINT_TEST(TestContentBudget, Gui)
#include "test_content_budget.moc"
