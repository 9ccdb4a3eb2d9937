// Resolving of layers: the arithmetic, and that only what differs is done again.
#include "model/compositor.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>
#include <set>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

MapStack stackOf(MapKind kind, const std::vector<sim::Texel>& layers)
{
    MapStack stack{.kind = kind, .size = 256, .layers = {}};
    Id id = 1;
    for (const sim::Texel& texel : layers)
        stack.layers.push_back(
            {.id = id++, .name = {}, .raster = sim::TiledRaster(256, mapSpec(kind).layerChannels(), texel)});
    return stack;
}

/// Layers of noise, constant patches and untouched tiles.
MapStack randomStack(MapKind kind, int layers, std::mt19937& random)
{
    MapStack stack =
        stackOf(kind, std::vector<sim::Texel>(static_cast<std::size_t>(layers), mapSpec(kind).defaultValue));
    for (Layer& layer : stack.layers) {
        layer.visible = random() % 4 != 0;
        layer.opacity = static_cast<float>(random() % 5) / 4.0F;
        layer.blend = mapSpec(kind).blendModes[random() % mapSpec(kind).blendModes.size()];
        for (int index = 0; index < layer.raster.tileCount(); ++index) {
            const auto texel = [&] {
                sim::Texel value{};
                for (auto& channel : value)
                    channel = static_cast<std::uint16_t>(random());
                if (kind == MapKind::Braid)
                    value[0] %= 4;
                if (random() % 3 == 0)
                    value[static_cast<std::size_t>(mapSpec(kind).valueChannels)] = random() % 2 == 0 ? 0 : 65535;
                return value;
            };
            switch (random() % 3) {
            case 0:
                break;
            case 1:
                layer.raster.setUniform(index, texel());
                break;
            default: {
                const sim::TexelRect rect = layer.raster.tileRect(index);
                for (int y = rect.y0; y < rect.y1; ++y)
                    for (int x = rect.x0; x < rect.x1; ++x)
                        layer.raster.setTexel(x, y, texel());
            }
            }
        }
    }
    return stack;
}

} // namespace

class TestCompositor : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void productsAndMixesAreRoundedToTheNearest();
    void scalarsBlendAsTheTableSays_data();
    void scalarsBlendAsTheTableSays();
    void everyModeFollowsItsFormula_data();
    void everyModeFollowsItsFormula();
    void everyModeHasItsOwnNames();
    void aMapStartsFromARasterWhereItHasOne();
    void whereTheStartChangesOnlyThatIsResolvedAgain_data();
    void whereTheStartChangesOnlyThatIsResolvedAgain();
    void aStartIsAConstantAnotherMapOrTheHeads();
    void coloursBlendChannelByChannel();
    void anIndexReplacesFromHalfCoverageOn_data();
    void anIndexReplacesFromHalfCoverageOn();
    void hiddenLayersDoNotShow();
    void tilesGiveWhatTexelsGive_data();
    void tilesGiveWhatTexelsGive();
    void uniformLayersGiveUniformTiles();
    void onlyTilesThatDifferGetNewPointers();
    void updatingGivesWhatResolvingAnewGives();
    void aSnapshotNeverChanges();
};

void TestCompositor::productsAndMixesAreRoundedToTheNearest()
{
    std::mt19937 random(7);
    for (int i = 0; i < 200000; ++i) {
        const std::uint64_t a = random() % 65536;
        const std::uint64_t b = random() % 65536;
        const std::uint64_t share = i % 3 == 0 ? 65535 * (random() % 2) : random() % 65536;
        QCOMPARE(static_cast<std::uint64_t>(mul16(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b))),
                 (2 * a * b + 65535) / (2 * 65535));
        QCOMPARE(static_cast<std::uint64_t>(lerp16(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                                   static_cast<std::uint32_t>(share))),
                 (2 * (a * (65535 - share) + b * share) + 65535) / (2 * 65535));
    }
    QCOMPARE(static_cast<int>(mul16(65535, 65535)), 65535);
    QCOMPARE(static_cast<int>(lerp16(65535, 65535, 32768)), 65535);
}

