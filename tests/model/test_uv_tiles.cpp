// Layouts of several uv tiles: their numbers through the head's file, and maps as an image a tile and back.
#include "model/exporting/map_images.h"
#include "model/files/glb.h"
#include "model/files/glb_writing.h"
#include "model/files/map_source.h"
#include "model/files/part_selection.h"
#include "model/files/tile_names.h"
#include "model/heads/layout_packing.h"
#include "model/heads/part_choice.h"
#include "tests/model/sample_project.h"
#include "tests/support/character.h"
#include "tests/support/glb_json.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::model;
using namespace hairpaint::test;

namespace {

UvTiles tilesUpTo(int count)
{
    std::vector<int> numbers;
    numbers.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        numbers.push_back(kFirstUdim + 10 * (i / 3) + i % 3);
    return UvTiles(std::move(numbers));
}

/// Balls that lie in these tiles, all grown with hair.
RiggedMesh ballsIn(const std::vector<glm::ivec2>& tiles)
{
    RiggedMesh mesh;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        addBall(mesh, {0.3F * static_cast<float>(i), 0.0F, 0.0F}, 0.1F, 8);
        closePart(mesh, "Ball_" + std::to_string(i), "").tile = tiles[i];
    }
    mesh.skeleton = {};
    return mesh;
}

/// No two neighbours are alike.
sim::TiledRaster busyMap(const MapSpec& spec, int side)
{
    sim::TiledRaster map(side, spec.valueChannels, sim::Texel{});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            map.setTexel(x, y, {static_cast<std::uint16_t>((x * 7919 + y * 104729) & 0xFFFF)});
    return map;
}

} // namespace

