// Maps as image files, and the sheet of the uv layout.
#include "model/document/document.h"
#include "model/exporting/map_images.h"
#include "model/exporting/uv_sheet.h"
#include "model/files/image_map.h"
#include "model/maps/texel_ops.h"
#include "tests/model/archive_maker.h"
#include "tests/model/fixtures.h"
#include "tests/model/sample_project.h"
#include "tests/support/test_heads.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

std::shared_ptr<sim::TiledRaster> gradient(const MapSpec& spec)
{
    constexpr int kSize = 256;
    auto raster = std::make_shared<sim::TiledRaster>(kSize, spec.valueChannels, sim::Texel{});
    const auto greatest = static_cast<int>(spec.palette.empty() ? 65535 : spec.palette.size() - 1);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const auto value =
                static_cast<std::uint16_t>(spec.palette.empty() ? x * greatest / 255 : x % (greatest + 1));
            raster->setTexel(x, y, {value, static_cast<std::uint16_t>(y * 257), 30'000, 0});
        }
    return raster;
}

} // namespace

class TestMapImages : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void greysReadBackAsTheSameValues_data()
    {
        QTest::addColumn<int>("kind");
        for (const MapSpec& spec : mapSpecs())
            if (spec.texel == TexelKind::Scalar || spec.texel == TexelKind::Index)
                QTest::newRow(spec.id) << static_cast<int>(spec.kind);
    }
    void greysReadBackAsTheSameValues()
    {
        QFETCH(int, kind);
        const MapSpec& spec = mapSpec(static_cast<MapKind>(kind));
        const auto raster = gradient(spec);
        const ForeignImage image = imageFromMap(*raster, spec, true);
        QCOMPARE(image.channels, 1);
        const Result<sim::TiledRaster> read = layerFromImage(image, spec, true, raster->size());
        QVERIFY(read);
        for (int x = 0; x < raster->size(); ++x)
            QCOMPARE(read->texel(x, 7)[0], raster->texel(x, 7)[0]);
    }

    void coloursStayColours()
    {
        const MapSpec& spec = mapSpec(MapKind::Colour);
        QCOMPARE(imageFromMap(*gradient(spec), spec, true).channels, 3);
    }

    void aLayerReadsBackWithItsCoverage_data()
    {
        QTest::addColumn<int>("kind");
        for (const MapSpec& spec : mapSpecs())
            QTest::newRow(spec.id) << static_cast<int>(spec.kind);
    }
    void aLayerReadsBackWithItsCoverage()
    {
        QFETCH(int, kind);
        const MapSpec& spec = mapSpec(static_cast<MapKind>(kind));
        sim::TiledRaster layer(256, spec.layerChannels(), spec.defaultValue);
        const auto channel = static_cast<std::size_t>(spec.valueChannels);
        for (int y = 64; y < 128; ++y)
            for (int x = 64; x < 200; ++x) {
                sim::Texel texel = texelOf(spec, spec.firstPaint);
                texel[channel] = static_cast<std::uint16_t>(x * 300);
                layer.setTexel(x, y, texel);
            }
        const Result<sim::TiledRaster> read = layerFromImage(imageFromLayer(layer, spec), spec, false, 256);
        QVERIFY(read);
        for (int x = 64; x < 200; ++x) {
            QCOMPARE(read->texel(x, 100)[channel], layer.texel(x, 100)[channel]);
            for (std::size_t i = 0; i < channel; ++i)
                QVERIFY(std::abs(int{read->texel(x, 100)[i]} - int{layer.texel(x, 100)[i]}) <= 2);
        }
        QCOMPARE(read->texel(10, 10)[channel], std::uint16_t{0});
    }

    void namesAreThoseThatEverySystemTakes()
    {
        const std::vector<WantedMap> maps = {
            {.group = QStringLiteral("a/b:c"), .kind = MapKind::Density, .resolved = {}},
            {.group = QStringLiteral("a_b_c"), .kind = MapKind::Density, .resolved = {}},
            {.group = QStringLiteral(" .. "), .kind = MapKind::Curl, .resolved = {}}};
        QCOMPARE(mapImageNames(maps, {.format = findMapImageFormat(QStringLiteral("TIF"))}),
                 (QStringList{QStringLiteral("a_b_c-density.tif"), QStringLiteral("a_b_c-density-2.tif"),
                              QStringLiteral("__-curl.tif")}));
        QVERIFY(findMapImageFormat(QStringLiteral("gif")) == nullptr);
    }

    void aSheetHasALineForEveryEdge()
    {
        const QTemporaryDir folder;
        const sim::HeadMesh mesh = test::makeBallHead();
        const QString svg = folder.filePath(QStringLiteral("sheet.svg"));
        const QString pdf = folder.filePath(QStringLiteral("sheet.pdf"));
        QVERIFY(writeUvSheet(mesh, svg) && writeUvSheet(mesh, pdf));
        const QByteArray drawn = test::readBytes(svg);
        // Euler: a disc of V vertices and F triangles has V + F - 1 edges; the frame has four more.
        const auto lines = static_cast<std::size_t>(drawn.count('M'));
        QVERIFY2(lines >= mesh.triangles.size() * 3 / 2, qPrintable(QString::number(lines)));
        QVERIFY(lines <= mesh.triangles.size() * 3);
        const QByteArray bytes = test::readBytes(pdf);
        QVERIFY(bytes.startsWith("%PDF-1.4") && bytes.endsWith("%%EOF\n"));
        // Each object lies where the table says.
        const qsizetype table = bytes.indexOf("xref\n");
        QCOMPARE(bytes.mid(bytes.indexOf("startxref\n") + 10).split('\n').front().toLongLong(), qint64{table});
        const QList<QByteArray> rows = bytes.mid(table).split('\n');
        for (int object = 1; object <= 4; ++object)
            QVERIFY(
                bytes.mid(rows[2 + object].left(10).toLongLong()).startsWith(QByteArray::number(object) + " 0 obj"));
    }

    void aSheetThatCantBeWrittenIsOneSentence()
    {
        const QTemporaryDir folder;
        for (const char* ending : {"pdf", "svg"}) {
            const QString nowhere = folder.filePath(QStringLiteral("none/sheet.") + QLatin1StringView(ending));
            const Result<void> result = writeUvSheet(test::makeBallHead(), nowhere);
            QVERIFY(!result);
            QVERIFY(test::isOneSentenceNaming(result.error().message, nowhere));
        }
    }
};

HAIRPAINT_TEST(TestMapImages, Core)
#include "test_map_images.moc"