void TestCompositor::scalarsBlendAsTheTableSays_data()
{
    QTest::addColumn<int>("below"); // A fully covering layer's value.
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("coverage");
    QTest::addColumn<float>("opacity");
    QTest::addColumn<bool>("multiplies");
    QTest::addColumn<int>("expected");
    QTest::newRow("full normal replaces") << 10000 << 50000 << 65535 << 1.0F << false << 50000;
    QTest::newRow("no coverage leaves") << 10000 << 50000 << 0 << 1.0F << false << 10000;
    QTest::newRow("no opacity leaves") << 10000 << 50000 << 65535 << 0.0F << false << 10000;
    QTest::newRow("half opacity mixes") << 0 << 65535 << 65535 << 0.5F << false << 32768;
    QTest::newRow("half coverage mixes") << 20000 << 40000 << 32768 << 1.0F << false << 30000;
    QTest::newRow("half of half") << 0 << 65535 << 32768 << 0.5F << false << 16384;
    QTest::newRow("multiply by one leaves") << 12345 << 65535 << 65535 << 1.0F << true << 12345;
    QTest::newRow("multiply by none clears") << 12345 << 0 << 65535 << 1.0F << true << 0;
    QTest::newRow("multiply halves") << 65535 << 32768 << 65535 << 1.0F << true << 32768;
    QTest::newRow("multiply by half coverage") << 40000 << 0 << 32768 << 1.0F << true << 20000;
}

void TestCompositor::scalarsBlendAsTheTableSays()
{
    QFETCH(int, below);
    QFETCH(int, value);
    QFETCH(int, coverage);
    QFETCH(float, opacity);
    QFETCH(bool, multiplies);
    QFETCH(int, expected);
    const auto u16 = [](int x) { return static_cast<std::uint16_t>(x); };
    MapStack stack = stackOf(MapKind::Length, {{u16(below), 65535, 0, 0}, {u16(value), u16(coverage), 0, 0}});
    stack.layers[1].opacity = opacity;
    stack.layers[1].blend = multiplies ? BlendMode::Multiply : BlendMode::Normal;
    QCOMPARE(static_cast<int>(resolveTexel(stack, 3, 5)[0]), expected);
    QCOMPARE(resolveStack(stack).texel(3, 5), resolveTexel(stack, 3, 5));
}

void TestCompositor::everyModeFollowsItsFormula_data()
{
    QTest::addColumn<BlendMode>("mode");
    QTest::addColumn<double>("below");
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("expected");
    const auto row = [](BlendMode mode, double below, double value, double expected) {
        QTest::addRow("%s, %g under %g", blendRule(mode).id, below, value) << mode << below << value << expected;
    };
    row(BlendMode::Normal, 0.3, 0.8, 0.8);
    row(BlendMode::Multiply, 0.3, 0.8, 0.24);
    row(BlendMode::Screen, 0.3, 0.8, 0.86);
    row(BlendMode::Darken, 0.3, 0.8, 0.3);
    row(BlendMode::Darken, 0.8, 0.3, 0.3);
    row(BlendMode::Lighten, 0.3, 0.8, 0.8);
    row(BlendMode::Lighten, 0.8, 0.3, 0.8);
    row(BlendMode::Add, 0.3, 0.4, 0.7);
    row(BlendMode::Add, 0.7, 0.8, 1.0);
    row(BlendMode::Subtract, 0.8, 0.3, 0.5);
    row(BlendMode::Subtract, 0.3, 0.8, 0.0);
    row(BlendMode::Difference, 0.8, 0.3, 0.5);
    row(BlendMode::Difference, 0.3, 0.8, 0.5);
    row(BlendMode::Overlay, 0.3, 0.8, 0.48);
    row(BlendMode::Overlay, 0.8, 0.3, 0.72);
    row(BlendMode::HardLight, 0.3, 0.8, 0.72);
    row(BlendMode::HardLight, 0.8, 0.3, 0.48);
    row(BlendMode::SoftLight, 0.3, 0.25, 0.195);
    row(BlendMode::SoftLight, 0.49, 0.75, 0.595);
    row(BlendMode::SoftLight, 0.2, 1.0, 0.448);
    row(BlendMode::SoftLight, 0.6, 0.5, 0.6);
}

