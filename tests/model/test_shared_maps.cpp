// What copies of a project share, what a step of the history costs, and maps resolved by several threads.
#include "model/document/layer_commands.h"
#include "model/document/paint_command.h"
#include "model/document/undo_budget.h"
#include "model/maps/compositor.h"
#include "sim/base/parallel.h"
#include "tests/model/fixtures.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

/// How many maps of the first groups of two projects are one and the same.
int sharedMaps(const Project& a, const Project& b)
{
    int count = 0;
    for (std::size_t map = 0; map < a.groups.front().maps.size(); ++map)
        count += a.groups.front().maps[map].sharesWith(b.groups.front().maps[map]) ? 1 : 0;
    return count;
}

/// Says how often it was asked what it keeps.
class CountingCommand : public QUndoCommand, public TileHolder
{
public:
    CountingCommand(int& asked, std::size_t bytes) : m_asked(asked), m_bytes(bytes) {}
    [[nodiscard]] std::size_t keptBytes() const override
    {
        ++m_asked;
        return m_bytes;
    }
    void release() override { m_bytes = 0; }

private:
    int& m_asked;
    std::size_t m_bytes;
};

} // namespace

class TestSharedMaps : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void copiesOfAProjectShareTheirMapsUntilOneIsPainted();
    void lookingForALayerThatIsNotThereSharesOn();
    void aStepIsCountedOnceHoweverLongTheHistoryIs();
    void undoneStepsThatAPushDropsAreNoLongerCounted();
    void aLayersPropertiesCostTheHistoryNothing();
    void severalThreadsResolveTheSameMap();
};

void TestSharedMaps::copiesOfAProjectShareTheirMapsUntilOneIsPainted()
{
    Document document(patchProject());
    const Project before = document.committed();
    QCOMPARE(sharedMaps(before, document.committed()), kMapKindCount);
    const LayerAddress gel = firstLayer(document, MapKind::Gel);
    sim::TiledRaster raster = document.committed().layer(gel.group, gel.map, gel.layer)->raster;
    raster.setTexel(0, 0, {1, 65535, 0, 0});
    document.push(paintCommand(document, gel, {{0, raster.tile(0)}}, QString()));
    QCOMPARE(sharedMaps(before, document.committed()), kMapKindCount - 1);
    QVERIFY(!before.groups.front().maps[static_cast<std::size_t>(MapKind::Gel)].sharesWith(
        document.committed().groups.front().maps[static_cast<std::size_t>(MapKind::Gel)]));
    QCOMPARE(static_cast<int>(before.layer(gel.group, gel.map, gel.layer)->raster.texel(0, 0)[1]), 0);
}

void TestSharedMaps::lookingForALayerThatIsNotThereSharesOn()
{
    const Project project = patchProject();
    Project copy = project;
    QVERIFY(copy.layer(copy.groups.front().id, MapKind::Gel, 12345) == nullptr);
    QCOMPARE(sharedMaps(project, copy), kMapKindCount);
    QVERIFY(copy.layer(copy.groups.front().id, MapKind::Gel,
                       std::as_const(copy).groups.front().map(MapKind::Gel).layers.front().id) != nullptr);
    QCOMPARE(sharedMaps(project, copy), kMapKindCount - 1);
}

void TestSharedMaps::aStepIsCountedOnceHoweverLongTheHistoryIs()
{
    Document document(patchProject());
    int asked = 0;
    for (int i = 0; i < 2000; ++i)
        document.push(std::make_unique<CountingCommand>(asked, 1000));
    QCOMPARE(asked, 2000);
    QVERIFY(document.canUndo());
    // Within a budget of ten of them ten are left.
    document.setUndoBudget(10'000);
    int undone = 0;
    for (; document.canUndo(); ++undone)
        document.undo();
    QCOMPARE(undone, 10);
    QCOMPARE(asked, 2000);
}

void TestSharedMaps::undoneStepsThatAPushDropsAreNoLongerCounted()
{
    Document document(patchProject());
    document.setUndoBudget(10'000);
    int asked = 0;
    const auto push = [&] { document.push(std::make_unique<CountingCommand>(asked, 1000)); };
    for (int round = 0; round < 5; ++round) {
        for (int i = 0; i < 8; ++i)
            push();
        if (round < 4)
            for (int i = 0; i < 8; ++i)
                document.undo();
    }
    int undone = 0;
    for (; document.canUndo(); ++undone)
        document.undo();
    QCOMPARE(undone, 8);
}

void TestSharedMaps::aLayersPropertiesCostTheHistoryNothing()
{
    Project project = patchProject();
    sim::TiledRaster& raster = project.groups.front().map(MapKind::Gel).layers.front().raster;
    for (int index = 0; index < raster.tileCount(); ++index)
        std::ranges::fill(raster.writableTile(index), std::uint16_t{77});
    Document document(project);
    document.setUndoBudget(1);
    const LayerAddress gel = firstLayer(document, MapKind::Gel);
    constexpr int kSteps = 20;
    for (int i = 1; i <= kSteps; ++i) {
        LayerProperties properties = propertiesOf(*document.committed().layer(gel.group, gel.map, gel.layer));
        properties.opacity = 1.0F - 0.01F * static_cast<float>(i);
        document.push(setLayerPropertiesCommand(document, gel, properties, QStringLiteral("Opacity")));
    }
    int undone = 0;
    for (; document.canUndo(); ++undone)
        document.undo();
    QCOMPARE(undone, kSteps);
}

void TestSharedMaps::severalThreadsResolveTheSameMap()
{
    Project project = patchProject();
    MapStack& stack = project.groups.front().map(MapKind::Length);
    stack.size = 1024;
    stack.layers = {makeLayer(project, mapSpec(MapKind::Length), 1024, QString()),
                    makeLayer(project, mapSpec(MapKind::Length), 1024, QString())};
    for (Layer& layer : stack.layers)
        for (int i = 0; i < 1024; ++i)
            layer.raster.setTexel(i, (i * 7 + layer.id) % 1024,
                                  {static_cast<std::uint16_t>(i * 60), static_cast<std::uint16_t>(65535 - i), 0, 0});
    stack.layers.back().opacity = 0.4F;
    sim::setThreadCount(1);
    const sim::TiledRaster one = resolveStack(stack);
    sim::setThreadCount(4);
    const sim::TiledRaster four = resolveStack(stack);
    sim::setThreadCount(0);
    QVERIFY(one == four);
    for (int i = 0; i < 1024; ++i)
        QVERIFY(four.texel(i, i) == resolveTexel(stack, i, i));
}

HAIRPAINT_TEST(TestSharedMaps, Gui)
#include "test_shared_maps.moc"
