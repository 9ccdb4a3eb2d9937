// Resolving of layers: the arithmetic, and that only what differs is done again.
#include "model/maps/compositor.h"
#include "sim/groom/direction_texel.h"
#include "tests/model/uniform_layers.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <random>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

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
                // Nothing, all, and what is nearly all but lets something through.
                constexpr std::array<std::uint16_t, 4> kCoverages{0, 65535, 65534, 65001};
                if (random() % 2 == 0)
                    value[static_cast<std::size_t>(mapSpec(kind).valueChannels)] = kCoverages[random() % 4];
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
    void coloursBlendChannelByChannel();
    void vectorsAreMixedByCoverageAndOpacity();
    void anIndexReplacesFromHalfCoverageOn_data();
    void anIndexReplacesFromHalfCoverageOn();
    void hiddenLayersDoNotShow();
    void tilesGiveWhatTexelsGive_data();
    void tilesGiveWhatTexelsGive();
    void uniformLayersGiveUniformTiles();
    void whatCoversNearlyAllLetsTheRestThrough();
    void onlyTilesThatDifferGetNewPointers();
    void updatingGivesWhatResolvingAnewGives();
    void tilesOfALayerThatWasNotThereKeepTheStart();
    void aSnapshotNeverChanges();
};

void TestCompositor::productsAndMixesAreRoundedToTheNearest()
{
    std::mt19937 random(7);
    for (int i = 0; i < 200000; ++i) {
        const std::uint64_t a = random() % 65536;
        const std::uint64_t b = random() % 65536;
        const std::uint64_t fraction = i % 3 == 0 ? 65535 * (random() % 2) : random() % 65536;
        QCOMPARE(static_cast<std::uint64_t>(mul16(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b))),
                 (2 * a * b + 65535) / (2 * 65535));
        QCOMPARE(static_cast<std::uint64_t>(lerp16(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                                   static_cast<std::uint32_t>(fraction))),
                 (2 * (a * (65535 - fraction) + b * fraction) + 65535) / (2 * 65535));
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

void TestCompositor::coloursBlendChannelByChannel()
{
    MapStack stack = stackOf(MapKind::Colour, {{60000, 40000, 20000, 65535}, {0, 65535, 32768, 65535}});
    stack.layers[1].blend = BlendMode::Multiply;
    QCOMPARE(resolveTexel(stack, 0, 0), (sim::Texel{0, 40000, 10000, 0}));
    stack.layers[1].blend = BlendMode::Normal;
    QCOMPARE(resolveTexel(stack, 0, 0), (sim::Texel{0, 65535, 32768, 0}));
}

void TestCompositor::vectorsAreMixedByCoverageAndOpacity()
{
    const auto layer = [](glm::vec2 direction, std::uint16_t coverage) {
        sim::Texel texel = sim::texelOfDirection(direction);
        texel[2] = coverage;
        return texel;
    };
    MapStack stack = stackOf(MapKind::Direction, {layer({1.0F, 0.0F}, 65535), layer({0.0F, 0.8F}, 32768)});
    const auto resolved = [&stack] { return sim::directionOf(resolveTexel(stack, 3, 4)); };
    // The mean, as long as both are in the mean: hair turns, and does not stand up between.
    QVERIFY(glm::distance(resolved(), 0.9F * glm::normalize(glm::vec2(0.5F, 0.4F))) < 1e-4F);
    stack.layers[1].opacity = 0.5F;
    QVERIFY(glm::distance(resolved(), 0.95F * glm::normalize(glm::vec2(0.75F, 0.2F))) < 1e-4F);
    stack.layers[0].visible = false;
    stack.layers[1].visible = false;
    QVERIFY(resolved() == glm::vec2(0.0F));
    // Where nothing is painted the head's own stream shows, of whatever size it is.
    const auto natural = std::make_shared<const sim::TiledRaster>(512, 2, sim::texelOfDirection({0.0F, -0.5F}));
    QVERIFY(glm::distance(sim::directionOf(resolveStack(stack, natural).texel(9, 9)), glm::vec2(0.0F, -0.5F)) < 1e-4F);
    QCOMPARE(static_cast<int>(resolveStack(stack, natural).size()), stack.size);
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

void TestCompositor::whatCoversNearlyAllLetsTheRestThrough()
{
    for (const std::uint16_t coverage : std::array<std::uint16_t, 4>{65535, 65534, 65001, 64000}) {
        const MapStack stack = stackOf(MapKind::Length, {{65535, 65535}, {0, coverage}});
        const std::uint16_t seen = lerp16(65535, 0, coverage);
        QCOMPARE(resolveStack(stack).texel(9, 9)[0], seen);
        QCOMPARE(seen == 0, coverage == 65535);
    }
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

void TestCompositor::tilesOfALayerThatWasNotThereKeepTheStart()
{
    MapStack stack = stackOf(MapKind::Length, {{0, 0, 0, 0}});
    const auto start = std::make_shared<const sim::TiledRaster>(256, 1, sim::Texel{4321, 0, 0, 0});
    ResolvedMap map(stack, start);
    stack.layers.push_back({.id = 9, .name = {}, .raster = sim::TiledRaster(256, 2)});
    stack.layers.back().raster.setTexel(3, 3, {50000, 65535, 0, 0});
    const std::vector<int> tiles{0};
    QVERIFY(map.updateTiles(stack, 9, tiles));
    QVERIFY(*map.result() == resolveStack(stack, start));
    QCOMPARE(static_cast<int>(map.result()->texel(200, 200)[0]), 4321);
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
