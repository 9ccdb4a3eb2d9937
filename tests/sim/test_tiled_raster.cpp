// Rasters share tiles until they are written, and are sampled as the design says.
#include "sim/base/deterministic.h"
#include "sim/base/tiled_raster.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace hairpaint::sim;

namespace {

constexpr int kTile = TiledRaster::kTileSize;

float rasterRandom(std::uint64_t counter)
{
    return unitFloat(hash64(31, counter));
}

TiledRaster randomRaster(int size, int channels)
{
    TiledRaster raster(size, channels);
    for (int tile = 0; tile < raster.tileCount(); ++tile) {
        if (tile % 3 == 0)
            continue; // Some tiles stay uniform.
        std::uint64_t counter = static_cast<std::uint64_t>(tile) << 20U;
        for (std::uint16_t& value : raster.writableTile(tile))
            value = static_cast<std::uint16_t>(hash64(9, counter++));
    }
    return raster;
}

} // namespace

class TestTiledRaster : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void copiesShareTilesUntilOneIsWritten();
    void writingASharedTileLeavesTheOtherAlone();
    void uniformTilesHoldNoPixels();
    void channelsThatARasterLacksAreZero();
    void equalityIsByTexels();
    void texelCentresGiveTheTexel_data();
    void texelCentresGiveTheTexel();
    void samplesBetweenCentresAreBilinear();
    void texelsOutsideAreClamped_data();
    void texelsOutsideAreClamped();
    void equalTexelsGiveExactlyTheirValueHoweverStored();
    void whereFourTilesMeetAllFourAreRead();
    void theScalarIsTheFirstChannel();
    void nearestPicksTheTexelThatHoldsThePoint();
    void theFootprintHoldsEveryTexelRead();
    void oneValueEverywhereIsFound();
    void aTileIsTheSameExpandedAndFolded_data();
    void aTileIsTheSameExpandedAndFolded();
    void oneTexelThatDiffersKeepsATilesPixels();
};

void TestTiledRaster::copiesShareTilesUntilOneIsWritten()
{
    TiledRaster a(256, 1);
    a.setTexel(70, 10, {500});
    const TiledRaster before = a;
    for (int tile = 0; tile < a.tileCount(); ++tile)
        QVERIFY(a.tile(tile) == before.tile(tile));
    a.setTexel(200, 100, {7});
    for (int tile = 0; tile < a.tileCount(); ++tile)
        QCOMPARE(a.tile(tile) == before.tile(tile), tile != a.tileIndexAt(200, 100));
}

void TestTiledRaster::writingASharedTileLeavesTheOtherAlone()
{
    TiledRaster a(256, 3, {1, 2, 3});
    a.setTexel(5, 5, {10, 20, 30});
    const TiledRaster before = a;
    a.setTexel(5, 6, {11, 21, 31});
    QCOMPARE(before.texel(5, 6), (Texel{1, 2, 3, 0}));
    QCOMPARE(a.texel(5, 6), (Texel{11, 21, 31, 0}));
    QCOMPARE(a.texel(5, 5), before.texel(5, 5));
}

void TestTiledRaster::uniformTilesHoldNoPixels()
{
    TiledRaster raster(256, 2, {4, 5});
    QCOMPARE(raster.byteCount(), std::size_t{0});
    raster.setTexel(0, 0, {9, 9});
    QCOMPARE(raster.byteCount(), static_cast<std::size_t>(kTile) * kTile * 2 * 2);
    raster.compact(0);
    QVERIFY(!raster.tile(0)->isUniform());
    raster.setTexel(0, 0, {4, 5});
    raster.compact(0);
    QVERIFY(raster.tile(0)->isUniform());
    QCOMPARE(raster.texel(63, 63), (Texel{4, 5, 0, 0}));
    QCOMPARE(raster.byteCount(), std::size_t{0});
}

void TestTiledRaster::channelsThatARasterLacksAreZero()
{
    const TiledRaster raster(64, 2, {1, 2, 3, 4});
    QCOMPARE(raster.texel(3, 3), (Texel{1, 2, 0, 0}));
    QCOMPARE(raster.sampleBilinear({0.5F, 0.5F}).z, 0.0F);
}

void TestTiledRaster::equalityIsByTexels()
{
    TiledRaster a(128, 1, {3});
    TiledRaster b(128, 1, {3});
    QVERIFY(a == b);
    b.setTexel(100, 100, {3}); // Same value, stored as pixels.
    QVERIFY(a == b);
    b.setTexel(100, 100, {4});
    QVERIFY(!(a == b));
    QVERIFY(!(a == TiledRaster(256, 1, {3})));
    QVERIFY(!(a == TiledRaster(128, 2, {3})));
}

void TestTiledRaster::texelCentresGiveTheTexel_data()
{
    QTest::addColumn<int>("x");
    QTest::addColumn<int>("y");
    QTest::newRow("first") << 0 << 0;
    QTest::newRow("last") << 255 << 255;
    QTest::newRow("left of a tile's edge") << 63 << 70;
    QTest::newRow("right of a tile's edge") << 64 << 70;
    QTest::newRow("above a tile's edge") << 100 << 127;
    QTest::newRow("below a tile's edge") << 100 << 128;
}

