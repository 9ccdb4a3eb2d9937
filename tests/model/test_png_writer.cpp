// Layers become PNG images that any reader reads, whatever they hold: noise has codes of its own, the rest zlib's.
#include "model/files/pixel_huffman.h"
#include "model/files/png_codec.h"
#include "model/files/png_writer.h"
#include "model/files/zip_records.h"
#include "sim/base/deterministic.h"
#include "sim/base/parallel.h"
#include "tests/support/test_program.h"

#include <QImage>
#include <QTest>
#include <QtEndian>

#include <array>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

constexpr int kSize = 256;

enum class Content : std::uint8_t
{
    Nothing,
    Noise,
    NoisyValues, ///< Wholly covered.
    Waves,
    NoiseBelowWaves,
    NoiseInOneTile
};

std::uint16_t noiseAt(int x, int y, int channel)
{
    const int number = (y * kSize + x) * 4 + channel;
    return static_cast<std::uint16_t>(sim::hash64(3, static_cast<std::uint64_t>(number)));
}

std::uint16_t valueAt(Content content, int x, int y, int channel, bool isCoverage)
{
    const auto wave = static_cast<std::uint16_t>((x * x + y * 37 + channel * 900) % 4001 * 16);
    switch (content) {
    case Content::Nothing:
        return 0;
    case Content::Noise:
        return noiseAt(x, y, channel);
    case Content::NoisyValues:
        return isCoverage ? std::uint16_t{65535} : noiseAt(x, y, channel);
    case Content::Waves:
        return wave;
    case Content::NoiseBelowWaves:
        return y > 100 ? noiseAt(x, y, channel) : wave;
    case Content::NoiseInOneTile:
        return x / 64 == 2 && y / 64 == 1 ? noiseAt(x, y, channel) : std::uint16_t{7};
    }
    return 0;
}

sim::TiledRaster rasterOf(Content content, int channels)
{
    sim::TiledRaster raster(kSize, channels);
    if (content == Content::Nothing)
        return raster;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            sim::Texel texel{};
            for (int i = 0; i < channels; ++i)
                texel[static_cast<std::size_t>(i)] = valueAt(content, x, y, i, i == channels - 1);
            raster.setTexel(x, y, texel);
        }
    return raster;
}

} // namespace

