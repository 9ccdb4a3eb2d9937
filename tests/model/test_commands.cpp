// Undo commands: each undone exactly, named as the user knows it, and null where nothing differs.
#include "model/document/group_commands.h"
#include "model/document/layer_commands.h"
#include "model/document/paint_command.h"
#include "model/document/scene_commands.h"
#include "model/document/undo_budget.h"
#include "model/styles/preset.h"
#include "tests/model/fixtures.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <random>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

/// A command of any type on random content; null at times.
CommandPtr randomCommand(Document& document, std::mt19937& random)
{
    const Project& project = document.committed();
    const auto& group = project.groups[random() % project.groups.size()];
    const auto map = static_cast<MapKind>(random() % kMapKindCount);
    const std::vector<Layer>& layers = group.map(map).layers;
    LayerAddress address{.group = group.id, .map = map};
    if (!layers.empty())
        address.layer = layers[random() % layers.size()].id;
    const Layer* layer = project.layer(address.group, map, address.layer);
    const QString name = QStringLiteral("Name %1").arg(random() % 100);
    switch (random() % 17) {
    case 0:
        return addLayerCommand(document, group.id, map, name);
    case 1:
        return removeLayerCommand(document, address);
    case 2:
        return moveLayerCommand(document, address, static_cast<int>(random() % 4));
    case 3:
        return layer == nullptr
                   ? nullptr
                   : insertLayerCommand(document, group.id, map, *layer, static_cast<int>(random() % 3), name);
    case 4: {
        if (layer == nullptr)
            return nullptr;
        LayerProperties properties = propertiesOf(*layer);
        properties.opacity = static_cast<float>(random() % 5) / 4.0F;
        properties.visible = random() % 2 == 0;
        properties.locked = random() % 4 == 0;
        return setLayerPropertiesCommand(document, address, properties, name);
    }
    case 5:
        return addGroupCommand(document, name);
    case 6:
        return project.groups.size() > 1 ? removeGroupCommand(document, group.id) : nullptr;
    case 7:
        return renameGroupCommand(document, group.id, name);
    case 8:
        return showGroupCommand(document, group.id, random() % 2 == 0);
    case 9: {
        sim::GroupSettings settings = group.settings;
        settings.greatestLengthM = static_cast<float>(1 + random() % 100) / 100.0F;
        return setSettingsCommand(document, group.id, settings, name);
    }
    case 10: {
        LightSettings light = project.light;
        light.intensity = static_cast<float>(random() % 4);
        return setLightCommand(document, light);
    }
    case 11:
        return setBackgroundCommand(document, static_cast<QRgb>(random()) | 0xFF000000U);
    case 12:
        return applyPresetCommand(document, presetFrom(project, name));
    case 14: {
        sim::Wind wind = project.wind;
        wind.enabled = random() % 2 == 0;
        wind.velocity.x = static_cast<float>(random() % 5);
        return setWindCommand(document, wind);
    }
    case 15:
        return moveGroupCommand(document, group.id, static_cast<int>(random() % 3));
    case 13:
        return setHeadCommand(document, headOf(makePatchHead(4)), {});
    default: {
        if (layer == nullptr)
            return nullptr;
        sim::TiledRaster raster = layer->raster;
        std::vector<std::pair<int, sim::RasterTilePtr>> tiles;
        for (int i = 0; i < 3; ++i) {
            const auto at = [&] { return static_cast<int>(random() % 256); };
            raster.setTexel(at(), at(), {static_cast<std::uint16_t>(random() % 4), 65535, 65535, 65535});
        }
        tiles.reserve(static_cast<std::size_t>(raster.tileCount()));
        for (int index = 0; index < raster.tileCount(); ++index)
            tiles.emplace_back(index, raster.tile(index));
        return paintCommand(document, address, std::move(tiles), name);
    }
    }
}

} // namespace

class TestCommands : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void undoingAllGivesTheFirstContentAndRedoingAllTheLast_data();
    void undoingAllGivesTheFirstContentAndRedoingAllTheLast();
    void resolvedMapsFollowEveryStep();
    void layersAreAddedMovedAndRemoved();
    void groupsChangeOrder();
    void namesSayWhatWasDone();
    void aHeadsOwnPictureComesAndGoesWithIt();
    void nothingToDoGivesNoCommand();
    void aPresetIsOneStepAndKeepsIdsOfGroupsOfTheSameName();
    void aPresetFlattensWhatIsShown();
    void thePreviewOfAPresetIsItsCommit();
    void windOnOrOffIsNoStepAndStaysWhateverIsUndone();
    void theDocumentKnowsWhetherItIsSaved();
    void theHistoryForgetsItsOldestStepsWithinItsBudget();
    void aPushCountsItsOwnCommandAlone();
    void sharedTilesCostTheHistoryNothing();
};

