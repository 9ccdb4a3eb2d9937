// PNG images read as QImage reads them, whatever filters their rows have; broken ones are refused.
#include "model/files/png_codec.h"
#include "model/files/png_reader.h"
#include "model/maps/new_image.h"
#include "tests/model/archive_maker.h"
#include "tests/support/test_program.h"

#include <QBuffer>
#include <QImage>
#include <QTest>

#include <random>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

/// Rows of random bytes behind filters 0 to 4 in turn: any bytes are good pixels of some image.
QByteArray filteredPng(int width, int height, int depth, int colourType, int pixelBytes)
{
    std::mt19937 random(static_cast<unsigned>(width * 31 + colourType));
    QByteArray rows;
    for (int y = 0; y < height; ++y) {
        rows.append(static_cast<char>(y % 5));
        for (int i = 0; i < width * pixelBytes; ++i)
            rows.append(static_cast<char>(random() & 0xFFU));
    }
    const QByteArray packed = qCompress(rows, 6).sliced(4);
    // In two pieces, as large images come.
    return test::pngSignature() +
           test::pngHeader(static_cast<quint32>(width), static_cast<quint32>(height), depth, colourType) +
           test::pngChunk("IDAT", packed.first(100)) + test::pngChunk("IDAT", packed.sliced(100)) +
           test::pngChunk("IEND", {});
}

} // namespace