void TestCompositor::everyModeFollowsItsFormula()
{
    QFETCH(BlendMode, mode);
    QFETCH(double, below);
    QFETCH(double, value);
    QFETCH(double, expected);
    const auto texel = [](double share) { return unit16(static_cast<float>(share)); };
    const double got = blendRule(mode).formula(texel(below), texel(value)) / 65535.0;
    QVERIFY2(std::abs(got - expected) < 3e-5, qPrintable(QString::number(got)));
    // Through a layer, for one channel and for three.
    MapStack scalars = stackOf(MapKind::Length, {{texel(below), 65535}, {texel(value), 65535}});
    scalars.layers[1].blend = mode;
    QCOMPARE(resolveTexel(scalars, 0, 0)[0], blendRule(mode).formula(texel(below), texel(value)));
    MapStack colours =
        stackOf(MapKind::Colour, {{texel(below), texel(value), 0, 65535}, {texel(value), texel(below), 65535, 65535}});
    colours.layers[1].blend = mode;
    QCOMPARE(resolveTexel(colours, 0, 0),
             (sim::Texel{blendRule(mode).formula(texel(below), texel(value)),
                         blendRule(mode).formula(texel(value), texel(below)), blendRule(mode).formula(0, 65535), 0}));
}

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

void TestCompositor::aMapStartsFromARasterWhereItHasOne()
{
    const auto start = halfNoise(256);
    MapStack stack = stackOf(MapKind::Length, {{0, 0, 0, 0}});
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

void TestCompositor::whereTheStartChangesOnlyThatIsResolvedAgain_data()
{
    QTest::addColumn<int>("startSize");
    QTest::newRow("the map's size") << 512;
    QTest::newRow("smaller") << 256;
    QTest::newRow("larger") << 1024;
}

void TestCompositor::whereTheStartChangesOnlyThatIsResolvedAgain()
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

void TestCompositor::aStartIsAConstantAnotherMapOrTheHeads()
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

void TestCompositor::everyModeHasItsOwnNames()
{
    std::set<QString> ids;
    std::set<QString> titles;
    for (const BlendRule& rule : blendRules()) {
        ids.insert(QString::fromLatin1(rule.id));
        titles.insert(rule.titleText());
    }
    QCOMPARE(ids.size(), kBlendModeCount);
    QCOMPARE(titles.size(), kBlendModeCount);
}

void TestCompositor::coloursBlendChannelByChannel()
{
    MapStack stack = stackOf(MapKind::Colour, {{60000, 40000, 20000, 65535}, {0, 65535, 32768, 65535}});
    stack.layers[1].blend = BlendMode::Multiply;
    QCOMPARE(resolveTexel(stack, 0, 0), (sim::Texel{0, 40000, 10000, 0}));
    stack.layers[1].blend = BlendMode::Normal;
    QCOMPARE(resolveTexel(stack, 0, 0), (sim::Texel{0, 65535, 32768, 0}));
}

void TestCompositor::anIndexReplacesFromHalfCoverageOn_data()
{
    QTest::addColumn<int>("coverage");
    QTest::addColumn<float>("opacity");
    QTest::addColumn<int>("expected");
    QTest::newRow("just less than half") << 32767 << 1.0F << 1;
    QTest::newRow("half") << 32768 << 1.0F << 2;
    QTest::newRow("all") << 65535 << 1.0F << 2;
    QTest::newRow("none") << 0 << 1.0F << 1;
    QTest::newRow("all at less than half opacity") << 65535 << 0.49F << 1;
    QTest::newRow("all at half opacity") << 65535 << 0.5F << 2;
}

void TestCompositor::anIndexReplacesFromHalfCoverageOn()
{
    QFETCH(int, coverage);
    QFETCH(float, opacity);
    QFETCH(int, expected);
    MapStack stack = stackOf(MapKind::Braid, {{1, 65535, 0, 0}, {2, static_cast<std::uint16_t>(coverage), 0, 0}});
    stack.layers[1].opacity = opacity;
    QCOMPARE(static_cast<int>(resolveTexel(stack, 0, 0)[0]), expected);
    stack.layers[1].raster.setTexel(0, 0, {3, 65535, 0, 0}); // The same through pixels.
    QCOMPARE(static_cast<int>(resolveStack(stack).texel(1, 0)[0]), expected);
}

void TestCompositor::hiddenLayersDoNotShow()
{
    MapStack stack = stackOf(MapKind::Density, {{30000, 65535, 0, 0}, {60000, 65535, 0, 0}});
    stack.layers[1].visible = false;
    QCOMPARE(static_cast<int>(resolveStack(stack).texel(9, 9)[0]), 30000);
    stack.layers[0].visible = false;
    QCOMPARE(static_cast<int>(resolveStack(stack).texel(9, 9)[0]), 0);
}

void TestCompositor::tilesGiveWhatTexelsGive_data()
{
    QTest::addColumn<int>("map");
    QTest::addColumn<int>("layers");
    for (const MapSpec& spec : mapSpecs())
        for (const int layers : {0, 1, 2, 4})
            QTest::addRow("%s, %d layers", spec.id, layers) << static_cast<int>(spec.kind) << layers;
}

void TestCompositor::tilesGiveWhatTexelsGive()
{
    QFETCH(int, map);
    QFETCH(int, layers);
    std::mt19937 random(static_cast<unsigned>(map * 10 + layers));
    const MapStack stack = randomStack(static_cast<MapKind>(map), layers, random);
    const sim::TiledRaster resolved = resolveStack(stack);
    for (int y = 0; y < 256; y += 3)
        for (int x = 0; x < 256; x += 5)
            QCOMPARE(resolved.texel(x, y), resolveTexel(stack, x, y));
}

void TestCompositor::uniformLayersGiveUniformTiles()
{
    MapStack stack = stackOf(MapKind::Colour, {{1, 2, 3, 65535}, {9, 9, 9, 20000}});
    stack.layers[1].raster.setTexel(70, 3, {50000, 9, 9, 65535});
    const sim::TiledRaster resolved = resolveStack(stack);
    for (int index = 0; index < resolved.tileCount(); ++index)
        QCOMPARE(resolved.tile(index)->isUniform(), index != 1);
    stack.layers[1].raster.setTexel(70, 3, {9, 9, 9, 20000}); // Pixels that are all equal.
    QVERIFY(resolveStack(stack).tile(1)->isUniform());
}

void TestCompositor::onlyTilesThatDifferGetNewPointers()
{
    MapStack stack = stackOf(MapKind::Length, {{0, 0, 0, 0}, {0, 0, 0, 0}});
    stack.layers[1].raster.setTexel(100, 100, {65535, 65535, 0, 0});
    ResolvedMap map(stack);
    const auto before = map.result();
    stack.layers[0].raster.setTexel(3, 200, {40000, 65535, 0, 0});
    QVERIFY(map.update(stack));
    const auto after = map.result();
    for (int index = 0; index < before->tileCount(); ++index)
        QCOMPARE(before->tile(index) != after->tile(index), index == before->tileIndexAt(3, 200));

    // Hiding what does not show anyway keeps every pointer.
    stack.layers[0].raster.setTexel(100, 100, {50000, 65535, 0, 0});
    QVERIFY(!map.update(stack));
    QCOMPARE(map.result(), after);
    stack.layers.push_back({.id = 9, .name = {}, .raster = sim::TiledRaster(256, 2)});
    QVERIFY(!map.update(stack));
    QCOMPARE(map.result(), after);
}

void TestCompositor::updatingGivesWhatResolvingAnewGives()
{
    std::mt19937 random(3);
    for (const MapSpec& spec : mapSpecs()) {
        MapStack stack = randomStack(spec.kind, 3, random);
        ResolvedMap map(stack);
        for (int step = 0; step < 6; ++step) {
            if (step % 2 == 0) {
                const int index = static_cast<int>(random() % 16);
                stack.layers[1].raster.setTile(index, randomStack(spec.kind, 1, random).layers[0].raster.tile(index));
                const std::vector<int> tiles{index};
                map.updateTiles(stack, stack.layers[1].id, tiles);
            } else {
                stack.layers[2].visible = !stack.layers[2].visible;
                std::swap(stack.layers[0], stack.layers[1]);
                map.update(stack);
            }
            QVERIFY(*map.result() == resolveStack(stack));
        }
    }
}

void TestCompositor::aSnapshotNeverChanges()
{
    MapStack stack = stackOf(MapKind::Gel, {{0, 0, 0, 0}});
    ResolvedMap map(stack);
    const auto snapshot = map.result();
    stack.layers[0].raster.setTexel(0, 0, {65535, 65535, 0, 0});
    QVERIFY(map.update(stack));
    QCOMPARE(static_cast<int>(snapshot->texel(0, 0)[0]), 0);
    QCOMPARE(static_cast<int>(map.result()->texel(0, 0)[0]), 65535);
}

HAIRPAINT_TEST(TestCompositor, None)
#include "test_compositor.moc"
