// What a map shows where nothing is painted.
#include "model/maps/compositor.h"
#include "model/styles/preset.h"
#include "sim/groom/direction_texel.h"
#include "tests/model/fixtures.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// Left half 10000, right half noise: a map's start that is a raster.
std::shared_ptr<sim::TiledRaster> halfNoise(int size)
{
    std::mt19937 random(5);
    auto raster = std::make_shared<sim::TiledRaster>(size, 1, sim::Texel{10000});
    for (int y = 0; y < size; ++y)
        for (int x = size / 2; x < size; ++x)
            raster->setTexel(x, y, {static_cast<std::uint16_t>(random())});
    return raster;
}

} // namespace

class TestMapStart : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aMapStartsFromARasterWhereItHasOne();
    void whereTheStartChangesOnlyThatIsResolvedAgain_data();
    void whereTheStartChangesOnlyThatIsResolvedAgain();
    void aStartIsAConstantAnotherMapOrTheHeads();
    void unpaintedHairFollowsTheHeadsNaturalStream();
};

void TestMapStart::aMapStartsFromARasterWhereItHasOne()
{
    const auto start = halfNoise(256);
    MapStack stack{.kind = MapKind::Length, .size = 256, .layers = {}};
    stack.layers.push_back({.id = 1, .name = {}, .raster = sim::TiledRaster(256, 2)});
    ResolvedMap map(stack, start);
    QVERIFY(map.result() == start); // Nothing is painted: the start itself.

    const int tile = stack.layers[0].raster.tileIndexAt(200, 100);
    stack.layers[0].raster.setTexel(200, 100, {60000, 65535});
    stack.layers[0].raster.setTexel(201, 100, {60000, 32768});
    QVERIFY(map.updateTiles(stack, 1, std::vector<int>{tile}));
    QCOMPARE(map.result()->texel(200, 100)[0], std::uint16_t{60000});
    QCOMPARE(map.result()->texel(201, 100)[0], lerp16(start->texel(201, 100)[0], 60000, 32768));
    QCOMPARE(map.result()->texel(202, 100), start->texel(202, 100));
    for (int other = 0; other < start->tileCount(); ++other)
        QCOMPARE(map.result()->tile(other) == start->tile(other), other != tile);
    QCOMPARE(resolveStack(stack, start), *map.result());
    QCOMPARE(resolveTexel(stack, 201, 100, start), map.result()->texel(201, 100));

    stack.layers[0].blend = BlendMode::Multiply;
    QVERIFY(map.update(stack, start));
    QCOMPARE(map.result()->texel(200, 100)[0], mul16(start->texel(200, 100)[0], 60000));

    stack.layers[0].raster.setUniform(tile, {});
    QVERIFY(map.update(stack, start));
    QVERIFY(map.result() == start); // Erased: the start again.
}

void TestMapStart::whereTheStartChangesOnlyThatIsResolvedAgain_data()
{
    QTest::addColumn<int>("startSize");
    QTest::newRow("the map's size") << 512;
    QTest::newRow("smaller") << 256;
    QTest::newRow("larger") << 1024;
}

void TestMapStart::whereTheStartChangesOnlyThatIsResolvedAgain()
{
    QFETCH(int, startSize);
    std::mt19937 random(7);
    MapStack stack{.kind = MapKind::Length, .size = 512, .layers = {}};
    stack.layers.push_back({.id = 1, .name = {}, .raster = sim::TiledRaster(512, 2)});
    stack.layers[0].raster.setTexel(300, 300, {40000, 30000});
    auto start = halfNoise(startSize);
    ResolvedMap map(stack, start);
    for (int edit = 0; edit < 40; ++edit) {
        auto next = std::make_shared<sim::TiledRaster>(*start);
        const auto at = [&] { return static_cast<int>(random() % static_cast<unsigned>(startSize)); };
        const int x = at();
        const int y = at();
        next->setTexel(x, y, {static_cast<std::uint16_t>(random())});
        const sim::MapRaster before = map.result();
        (void)map.update(stack, next);
        QCOMPARE(resolveStack(stack, next), *map.result());
        int changed = 0;
        for (int tile = 0; tile < map.result()->tileCount(); ++tile)
            changed += map.result()->tile(tile) != before->tile(tile) ? 1 : 0;
        QVERIFY(changed <= 4);
        start = next;
    }
}

void TestMapStart::aStartIsAConstantAnotherMapOrTheHeads()
{
    const auto raster = halfNoise(256);
    const auto resolved = [&](MapKind kind) { return kind == MapKind::Length ? raster : sim::MapRaster(); };
    MapSpec spec = mapSpec(MapKind::Curl);
    const Head head;
    QVERIFY(startOf(spec, &head, resolved) == nullptr);
    spec.follows = MapKind::Length;
    QVERIFY(startOf(spec, &head, resolved) == raster);
    spec.follows.reset();
    spec.ofHead = [](const Head& of) -> sim::MapRaster {
        return std::make_shared<const sim::TiledRaster>(of.builtIn ? 256 : 512, 1);
    };
    QCOMPARE(startOf(spec, &head, resolved)->size(), 256);
    QVERIFY(startOf(spec, nullptr, resolved) == nullptr);
}

void TestMapStart::unpaintedHairFollowsTheHeadsNaturalStream()
{
    Project project = test::patchProject(1024);
    Head head = *project.head;
    head.naturalDirection = std::make_shared<const sim::TiledRaster>(512, 2, sim::texelOfDirection({0.0F, -0.5F}));
    project.head = std::make_shared<const Head>(head);
    sim::TiledRaster& layer = project.groups.front().map(MapKind::Direction).layers.front().raster;
    sim::Texel combed = sim::texelOfDirection({0.8F, 0.0F});
    combed[2] = 65535;
    layer.setTexel(100, 200, combed);

    Document document(project);
    const LayerAddress at = test::firstLayer(document, MapKind::Direction);
    const auto shown = document.resolved(at.group, at.map);
    QCOMPARE(shown->size(), 1024);
    QVERIFY(glm::distance(sim::directionOf(shown->texel(101, 200)), glm::vec2(0.0F, -0.5F)) < 1e-4F);
    QCOMPARE(shown->texel(100, 200)[0], combed[0]);

    // A style holds what was painted; the rest is the natural stream of whichever head it comes to.
    const Preset style = presetFrom(document.project(), QStringLiteral("Style"));
    const sim::TiledRaster& kept = style.groups.front().map(MapKind::Direction).layers.front().raster;
    QCOMPARE(kept.texel(100, 200), combed);
    QCOMPARE(kept.texel(101, 200)[2], std::uint16_t{0});
}

HAIRPAINT_TEST(TestMapStart, Core)
#include "test_map_start.moc"