class TestPngWriter : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyLayerIsReadAsItWas_data()
    {
        QTest::addColumn<Content>("content");
        QTest::addColumn<MapKind>("kind");
        using enum sim::MapSlot;
        const std::array contents = {std::pair("nothing", Content::Nothing),
                                     std::pair("noise", Content::Noise),
                                     std::pair("covered noise", Content::NoisyValues),
                                     std::pair("waves", Content::Waves),
                                     std::pair("noise below waves", Content::NoiseBelowWaves),
                                     std::pair("noise in one tile", Content::NoiseInOneTile)};
        for (const auto& [name, content] : contents)
            for (const MapKind kind : {Length, Direction, Colour})
                QTest::addRow("%s, %s", name, mapSpec(kind).id) << content << kind;
    }
    void everyLayerIsReadAsItWas()
    {
        QFETCH(Content, content);
        QFETCH(MapKind, kind);
        const MapSpec& spec = mapSpec(kind);
        const sim::TiledRaster raster = rasterOf(content, spec.layerChannels());
        const QByteArray png = encodeLayer(raster).bytes;
        const Checked<DecodedLayer> layer = decodeLayer(png, spec, kSize);
        QVERIFY(layer && layer->ours);
        QVERIFY(layer->raster == raster);
        const SalvagedLayer salvaged = salvageLayer(png, spec, kSize);
        QCOMPARE(salvaged.rows, kSize);
        QVERIFY(salvaged.raster == raster);
        // Qt's own reader is libpng, as most programs' is.
        const QImage image = QImage::fromData(png, "png");
        QCOMPARE(image.format(), QImage::Format_RGBA64);
        QCOMPARE(image.size(), QSize(kSize, kSize));
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const QRgba64 pixel = reinterpret_cast<const QRgba64*>(image.constScanLine(y))[x];
                const sim::Texel texel = raster.texel(x, y);
                const int channels = spec.layerChannels();
                QCOMPARE(pixel.red(), texel[0]);
                QCOMPARE(pixel.green(), texel[channels > 2 ? 1 : 0]);
                QCOMPARE(pixel.alpha(), texel[static_cast<std::size_t>(channels - 1)]);
            }
    }

    void noiseTakesHardlyMoreThanItHolds_data()
    {
        QTest::addColumn<Content>("content");
        QTest::addColumn<int>("channels");
        QTest::addColumn<double>("mostBytesATexel");
        // Beyond what it holds: 3 bits to repeat a value, and 4 where that it is covered is told from a value.
        QTest::newRow("values and coverage") << Content::Noise << 2 << 4.75;
        QTest::newRow("values alone") << Content::NoisyValues << 2 << 3.2;
        QTest::newRow("colours") << Content::Noise << 4 << 8.1;
    }
    void noiseTakesHardlyMoreThanItHolds()
    {
        QFETCH(Content, content);
        QFETCH(int, channels);
        QFETCH(double, mostBytesATexel);
        const auto bytes = static_cast<double>(encodeLayer(rasterOf(content, channels)).bytes.size());
        const double bytesATexel = bytes / (kSize * kSize);
        QVERIFY2(bytesATexel < mostBytesATexel, qPrintable(QString::number(bytesATexel)));
    }

    void theBytesAreThoseOfOneThread()
    {
        const sim::TiledRaster raster = rasterOf(Content::NoiseBelowWaves, 2);
        sim::setThreadCount(1);
        const QByteArray alone = encodeLayer(raster).bytes;
        sim::setThreadCount(5);
        const QByteArray together = encodeLayer(raster).bytes;
        sim::setThreadCount(0);
        QVERIFY(alone == together);
    }

    void whatStayedSinceTheFormerImageMakesNoDifference_data()
    {
        QTest::addColumn<Content>("content");
        QTest::newRow("nothing") << Content::Nothing;
        QTest::newRow("noise") << Content::Noise;
        QTest::newRow("noise below waves") << Content::NoiseBelowWaves;
    }
    void whatStayedSinceTheFormerImageMakesNoDifference()
    {
        QFETCH(Content, content);
        EncodedLayer former{.raster = rasterOf(content, 2), .png = {}};
        former.png = encodeLayer(former.raster);
        sim::TiledRaster raster = former.raster;
        for (const int y : {0, kSize / 2, kSize - 1}) {
            raster.setTexel(5, y, {1, 2, 0, 0});
            const PngFile anew = encodeLayer(raster);
            const PngFile mostlyKept = encodeLayer(raster, &former);
            QVERIFY(mostlyKept.bytes == anew.bytes);
            QCOMPARE(mostlyKept.checksum, checksumOf(anew.bytes));
            former = {.raster = raster, .png = mostlyKept};
        }
    }

    void valuesOfAnyFrequencyHaveCodes()
    {
        // Fibonacci's numbers make Huffman's tree as deep as it can be: here 22 bits, and deflate allows 15.
        std::vector<std::uint8_t> row;
        std::uint32_t count = 1;
        std::uint32_t before = 1;
        for (std::uint8_t value = 1; value <= 23; ++value) {
            row.insert(row.end(), count, value);
            before = std::exchange(count, count + before);
        }
        row.resize(row.size() / 8 * 8);
        for (std::size_t at = 0; at < row.size(); at += 8)
            std::swap(row[at], row[(at * 7919) % row.size()]); // So that not every pixel is grey.
        const PixelHuffman codes({row});
        QByteArray packed;
        codes.pack(packed);
        QCOMPARE(packed.size(), static_cast<qsizetype>(codes.packedBytes()));

        // The size as qUncompress wants it, zlib's header, the block, and an empty last one; no checksum.
        std::array<char, 4> size{};
        qToBigEndian(static_cast<quint32>(row.size() + 1), size.data());
        const QByteArray plain =
            '\0' + QByteArray(reinterpret_cast<const char*>(row.data()), static_cast<qsizetype>(row.size()));
        QByteArray stream = QByteArray(size.data(), 4) + QByteArray("\x78\x01", 2) + packed + QByteArray("\x03\x00", 2);
        std::array<char, 4> checksum{};
        qToBigEndian(adlerOf(plain), checksum.data());
        stream.append(checksum.data(), 4);
        QVERIFY(qUncompress(stream) == plain);
    }

private:
    /// RFC 1950, section 8.2.
    static quint32 adlerOf(const QByteArray& bytes)
    {
        quint32 a = 1;
        quint32 b = 0;
        for (const char byte : bytes) {
            a = (a + static_cast<unsigned char>(byte)) % 65521;
            b = (b + a) % 65521;
        }
        return b << 16U | a;
    }
};

HAIRPAINT_TEST(TestPngWriter, Core)
#include "test_png_writer.moc"
