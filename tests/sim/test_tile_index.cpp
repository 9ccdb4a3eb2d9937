// Samples that may read texels that differ are found, and few others.
#include "sim/base/deterministic.h"
#include "sim/groom/tile_index.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <vector>

using namespace hairpaint::sim;

namespace {

constexpr int kRasterSize = 512;
constexpr int kTileSide = TiledRaster::kTileSize;
constexpr std::uint16_t kPainted = 100;

std::vector<glm::vec2> randomUvs()
{
    std::vector<glm::vec2> uvs(20'000);
    for (std::size_t i = 0; i < uvs.size(); ++i)
        uvs[i] = {unitFloat(hash64(5, 2 * i)), unitFloat(hash64(5, 2 * i + 1))};
    // Corners, and what lies outside.
    uvs.insert(uvs.end(), {{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}, {1.0F, 1.0F}, {-2.0F, 0.5F}, {0.5F, 3.0F}});
    return uvs;
}

void fillRect(TiledRaster& raster, const TexelRect& rect, const Texel& value)
{
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x)
            raster.setTexel(x, y, value);
}

} // namespace

class TestTileIndex : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void samplesThatReadWhatDiffersAreFoundAndFewOthers_data()
    {
        QTest::addColumn<int>("x0");
        QTest::addColumn<int>("y0");
        QTest::addColumn<int>("x1");
        QTest::addColumn<int>("y1");
        QTest::addColumn<int>("channels");
        QTest::newRow("inside a tile") << 70 << 80 << 90 << 100 << 1;
        QTest::newRow("one texel, the last channel") << 75 << 85 << 76 << 86 << 3;
        QTest::newRow("the first texel of a tile") << kTileSide << kTileSide << kTileSide + 1 << kTileSide + 1 << 1;
        QTest::newRow("the last texel of a tile")
            << 2 * kTileSide - 1 << kTileSide - 1 << 2 * kTileSide << kTileSide << 2;
        QTest::newRow("over four tiles") << 100 << 100 << 150 << 160 << 2;
        QTest::newRow("a whole tile") << kTileSide << kTileSide << 2 * kTileSide << 2 * kTileSide << 1;
        QTest::newRow("the raster's first texel") << 0 << 0 << 1 << 1 << 1;
        QTest::newRow("the raster's last texel")
            << kRasterSize - 1 << kRasterSize - 1 << kRasterSize << kRasterSize << 1;
    }
    void samplesThatReadWhatDiffersAreFoundAndFewOthers()
    {
        QFETCH(int, x0);
        QFETCH(int, y0);
        QFETCH(int, x1);
        QFETCH(int, y1);
        QFETCH(int, channels);
        const std::vector<glm::vec2> uvs = randomUvs();
        const TileIndex index(uvs, kRasterSize);
        const TiledRaster uniform(kRasterSize, channels, {kPainted, kPainted, kPainted});
        TiledRaster expanded = uniform;
        for (int tile = 0; tile < expanded.tileCount(); tile += 2)
            (void)expanded.writableTile(tile);
        for (const TiledRaster& before : {uniform, expanded}) {
            TiledRaster after = before;
            Texel value{kPainted, kPainted, kPainted};
            value.at(static_cast<std::size_t>(channels - 1)) = 60000;
            fillRect(after, {x0, y0, x1, y1}, value);
            const auto footprints = footprintsThatDiffer(before, after);
            QVERIFY(footprints.has_value());
            const std::vector<std::uint32_t> slots = index.slotsIn(*footprints);
            std::vector<bool> isFound(uvs.size());
            for (const std::uint32_t slot : slots) {
                QVERIFY(!isFound[slot]);
                isFound[slot] = true;
            }
            for (std::size_t i = 0; i < uvs.size(); ++i) {
                const glm::ivec2 texel = TiledRaster::footprint(uvs[i], kRasterSize);
                QCOMPARE(isFound[i], texel.x >= x0 - 1 && texel.x < x1 && texel.y >= y0 - 1 && texel.y < y1);
                if (before.sampleBilinear(uvs[i]) != after.sampleBilinear(uvs[i]) ||
                    before.sampleNearest(uvs[i]) != after.sampleNearest(uvs[i]))
                    QVERIFY(isFound[i]);
            }
        }
    }

    void otherTilesWithTheSameTexelsDoNotDiffer()
    {
        const TiledRaster before(kRasterSize, 2, {kPainted, kPainted});
        TiledRaster expanded = before;
        (void)expanded.writableTile(9);
        const TiledRaster other(kRasterSize, 2, {kPainted, kPainted});
        for (const TiledRaster& after : {before, expanded, other}) {
            const auto footprints = footprintsThatDiffer(before, after);
            QVERIFY(footprints && footprints->empty());
        }
    }

    void whereMostDiffersOrShapesDoAllIsToBeLookedAt()
    {
        const TiledRaster before(kRasterSize, 2, {kPainted, kPainted});
        QVERIFY(!footprintsThatDiffer(before, TiledRaster(kRasterSize, 2)));
        QVERIFY(!footprintsThatDiffer(before, TiledRaster(kRasterSize, 1, {kPainted})));
        QVERIFY(!footprintsThatDiffer(before, TiledRaster(2 * kRasterSize, 2, {kPainted, kPainted})));
    }
};

HAIRPAINT_TEST(TestTileIndex, None)
#include "test_tile_index.moc"