void TestTiledRaster::texelCentresGiveTheTexel()
{
    QFETCH(int, x);
    QFETCH(int, y);
    const TiledRaster raster = randomRaster(256, 4);
    const glm::vec2 uv((static_cast<float>(x) + 0.5F) / 256.0F, 1.0F - (static_cast<float>(y) + 0.5F) / 256.0F);
    const Texel expected = raster.texel(x, y);
    const glm::vec4 sampled = raster.sampleBilinear(uv);
    for (int channel = 0; channel < 4; ++channel)
        QCOMPARE(sampled[channel], static_cast<float>(expected[static_cast<std::size_t>(channel)]) / 65535.0F);
    QCOMPARE(raster.sampleNearest(uv), expected);
}

void TestTiledRaster::samplesBetweenCentresAreBilinear()
{
    const TiledRaster raster = randomRaster(256, 4);
    const auto value = [&](int x, int y, int channel) {
        return static_cast<double>(
                   raster.texel(std::clamp(x, 0, 255), std::clamp(y, 0, 255))[static_cast<std::size_t>(channel)]) /
               65535.0;
    };
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const glm::vec2 uv(rasterRandom(i * 2), rasterRandom(i * 2 + 1));
        const double x = static_cast<double>(uv.x) * 256.0 - 0.5;
        const double y = (1.0 - static_cast<double>(uv.y)) * 256.0 - 0.5;
        const int x0 = static_cast<int>(std::floor(x));
        const int y0 = static_cast<int>(std::floor(y));
        for (int channel = 0; channel < 4; ++channel) {
            const double upper = std::lerp(value(x0, y0, channel), value(x0 + 1, y0, channel), x - x0);
            const double lower = std::lerp(value(x0, y0 + 1, channel), value(x0 + 1, y0 + 1, channel), x - x0);
            const double expected = std::lerp(upper, lower, y - y0);
            QVERIFY(std::abs(static_cast<double>(raster.sampleBilinear(uv)[channel]) - expected) < 3e-5);
        }
    }
}

void TestTiledRaster::texelsOutsideAreClamped_data()
{
    QTest::addColumn<float>("u");
    QTest::addColumn<float>("v");
    QTest::addColumn<int>("x");
    QTest::addColumn<int>("y");
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    QTest::newRow("upper left") << -3.0F << 2.0F << 0 << 0;
    QTest::newRow("lower right") << 1.5F << -0.1F << 255 << 255;
    QTest::newRow("corner itself") << 1.0F << 0.0F << 255 << 255;
    QTest::newRow("infinite") << kInfinity << kInfinity << 255 << 0;
    QTest::newRow("not a number") << std::nanf("") << std::nanf("") << 0 << 255;
}

void TestTiledRaster::texelsOutsideAreClamped()
{
    QFETCH(float, u);
    QFETCH(float, v);
    QFETCH(int, x);
    QFETCH(int, y);
    const TiledRaster raster = randomRaster(256, 1);
    QCOMPARE(raster.sampleNearest({u, v}), raster.texel(x, y));
    QCOMPARE(raster.sampleScalar({u, v}), static_cast<float>(raster.texel(x, y)[0]) / 65535.0F);
}

void TestTiledRaster::equalTexelsGiveExactlyTheirValueHoweverStored()
{
    for (const std::uint16_t value : {std::uint16_t{1}, std::uint16_t{22222}, std::uint16_t{65535}}) {
        const TiledRaster uniform(256, 1, {value});
        TiledRaster pixels = uniform;
        for (int tile = 0; tile < pixels.tileCount(); tile += 2)
            (void)pixels.writableTile(tile);
        for (std::uint64_t i = 0; i < 500; ++i) {
            const glm::vec2 uv(rasterRandom(i * 2), rasterRandom(i * 2 + 1));
            QCOMPARE(uniform.sampleScalar(uv), static_cast<float>(value) / 65535.0F);
            QCOMPARE(pixels.sampleScalar(uv), uniform.sampleScalar(uv));
            QCOMPARE(pixels.sampleBilinear(uv).x, uniform.sampleScalar(uv));
        }
    }
}

void TestTiledRaster::whereFourTilesMeetAllFourAreRead()
{
    // One tile stands twice, as where two parts were never painted.
    const auto black = std::make_shared<RasterTile>();
    const auto white = std::make_shared<RasterTile>();
    white->uniform[0] = 65535;
    TiledRaster raster(2 * TiledRaster::kTileSize, 1);
    for (const int tile : {0, 3})
        raster.setTile(tile, black);
    for (const int tile : {1, 2})
        raster.setTile(tile, white);
    QCOMPARE(raster.sampleScalar({0.5F, 0.5F}), 0.5F);
    QCOMPARE(raster.sampleBilinear({0.5F, 0.5F}).x, 0.5F);
}