class TestPngReader : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void anImageThatMemoryCannotHoldIsAnExceptionNotNull()
    {
        QVERIFY_THROWS_EXCEPTION(std::bad_alloc, static_cast<void>(newImage(1 << 30, 1 << 30, QImage::Format_RGBA64)));
        QCOMPARE(newImage(3, 2, QImage::Format_Grayscale8).size(), QSize(3, 2));
    }

    /// Bands of our own and chunks of others look alike until one of them refers to an earlier one.
    void aStreamThatStopsBeingBandsIsReadOn()
    {
        constexpr int kSide = 256;
        sim::TiledRaster raster(kSide, 2);
        std::mt19937 random(5);
        for (int i = 0; i < raster.tileCount(); ++i)
            for (std::uint16_t& value : raster.writableTile(i))
                value = static_cast<std::uint16_t>(random() & 0xFFU);
        const QByteArray png = encodeLayer(raster, nullptr).bytes;
        const std::optional<PngParts> parts = readPngParts(png);
        QVERIFY(parts);
        // The same stream, its second band and what follows cut into chunks at other offsets.
        QByteArrayView chunks = parts->pixelChunks;
        const QByteArray first = takePixelChunk(chunks)->toByteArray();
        QByteArray rest;
        while (const std::optional<QByteArrayView> content = takePixelChunk(chunks))
            rest.append(*content);
        QVERIFY(rest.size() > 3000);
        const QByteArray cut = test::pngSignature() + test::pngHeader(kSide, kSide, 16, 6) +
                               test::pngChunk("IDAT", first) + test::pngChunk("IDAT", rest.first(1000)) +
                               test::pngChunk("IDAT", rest.sliced(1000)) + test::pngChunk("IEND", {});
        const MapSpec& spec = mapSpec(MapKind::Length);
        const Checked<DecodedLayer> ours = decodeLayer(png, spec, kSide);
        const Checked<DecodedLayer> others = decodeLayer(cut, spec, kSide);
        QVERIFY(ours && others);
        QVERIFY(ours->raster == raster && others->raster == raster);
    }

    void picturesAreReadAsQtReadsThem_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<bool>("alpha");
        QTest::newRow("RGB") << 40 << 30 << false;
        QTest::newRow("RGBA") << 40 << 30 << true;
        QTest::newRow("one column") << 1 << 200 << true;
        QTest::newRow("one row") << 300 << 1 << false;
    }
    void picturesAreReadAsQtReadsThem()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(bool, alpha);
        const QByteArray png = filteredPng(width, height, 8, alpha ? 6 : 2, alpha ? 4 : 3);
        const QImage ours = decodePicture(png, 1024);
        const QImage qts = QImage::fromData(png, "png");
        QCOMPARE(ours.size(), QSize(width, height));
        QCOMPARE(ours.convertToFormat(QImage::Format_ARGB32), qts.convertToFormat(QImage::Format_ARGB32));
    }

    void greyAloneIsALayerThatCoversAll()
    {
        QImage image(256, 256, QImage::Format_Grayscale16);
        const auto valueAt = [](int x, int y) { return static_cast<quint16>(x * 251 + y * 17); };
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                reinterpret_cast<quint16*>(image.scanLine(y))[x] = valueAt(x, y);
        QBuffer png;
        QVERIFY(png.open(QIODevice::WriteOnly) && image.save(&png, "PNG"));
        QVERIFY(readPngParts(png.data())->colourType == 0);
        const Checked<DecodedLayer> layer = decodeLayer(png.data(), mapSpec(MapKind::Length), 256);
        QVERIFY(layer && !layer->ours); // It is written as RGBA.
        QCOMPARE(salvageLayer(png.data(), mapSpec(MapKind::Length), 256).rows, 256);
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) {
                const sim::Texel texel = layer->raster.texel(x, y);
                QVERIFY(texel[0] == valueAt(x, y) && texel[1] == 65535);
            }
        QVERIFY(!decodeLayer(png.data(), mapSpec(MapKind::Colour), 256));
    }

    void layersAreReadAsQtReadsThem()
    {
        const QByteArray png = filteredPng(256, 256, 16, 6, 8);
        const Checked<DecodedLayer> layer = decodeLayer(png, mapSpec(MapKind::Colour), 256);
        const QImage qts = QImage::fromData(png, "png");
        QVERIFY(layer && qts.format() == QImage::Format_RGBA64);
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) {
                const QRgba64 wanted = reinterpret_cast<const QRgba64*>(qts.constScanLine(y))[x];
                const sim::Texel texel = layer->raster.texel(x, y);
                QCOMPARE(qRgba64(texel[0], texel[1], texel[2], texel[3]), wanted);
            }
    }

    void whatIsNoPictureIsNone_data()
    {
        QTest::addColumn<QByteArray>("png");
        const QByteArray good = filteredPng(40, 30, 8, 6, 4);
        const QByteArray pixels = qCompress(QByteArray(30 * 161, '\0'), 6).sliced(4);
        const auto made = [](const QByteArray& header, const QByteArray& packed) {
            return test::pngSignature() + header + test::pngChunk("IDAT", packed) + test::pngChunk("IEND", {});
        };
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("a text") << QByteArray("a text");
        QTest::newRow("too large") << filteredPng(70, 10, 8, 6, 4);
        QTest::newRow("16 bits") << filteredPng(40, 30, 16, 6, 8);
        QTest::newRow("grey") << made(test::pngHeader(40, 30, 8, 0), pixels);
        QTest::newRow("a palette") << made(test::pngHeader(40, 30, 8, 3), pixels);
        QTest::newRow("interlaced") << made(test::pngHeader(40, 30, 8, 6, 1), pixels);
        QTest::newRow("no filter 5") << made(test::pngHeader(40, 30, 8, 6),
                                             qCompress(QByteArray(30 * 161, '\5'), 6).sliced(4));
        QTest::newRow("a row too few") << made(test::pngHeader(40, 31, 8, 6), pixels);
        QTest::newRow("a row too many") << made(test::pngHeader(40, 29, 8, 6), pixels);
        QTest::newRow("the stream's checksum cut off") << made(test::pngHeader(40, 30, 8, 6), pixels.chopped(1));
        for (const qsizetype length : {8, 20, 33, 60, 200})
            QTest::addRow("cut at %d", static_cast<int>(length)) << good.first(length);
    }
    void whatIsNoPictureIsNone()
    {
        QFETCH(QByteArray, png);
        QVERIFY(decodePicture(png, 64).isNull());
    }

    void aFlippedBitAnywhereIsNoticed()
    {
        const QByteArray good = filteredPng(40, 30, 8, 6, 4);
        QVERIFY(!decodePicture(good, 64).isNull());
        for (qsizetype at = 0; at < good.size(); ++at) {
            QByteArray png = good;
            png[at] = static_cast<char>(png[at] ^ (1 << (at % 8)));
            QVERIFY2(decodePicture(png, 64).isNull(), qPrintable(QString::number(at)));
        }
    }
};

HAIRPAINT_TEST(TestPngReader, Core)
#include "test_png_reader.moc"