void TestCommands::undoingAllGivesTheFirstContentAndRedoingAllTheLast_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 8; ++seed)
        QTest::addRow("seed %d", seed) << seed;
}

void TestCommands::undoingAllGivesTheFirstContentAndRedoingAllTheLast()
{
    QFETCH(int, seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const Project first = patchProject();
    Document document(first);
    for (int step = 0; step < 60; ++step)
        document.push(randomCommand(document, random));
    QVERIFY(document.undoStack().count() > 20);
    const Project last = document.committed();
    QVERIFY(!sameProjects(first, last));
    for (int round = 0; round < 2; ++round) {
        while (document.undoStack().canUndo())
            document.undo();
        QVERIFY(sameProjects(document.committed(), first));
        while (document.undoStack().canRedo())
            document.redo();
        QVERIFY(sameProjects(document.committed(), last));
    }
}

void TestCommands::resolvedMapsFollowEveryStep()
{
    std::mt19937 random(99);
    Document document(patchProject());
    const auto resolvedAnew = [&] {
        const Document fresh(document.committed());
        for (const HairGroup& group : document.committed().groups)
            for (const MapSpec& spec : mapSpecs())
                if (!(*fresh.resolved(group.id, spec.kind) == *document.resolved(group.id, spec.kind)))
                    return false;
        return true;
    };
    for (int step = 0; step < 40; ++step) {
        document.push(randomCommand(document, random));
        QVERIFY(resolvedAnew());
        if (step % 5 == 4) {
            document.undo();
            QVERIFY(resolvedAnew());
        }
    }
}

void TestCommands::layersAreAddedMovedAndRemoved()
{
    Document document(patchProject());
    const Id group = document.project().groups.front().id;
    const auto names = [&] {
        QStringList all;
        for (const Layer& layer : document.project().group(group)->map(MapKind::Curl).layers)
            all << layer.name;
        return all.join(QLatin1Char(' '));
    };
    document.push(addLayerCommand(document, group, MapKind::Curl, QStringLiteral("B")));
    document.push(addLayerCommand(document, group, MapKind::Curl, QStringLiteral("C")));
    QCOMPARE(names(), QStringLiteral("Layer 1 B C"));
    LayerAddress c{group, MapKind::Curl, document.project().group(group)->map(MapKind::Curl).layers[2].id};
    document.push(moveLayerCommand(document, c, 0));
    QCOMPARE(names(), QStringLiteral("C Layer 1 B"));
    document.push(removeLayerCommand(document, c));
    QCOMPARE(names(), QStringLiteral("Layer 1 B"));
    document.undo();
    QCOMPARE(names(), QStringLiteral("C Layer 1 B"));
    QCOMPARE(document.project().group(group)->map(MapKind::Curl).layers[0].id, c.layer);
    Layer copy = *document.project().layer(group, MapKind::Curl, c.layer);
    copy.name = QStringLiteral("Copy");
    document.push(insertLayerCommand(document, group, MapKind::Curl, copy, 1, QStringLiteral("Duplicate layer")));
    QCOMPARE(names(), QStringLiteral("C Copy Layer 1 B"));
    QVERIFY(document.project().group(group)->map(MapKind::Curl).layers[1].id != c.layer);
}

void TestCommands::groupsChangeOrder()
{
    Document document(patchProject());
    for (const char* name : {"B", "C", "D"})
        document.push(addGroupCommand(document, QLatin1String(name)));
    const auto order = [&document] {
        QString names;
        for (const HairGroup& group : document.project().groups)
            names += group.name.front();
        return names;
    };
    const auto idOf = [&document](std::size_t index) { return document.project().groups[index].id; };
    QCOMPARE(order(), QStringLiteral("SBCD"));
    document.push(moveGroupCommand(document, idOf(0), 2));
    QCOMPARE(order(), QStringLiteral("BCSD"));
    document.push(moveGroupCommand(document, idOf(3), 0));
    QCOMPARE(order(), QStringLiteral("DBCS"));
    document.push(moveGroupCommand(document, idOf(1), 99));
    QCOMPARE(order(), QStringLiteral("DCSB"));
    document.undo();
    document.undo();
    document.undo();
    QCOMPARE(order(), QStringLiteral("SBCD"));
}

void TestCommands::namesSayWhatWasDone()
{
    Document document(patchProject());
    const Id group = document.project().groups.front().id;
    const LayerAddress length = firstLayer(document, MapKind::Length);
    QCOMPARE(addLayerCommand(document, group, MapKind::Length, QStringLiteral("X"))->text(),
             QStringLiteral("Add layer to Length"));
    QCOMPARE(removeLayerCommand(document, length)->text(), QStringLiteral("Remove layer \"Layer 1\""));
    QCOMPARE(moveLayerCommand(document, length, 1)->text(), QStringLiteral("Move layer \"Layer 1\""));
    QCOMPARE(addGroupCommand(document, QStringLiteral("Beard"))->text(), QStringLiteral("Add group \"Beard\""));
    QVERIFY(removeGroupCommand(document, group) == nullptr); // A project without groups can't be saved.
    document.push(addGroupCommand(document, QStringLiteral("Beard")));
    QCOMPARE(removeGroupCommand(document, group)->text(), QStringLiteral("Remove group \"Scalp\""));
    QCOMPARE(moveGroupCommand(document, group, 1)->text(), QStringLiteral("Move group \"Scalp\""));
    QCOMPARE(showGroupCommand(document, group, false)->text(), QStringLiteral("Hide group \"Scalp\""));
    QCOMPARE(applyPresetCommand(document, presetFrom(document.project(), QStringLiteral("Bob")))->text(),
             QStringLiteral("Apply style \"Bob\""));
    QCOMPARE(setBackgroundCommand(document, 0xFF123456)->text(), QStringLiteral("Change background"));
    QCOMPARE(setSkinCommand(document, SkinTone::Olive)->text(), QStringLiteral("Change skin tone"));
}

void TestCommands::aHeadsOwnPictureComesAndGoesWithIt()
{
    Document document(patchProject());
    document.push(setSkinCommand(document, SkinTone::Brown));
    const auto plain = document.project().head;
    auto pictured = std::make_shared<Head>(*plain);
    pictured->texture = std::make_shared<const sim::MeshTexture>();
    document.push(setHeadCommand(document, pictured, {}));
    QVERIFY(document.project().skin == SkinTone::Own);
    document.undo();
    QVERIFY(document.project().skin == SkinTone::Brown);
    document.redo();
    QVERIFY(document.project().skin == SkinTone::Own);
    // The same head with other landmarks leaves what was chosen.
    document.push(setSkinCommand(document, SkinTone::Fair));
    document.push(setHeadCommand(document, std::make_shared<Head>(*pictured), {}));
    QVERIFY(document.project().skin == SkinTone::Fair);
    document.push(setSkinCommand(document, SkinTone::Own));
    document.push(setHeadCommand(document, plain, {}));
    QVERIFY(document.project().skin == SkinTone::Clay);
}

void TestCommands::nothingToDoGivesNoCommand()
{
    Document document(patchProject());
    const Project& project = document.project();
    const LayerAddress length = firstLayer(document, MapKind::Length);
    const Layer& layer = *project.layer(length.group, length.map, length.layer);
    QCOMPARE(setLayerPropertiesCommand(document, length, propertiesOf(layer), QString()), nullptr);
    QCOMPARE(setSettingsCommand(document, length.group, project.groups.front().settings, QString()), nullptr);
    QCOMPARE(setWindCommand(document, project.wind), nullptr);
    QCOMPARE(setLightCommand(document, project.light), nullptr);
    QCOMPARE(setBackgroundCommand(document, project.background), nullptr);
    QCOMPARE(setSkinCommand(document, project.skin), nullptr);
    QCOMPARE(moveGroupCommand(document, length.group, 3), nullptr);
    QCOMPARE(setHeadCommand(document, project.head, shapesOfHead(project.worn)), nullptr);
    QCOMPARE(removeWornCommand(document, project.nextId), nullptr);
    QCOMPARE(paintCommand(document, length, {{0, layer.raster.tile(0)}}, QString()), nullptr);
    document.push(nullptr);
    QCOMPARE(document.undoStack().count(), 0);
}

void TestCommands::aPresetIsOneStepAndKeepsIdsOfGroupsOfTheSameName()
{
    Project styled = patchProject();
    styled.groups.front().settings.greatestLengthM = 0.6F;
    styled.groups.push_back(makeGroup(styled, QStringLiteral("Beard")));
    for (HairGroup& group : styled.groups)
        group.map(MapKind::Density).layers[0].raster.setUniform(3, {60000, 65535, 0, 0});
    const Preset preset = presetFrom(styled, QStringLiteral("Viking"));

    Project start = patchProject();
    start.groups.insert(start.groups.begin(), makeGroup(start, QStringLiteral("Brows")));
    Document document(start);
    const Id scalp = document.project().groups[1].id;
    document.push(applyPresetCommand(document, preset));
    QCOMPARE(document.undoStack().count(), 1);
    const Project& project = document.project();
    QCOMPARE(project.groups.size(), 3U);
    QVERIFY(project.groups[0] == start.groups[0]); // Brows, of which the style has none.
    QCOMPARE(project.groups[1].id, scalp);
    QCOMPARE(project.groups[1].settings.greatestLengthM, 0.6F);
    QCOMPARE(project.groups[2].name, QStringLiteral("Beard"));
    QVERIFY(project.groups[2].id != scalp && project.groups[2].id != start.groups[0].id);
    QSet<Id> ids;
    for (const std::size_t group : {1U, 2U})
        for (const MapStack& stack : project.groups[group].maps) {
            QCOMPARE(stack.layers.size(), 1U);
            QCOMPARE(stack.layers[0].name, QStringLiteral("Viking"));
            QVERIFY(!ids.contains(stack.layers[0].id));
            ids.insert(stack.layers[0].id);
        }
    document.undo();
    QVERIFY(sameProjects(document.committed(), start));
}

void TestCommands::aPresetFlattensWhatIsShown()
{
    Document document(patchProject());
    const LayerAddress length = firstLayer(document, MapKind::Length);
    sim::TiledRaster raster = document.project().layer(length.group, length.map, length.layer)->raster;
    raster.setTexel(70, 80, {65535, 32768, 0, 0});
    document.push(paintCommand(document, length, {{5, raster.tile(5)}}, QString()));
    document.push(addLayerCommand(document, length.group, length.map, QStringLiteral("Hidden")));
    const Preset preset = presetFrom(document.project(), QStringLiteral("P"));
    const auto shown = document.resolved(length.group, length.map);
    document.push(applyPresetCommand(document, preset));
    QVERIFY(*document.resolved(length.group, length.map) == *shown);
    QCOMPARE(static_cast<int>(document.project().groups[0].map(length.map).layers[0].raster.texel(0, 0)[1]), 65535);
}

void TestCommands::thePreviewOfAPresetIsItsCommit()
{
    Document document(patchProject());
    Project styled = patchProject();
    styled.groups.push_back(makeGroup(styled, QStringLiteral("Beard")));
    styled.groups[0].map(MapKind::Density).layers[0].raster.setUniform(3, {60000, 65535, 0, 0});
    const Preset preset = presetFrom(styled, QStringLiteral("P"));
    const Project first = document.committed();
    EditSession edit;
    document.show(edit, {.policy = EditPolicy::Drop}, {.aspect = Change::Aspect::GroupList},
                  [&](Project& project) { applyPreset(project, preset); });
    const Project previewed = document.project();
    QVERIFY(sameProjects(document.committed(), first));
    const Id group = previewed.groups[0].id;
    const auto shown = document.resolved(group, MapKind::Density);
    edit.commit();
    QVERIFY(!document.previewing());
    QVERIFY(sameProjects(document.project(), previewed));
    QCOMPARE(document.resolved(group, MapKind::Density), shown); // Nothing had to be resolved again.
    document.show(edit, {.policy = EditPolicy::Drop}, {.aspect = Change::Aspect::GroupList},
                  [](Project& project) { project.groups.clear(); });
    edit.drop();
    QVERIFY(sameProjects(document.project(), previewed));
    QVERIFY(*document.resolved(group, MapKind::Density) == *shown);
}

void TestCommands::windOnOrOffIsNoStepAndStaysWhateverIsUndone()
{
    Document document(patchProject());
    QSignalSpy changed(&document, &Document::changed);
    document.setWindOn(false);
    QCOMPARE(changed.count(), 1);
    QVERIFY(!document.modified());
    QVERIFY(!document.committed().wind.enabled);
    document.setWindOn(false);
    QCOMPARE(changed.count(), 1);
    QVERIFY(setWindCommand(document, {.enabled = true}) == nullptr); // Nothing else of it differs.
    document.push(setWindCommand(document, {.enabled = true, .velocity = {2.0F, 0.0F, 0.0F}}));
    QVERIFY(!document.committed().wind.enabled);
    document.push(setBackgroundCommand(document, 0xFF123456));
    document.setWindOn(true);
    document.undo();
    QVERIFY(document.committed().wind.enabled);
    QCOMPARE(document.committed().wind.velocity.x, 2.0F);
    document.setWindOn(false);
    document.redo();
    QVERIFY(!document.committed().wind.enabled);
    // What is shown over the content blows as well, and so does what becomes of it.
    EditSession edit;
    document.show(edit, {}, {.aspect = Change::Aspect::Environment},
                  [](Project& project) { project.light.intensity = 2.0F; });
    document.setWindOn(true);
    QVERIFY(document.previewing());
    QVERIFY(document.project().wind.enabled);
    edit.commit();
    QVERIFY(document.committed().wind.enabled);
}

void TestCommands::theDocumentKnowsWhetherItIsSaved()
{
    Document document(patchProject());
    QSignalSpy spy(&document, &Document::modifiedChanged);
    QVERIFY(!document.modified());
    document.push(setBackgroundCommand(document, 0xFF101010));
    QVERIFY(document.modified());
    document.markSaved();
    QVERIFY(!document.modified());
    document.undo();
    QVERIFY(document.modified());
    document.redo();
    QVERIFY(!document.modified());
    QCOMPARE(spy.count(), 4);
    document.replace(patchProject());
    QVERIFY(!document.modified());
    QVERIFY(!document.undoStack().canUndo());
}

void TestCommands::theHistoryForgetsItsOldestStepsWithinItsBudget()
{
    constexpr std::size_t kTileBytes = 64 * 64 * 2 * sizeof(std::uint16_t);
    Document document(patchProject());
    document.setUndoBudget(5 * kTileBytes);
    const LayerAddress gel = firstLayer(document, MapKind::Gel);
    std::vector<Project> states{document.committed()};
    for (std::uint16_t step = 1; step <= 20; ++step) {
        sim::TiledRaster raster = document.project().layer(gel.group, gel.map, gel.layer)->raster;
        raster.setTexel(step, 0, {step, 65535, 0, 0});
        document.push(paintCommand(document, gel, {{0, raster.tile(0)}}, QString()));
        states.push_back(document.committed());
        QVERIFY(document.canUndo());
    }
    int undone = 0;
    for (; document.canUndo(); ++undone) {
        QVERIFY(sameProjects(document.committed(), states[states.size() - 1 - static_cast<std::size_t>(undone)]));
        document.undo();
    }
    QCOMPARE(undone, 5);
    document.undo(); // At the floor: nothing happens.
    QVERIFY(sameProjects(document.committed(), states[15]));
    while (document.undoStack().canRedo())
        document.redo();
    QVERIFY(sameProjects(document.committed(), states.back()));
    document.setUndoBudget(0);
    QVERIFY(document.canUndo()); // The newest step stays.
    document.undo();
    QVERIFY(sameProjects(document.committed(), states[19]));
    QVERIFY(!document.canUndo());
}

void TestCommands::aPushCountsItsOwnCommandAlone()
{
    struct Counted : QUndoCommand, TileHolder
    {
        explicit Counted(int& times) : asked(times) {}
        [[nodiscard]] std::size_t keptBytes() const override
        {
            ++asked;
            return 1;
        }
        void release() override {}
        int& asked;
    };
    Document document(patchProject());
    int asked = 0;
    for (int step = 1; step <= 50; ++step) {
        document.push(std::make_unique<Counted>(asked));
        QCOMPARE(asked, step);
    }
}

void TestCommands::sharedTilesCostTheHistoryNothing()
{
    Project project = patchProject();
    sim::TiledRaster& raster = project.groups.front().map(MapKind::Gel).layers.front().raster;
    for (int x = 0; x < 256; ++x)
        for (int y = 0; y < 256; ++y)
            raster.setTexel(x, y, {static_cast<std::uint16_t>(x), 65535, 0, 0});
    Document document(project);
    document.setUndoBudget(1000);
    for (int i = 0; i < 10; ++i)
        document.push(renameGroupCommand(document, project.groups.front().id, QStringLiteral("%1").arg(i)));
    while (document.canUndo())
        document.undo();
    QVERIFY(sameProjects(document.committed(), project));
}

HAIRPAINT_TEST(TestCommands, None)
#include "test_commands.moc"