void TestTiledRaster::theScalarIsTheFirstChannel()
{
    for (const int channels : {1, 3}) {
        const TiledRaster raster = randomRaster(256, channels);
        for (std::uint64_t i = 0; i < 2000; ++i) {
            const glm::vec2 uv(rasterRandom(i * 2) * 1.1F - 0.05F, rasterRandom(i * 2 + 1) * 1.1F - 0.05F);
            QVERIFY(raster.sampleScalar(uv) == raster.sampleBilinear(uv).x);
        }
    }
}

void TestTiledRaster::nearestPicksTheTexelThatHoldsThePoint()
{
    const TiledRaster raster = randomRaster(256, 2);
    for (std::uint64_t i = 0; i < 500; ++i) {
        const int x = static_cast<int>(rasterRandom(i * 4) * 256.0F);
        const int y = static_cast<int>(rasterRandom(i * 4 + 1) * 256.0F);
        const glm::vec2 inside(0.01F + 0.98F * rasterRandom(i * 4 + 2), 0.01F + 0.98F * rasterRandom(i * 4 + 3));
        const glm::vec2 uv((static_cast<float>(x) + inside.x) / 256.0F,
                           1.0F - (static_cast<float>(y) + inside.y) / 256.0F);
        QCOMPARE(raster.sampleNearest(uv), raster.texel(x, y));
    }
}

void TestTiledRaster::theFootprintHoldsEveryTexelRead()
{
    for (std::uint64_t i = 0; i < 300; ++i) {
        const glm::vec2 uv(rasterRandom(i * 2) * 1.02F - 0.01F, rasterRandom(i * 2 + 1) * 1.02F - 0.01F);
        const glm::ivec2 first = TiledRaster::footprint(uv, 64);
        // A raster that is bright only in the four texels is read as bright.
        TiledRaster raster(64, 1);
        for (int y = first.y; y <= std::min(first.y + 1, 63); ++y)
            for (int x = first.x; x <= std::min(first.x + 1, 63); ++x)
                raster.setTexel(x, y, {65535});
        QCOMPARE(raster.sampleScalar(uv), 1.0F);
        QCOMPARE(raster.sampleNearest(uv)[0], std::uint16_t{65535});
    }
}

void TestTiledRaster::oneValueEverywhereIsFound()
{
    TiledRaster raster(256, 1, {6});
    QVERIFY(raster.uniformValue() == std::optional(Texel{6}));
    raster.setUniform(3, {6});
    QVERIFY(raster.uniformValue() == std::optional(Texel{6}));
    raster.setUniform(3, {7});
    QVERIFY(!raster.uniformValue());
    raster.setUniform(3, {6});
    raster.setTexel(0, 0, {8});
    QVERIFY(!raster.uniformValue());
}

void TestTiledRaster::aTileIsTheSameExpandedAndFolded_data()
{
    QTest::addColumn<int>("channels");
    for (int channels = 1; channels <= 4; ++channels)
        QTest::addRow("%d", channels) << channels;
}

void TestTiledRaster::aTileIsTheSameExpandedAndFolded()
{
    QFETCH(int, channels);
    Texel value{};
    for (int i = 0; i < channels; ++i)
        value[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(1000 + i);
    const RasterTile uniform{.uniform = value, .pixels = {}};
    const RasterTile large{.uniform = {}, .pixels = expanded(uniform, channels)};
    QCOMPARE(large.pixels.size(), kTileTexels * static_cast<std::size_t>(channels));
    for (std::size_t i = 0; i < large.pixels.size(); ++i)
        QCOMPARE(static_cast<int>(large.pixels[i]), 1000 + static_cast<int>(i) % channels);
    QCOMPARE(commonTexel(large.pixels), std::optional(value));
    QVERIFY(sameTexels(uniform, large) && sameTexels(large, uniform) && sameTexels(large, large));
    const RasterTile back = folded(large);
    QVERIFY(back.isUniform() && back.uniform == value);
    QVERIFY(expanded(large, channels) == large.pixels);
}

void TestTiledRaster::oneTexelThatDiffersKeepsATilesPixels()
{
    const RasterTile uniform{.uniform = {7, 8, 0, 0}, .pixels = {}};
    RasterTile tile{.uniform = {}, .pixels = expanded(uniform, 2)};
    for (const std::size_t at : {std::size_t{0}, kTileTexels, 2 * kTileTexels - 1}) {
        RasterTile other = tile;
        ++other.pixels[at];
        QVERIFY(!commonTexel(other.pixels));
        QVERIFY(!sameTexels(other, uniform) && !sameTexels(uniform, other) && !sameTexels(other, tile));
        QVERIFY(folded(other).pixels == other.pixels);
    }
    const RasterTile another{.uniform = {7, 9, 0, 0}, .pixels = {}};
    QVERIFY(!sameTexels(uniform, another) && !sameTexels(another, tile));
}

HAIRPAINT_TEST(TestTiledRaster, None)
#include "test_tiled_raster.moc"