class TestUvTiles : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void cellsTellTheTilesThatTheyCameFrom()
    {
        const RiggedMesh made = arranged(ballsIn({{1, 1}, {0, 0}, {1, 0}}));
        QCOMPARE(made.tiles, UvTiles({1001, 1002, 1012}));
        QCOMPARE(made.tiles.across(), 2);
        QCOMPARE(tilesFromGlb(glbFromMesh(made)), made.tiles);
        const RiggedMesh alone = arranged(ballsIn({{2, 0}}));
        QCOMPARE(tilesFromGlb(glbFromMesh(alone)), UvTiles({1003}));
        const RiggedMesh over = arranged(ballsIn({{1, 0}, {1, 0}}));
        QCOMPARE(over.tiles.shared(), std::optional(1002));
        QVERIFY(!made.tiles.shared());
    }

    void partsThatShareATileLieSideBySideWhereTheyOverlap_data()
    {
        QTest::addColumn<float>("left"); // The smaller one's, of a twentieth of the side; the larger one begins at 1/2.
        QTest::addColumn<bool>("smallIsFirst");
        QTest::addColumn<int>("cells");
        QTest::newRow("beside it") << 0.2F << false << 1;
        QTest::newRow("beside it, first") << 0.2F << true << 1;
        QTest::newRow("over it") << 0.7F << false << 2;
        QTest::newRow("under it") << 0.7F << true << 2; // Of the larger one it is a hundredth.
    }
    void partsThatShareATileLieSideBySideWhereTheyOverlap()
    {
        QFETCH(float, left);
        QFETCH(bool, smallIsFirst);
        QFETCH(int, cells);
        RiggedMesh mesh;
        for (const bool isSmall : {smallIsFirst, !smallIsFirst}) {
            const std::size_t first = mesh.uvs.size();
            addBall(mesh, {isSmall ? 0.3F : 0.0F, 0.0F, 0.0F}, 0.1F, 8);
            for (glm::vec2& uv : std::span(mesh.uvs).subspan(first))
                uv = isSmall ? glm::vec2(left, 0.4F) + 0.05F * uv : glm::vec2(0.5F, 0.0F) + glm::vec2(0.5F, 1.0F) * uv;
            closePart(mesh, isSmall ? "Small" : "Large", "");
        }
        mesh.skeleton = {};
        const RiggedMesh made = arranged(mesh);
        QCOMPARE(made.tiles, UvTiles(std::vector<int>(static_cast<std::size_t>(cells), 1001)));
        QCOMPARE(overlapOf(made).fraction, 0.0);
        const Checked<ChosenHead> head = headOfParts(mesh, false);
        QVERIFY(head);
        QCOMPARE(head->remarks.size(), cells == 2 ? 1 : 0);
        if (cells == 2)
            QVERIFY2(head->remarks.front().contains(QStringLiteral("1001")), qPrintable(head->remarks.front()));
    }

    void whatIsNoListOfTilesIsOneMap_data()
    {
        QTest::addColumn<QJsonValue>("told");
        QTest::newRow("no list") << QJsonValue(7);
        QTest::newRow("too low") << QJsonValue(QJsonArray{1000});
        QTest::newRow("too high") << QJsonValue(QJsonArray{1001, 1101});
        QTest::newRow("a word") << QJsonValue(QJsonArray{QStringLiteral("1001")});
        QTest::newRow("empty") << QJsonValue(QJsonArray{});
    }
    void whatIsNoListOfTilesIsOneMap()
    {
        QFETCH(QJsonValue, told);
        const QByteArray glb = withJson(glbFromMesh(arranged(ballsIn({{2, 0}}))), [&told](QJsonObject& root) {
            QJsonArray meshes = root[QLatin1String("meshes")].toArray();
            QJsonObject mesh = meshes[0].toObject();
            mesh[QLatin1String("extras")] = QJsonObject{{QStringLiteral("udim"), told}};
            meshes[0] = mesh;
            root[QLatin1String("meshes")] = meshes;
        });
        QVERIFY(tilesFromGlb(glb).isOneMap());
        QVERIFY(tilesFromGlb(QByteArray("no glb")).isOneMap());
    }

    void aMapComesBackFromItsTilesTexelForTexel_data()
    {
        QTest::addColumn<int>("tiles");
        QTest::addColumn<int>("side");
        for (const int tiles : {1, 3, 4, 7, 14})
            for (const int side : {256, 1024})
                QTest::addRow("%d tiles, %d", tiles, side) << tiles << side;
    }
    void aMapComesBackFromItsTilesTexelForTexel()
    {
        QFETCH(int, tiles);
        QFETCH(int, side);
        const MapSpec& spec = mapSpec(MapKind::Length);
        const sim::TiledRaster map = busyMap(spec, side);
        MapSource source{.images = {}, .cells = {}, .tiles = tilesUpTo(tiles), .leftOut = {}};
        const ForeignImage whole = imageFromMap(map, spec, true);
        for (std::size_t cell = 0; cell < static_cast<std::size_t>(tiles); ++cell) {
            source.images.push_back(imageOfCell(whole, source.tiles, cell));
            source.cells.push_back(cell);
        }
        QVERIFY(source.images.front().width >= side / source.tiles.across());
        const Result<ImageLayer> read = layerFromSource(source, spec, true, side);
        QVERIFY(read);
        const int across = source.tiles.across();
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto along = [&](int at) { return (2 * at + 1) * across / (2 * side); };
                const int cell = (across - 1 - along(y)) * across + along(x);
                const sim::Texel texel = read->raster.texel(x, y);
                if (cell >= tiles)
                    QCOMPARE(texel[1], std::uint16_t{0});
                else if (texel[0] != map.texel(x, y)[0] || texel[1] != 65535)
                    QFAIL(qPrintable(QStringLiteral("texel %1, %2").arg(x).arg(y)));
            }
    }

    void aTilesImageLiesWhereItsLayoutWas()
    {
        // An image of tile 1002, the second of four cells; its upper quarter is painted.
        MapSource source{.images = {}, .cells = {1}, .tiles = UvTiles({1001, 1002, 1011}), .leftOut = {}};
        ForeignImage image{.width = 256, .height = 256, .channels = 1, .pixels = {}};
        image.pixels.resize(std::size_t{256} * 256);
        std::fill_n(image.pixels.begin(), 256 * 64, std::uint16_t{65535});
        source.images.push_back(image);
        const MapSpec& spec = mapSpec(MapKind::Density);
        const Result<ImageLayer> read = layerFromSource(source, spec, true, 0);
        QVERIFY(read);
        QCOMPARE(read->raster.size(), 512);
        QCOMPARE(read->raster.texel(256, 256)[0], std::uint16_t{65535}); // u = 1/2, v just below 1/2.
        QCOMPARE(read->raster.texel(511, 319)[0], std::uint16_t{65535});
        QCOMPARE(read->raster.texel(511, 320)[0], std::uint16_t{0});
        QCOMPARE(read->raster.texel(255, 256)[1], std::uint16_t{0}); // No image of that tile was there.
        QCOMPARE(read->raster.texel(511, 255)[1], std::uint16_t{0});
    }

    void filesOfTilesAreOnePattern()
    {
        const UvTiles tiles({1001, 1002});
        const QStringList paths{QStringLiteral("/a/head_density.1001.png"), QStringLiteral("/a/head_density.1002.png"),
                                QStringLiteral("/a/head_density.1014.png"), QStringLiteral("/a/length.1014.png"),
                                QStringLiteral("/a/curl.0001.exr"),         QStringLiteral("/a/width_1002_v2.tif")};
        QCOMPARE(tilePatternsOf(paths, tiles),
                 (QStringList{QStringLiteral("/a/head_density.<UDIM>.png"), QStringLiteral("/a/length.1014.png"),
                              QStringLiteral("/a/curl.0001.exr"), QStringLiteral("/a/width_<UDIM>_v2.tif")}));
        QCOMPARE(tilePatternsOf(paths, {}), paths); // A head of one map.
        QCOMPARE(mapTitleOf(QStringLiteral("/a/head_density.<UDIM>.png")), QStringLiteral("head_density"));
        QCOMPARE(mapTitleOf(QStringLiteral("/a/width_<UDIM>_v2.tif")), QStringLiteral("width_v2"));
    }

    void filesOfAPatternAreFoundByNumber()
    {
        const QTemporaryDir folder;
        for (const char* name : {"d.1002.png", "d.1001.png", "d.0999.png", "d.1101.png", "d.10011.png", "e.1001.png"}) {
            QFile file(folder.filePath(QLatin1StringView(name)));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        const Checked<std::vector<TileFile>> files = tileFilesOf(folder.filePath(QStringLiteral("d.<UDIM>.png")));
        QVERIFY(files);
        QCOMPARE(files->size(), std::size_t{2});
        QCOMPARE(files->front().number, 1001);
        QCOMPARE(files->back().path, folder.filePath(QStringLiteral("d.1002.png")));
        const auto none = tileFilesOf(folder.filePath(QStringLiteral("f.<UDIM>.png")));
        QVERIFY(!none && none.error().text.contains(QStringLiteral("f.1001.png")));
    }

    void imagesOfTilesAreNamedAfterThemAndSharedTilesAreRefused()
    {
        const std::vector<WantedMap> maps = {
            {.group = QStringLiteral("Scalp"), .kind = MapKind::Density, .resolved = {}}};
        QCOMPARE(mapImageNames(maps, {.tiles = UvTiles({1001, 1012})}),
                 (QStringList{QStringLiteral("Scalp-density.1001.png"), QStringLiteral("Scalp-density.1012.png")}));
        const QTemporaryDir folder;
        const Result<void> shared = writeMapImages(maps, folder.path(), {.tiles = UvTiles({1001, 1002, 1001})});
        QVERIFY(!shared);
        QVERIFY(isOneSentenceNaming(shared.error().message, folder.path()));
        QVERIFY(shared.error().message.contains(QStringLiteral("1001")));
    }
};

HAIRPAINT_TEST(TestUvTiles, Core)
#include "test_uv_tiles.moc"
