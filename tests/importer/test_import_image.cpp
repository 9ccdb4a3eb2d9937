// Foreign images through the real helper: every depth, alpha as it stands, damage refused.
#include "model/files/image_map.h"
#include "model/files/importer_client.h"
#include "sim/groom/direction_texel.h"
#include "tests/importer/foreign_images.h"
#include "tests/model/archive_maker.h"
#include "tests/model/sample_project.h"
#include "tests/support/full_disk.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QBuffer>
#include <QColorSpace>
#include <QImage>
#include <QImageReader>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace hairpaint;
using namespace hairpaint::model;

class TestImportImage : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    ImporterClient m_client{test::importProgram(), 60'000};

    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }

    static ForeignImage sample(int channels, bool eightBit)
    {
        ForeignImage image{.width = 37, .height = 21, .channels = channels, .pixels = {}};
        std::mt19937 random(static_cast<unsigned>(channels));
        for (int i = 0; i < image.width * image.height * channels; ++i) {
            const auto value = static_cast<std::uint16_t>(random());
            image.pixels.push_back(eightBit ? static_cast<std::uint16_t>((value >> 8U) * 257U) : value);
        }
        // Some pixels are wholly transparent and still have a value.
        if (channels == 2 || channels == 4)
            for (std::size_t i = static_cast<std::size_t>(channels) - 1; i < image.pixels.size(); i += 40)
                image.pixels[i] = 0;
        return image;
    }

private Q_SLOTS:
    void whatIsWrittenReadsBackExactly_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<int>("bits");
        QTest::addColumn<int>("channels");
        for (const QString& ending : {QStringLiteral("png"), QStringLiteral("tif")})
            for (const int bits : {8, 16})
                for (const int channels : {1, 2, 3, 4})
                    QTest::addRow("%s, %d bits, %d channels", qPrintable(ending), bits, channels)
                        << ending << bits << channels;
        QTest::addRow("exr") << QStringLiteral("exr") << 16 << 3;
    }
    void whatIsWrittenReadsBackExactly()
    {
        QFETCH(QString, ending);
        QFETCH(int, bits);
        QFETCH(int, channels);
        const ForeignImage image = sample(channels, bits == 8);
        const QString file = path(QStringLiteral("image.") + ending);
        const auto written = m_client.writeImage(image, file, bits);
        QVERIFY2(written, written ? "" : qPrintable(written.error().message));
        const auto back = m_client.readImage(file);
        QVERIFY2(back, back ? "" : qPrintable(back.error().message));
        QCOMPARE(back->width, image.width);
        QCOMPARE(back->height, image.height);
        QCOMPARE(back->channels, channels);
        QVERIFY(back->pixels == image.pixels);
    }

    void anImageDrawnElsewhereIsReadAsItStands_data()
    {
        QTest::addColumn<int>("format");
        QTest::addColumn<QString>("ending");
        QTest::addColumn<int>("channels");
        QTest::addColumn<int>("tolerance");
        QTest::newRow("RGB PNG") << static_cast<int>(QImage::Format_RGB888) << QStringLiteral("png") << 3 << 0;
        QTest::newRow("RGBA PNG") << static_cast<int>(QImage::Format_RGBA8888) << QStringLiteral("png") << 4 << 0;
        QTest::newRow("16-bit RGBA PNG") << static_cast<int>(QImage::Format_RGBA64) << QStringLiteral("png") << 4 << 0;
        QTest::newRow("grey PNG") << static_cast<int>(QImage::Format_Grayscale8) << QStringLiteral("png") << 1 << 0;
        QTest::newRow("16-bit grey PNG") << static_cast<int>(QImage::Format_Grayscale16) << QStringLiteral("png") << 1
                                         << 0;
        QTest::newRow("BMP") << static_cast<int>(QImage::Format_RGB888) << QStringLiteral("bmp") << 3 << 0;
        QTest::newRow("JPEG") << static_cast<int>(QImage::Format_RGB888) << QStringLiteral("jpg") << 3 << 1800;
    }
    void anImageDrawnElsewhereIsReadAsItStands()
    {
        QFETCH(int, format);
        QFETCH(QString, ending);
        QFETCH(int, channels);
        QFETCH(int, tolerance);
        QImage drawn(64, 48, QImage::Format_RGBA64);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x)
                drawn.setPixelColor(x, y,
                                    QColor::fromRgba64(static_cast<quint16>(x * 1000), static_cast<quint16>(y * 1300),
                                                       30'000, static_cast<quint16>(x < 32 ? 65535 : 20'560)));
        drawn.convertTo(static_cast<QImage::Format>(format));
        const QString file = path(QStringLiteral("drawn.") + ending);
        QVERIFY(drawn.save(file, nullptr, 100));
        const auto image = m_client.readImage(file);
        QVERIFY2(image, image ? "" : qPrintable(image.error().message));
        QCOMPARE(image->channels, channels);
        for (int y = 0; y < 48; y += 5)
            for (int x = 0; x < 64; x += 3) {
                const QRgba64 expected = drawn.pixelColor(x, y).rgba64();
                const std::uint16_t* pixel = image->pixels.data() + (y * 64 + x) * channels;
                QVERIFY(std::abs(pixel[0] - expected.red()) <= tolerance);
                if (channels >= 3)
                    QVERIFY(std::abs(pixel[1] - expected.green()) <= tolerance &&
                            std::abs(pixel[2] - expected.blue()) <= tolerance);
                if (channels == 4)
                    QCOMPARE(pixel[3], expected.alpha());
            }
    }

    void aPhotographIsReadUpright_data()
    {
        QTest::addColumn<int>("orientation");
        for (int orientation = 0; orientation <= 9; ++orientation)
            QTest::addRow("%d", orientation) << orientation;
    }
    void aPhotographIsReadUpright()
    {
        QFETCH(int, orientation);
        QImage drawn(48, 32, QImage::Format_RGB888);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 48; ++x)
                drawn.setPixelColor(x, y, QColor(x * 5, y * 7, 100));
        QByteArray jpeg;
        QBuffer buffer(&jpeg);
        buffer.open(QIODevice::WriteOnly);
        QVERIFY(drawn.save(&buffer, "jpg", 100));
        // One entry of EXIF: tag 0x0112, a short.
        QByteArray exif("Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0", 25);
        exif.append(static_cast<char>(orientation)).append(QByteArray(6, '\0'));
        jpeg.insert(2, QByteArray("\xFF\xE1\0", 3) + static_cast<char>(exif.size() + 2) + exif);
        const QString file = path(QStringLiteral("photograph.jpg"));
        test::writeBytes(file, jpeg);

        QImageReader judge(file);
        judge.setAutoTransform(true);
        const QImage expected = judge.read();
        const auto image = m_client.readImage(file);
        QVERIFY2(image, image ? "" : qPrintable(image.error().message));
        QCOMPARE(QSize(image->width, image->height), expected.size());
        QCOMPARE(image->width, orientation >= 5 && orientation <= 8 ? 32 : 48);
        for (int y = 0; y < image->height; ++y)
            for (int x = 0; x < image->width; ++x) {
                const std::uint16_t* pixel = image->pixels.data() + (y * image->width + x) * 3;
                QVERIFY(std::abs(pixel[0] / 257 - qRed(expected.pixel(x, y))) <= 4);
                QVERIFY(std::abs(pixel[1] / 257 - qGreen(expected.pixel(x, y))) <= 4);
            }
    }

    void aScaleWrittenAndReadIsTheSameToAStepOfItsDepth_data()
    {
        QTest::addColumn<int>("map");
        QTest::addColumn<int>("bits");
        for (const MapSpec& spec : mapSpecs())
            for (const int bits : {8, 16})
                QTest::addRow("%s, %d bits", spec.id, bits) << static_cast<int>(spec.kind) << bits;
    }
    void aScaleWrittenAndReadIsTheSameToAStepOfItsDepth()
    {
        QFETCH(int, map);
        QFETCH(int, bits);
        const MapSpec& spec = mapSpec(static_cast<MapKind>(map));
        sim::TiledRaster resolved(256, spec.valueChannels);
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) {
                sim::Texel texel{};
                for (std::size_t c = 0; c < static_cast<std::size_t>(spec.valueChannels); ++c)
                    texel[c] = static_cast<std::uint16_t>(spec.texel == TexelKind::Index ? x / 128 : x * 257 - y);
                if (spec.texel == TexelKind::Vector) // No longer than a vector can be.
                    texel = sim::texelOfDirection(sim::directionOf(texel));
                resolved.setTexel(x, y, texel);
            }
        const QString file = path(QStringLiteral("scale.png"));
        QVERIFY(m_client.writeImage(imageFromMap(resolved, spec), file, bits));
        const auto image = m_client.readImage(file);
        QVERIFY(image);
        const auto layer = layerFromImage(*image, spec, false, 0);
        QVERIFY(layer);
        const int step = spec.texel == TexelKind::Index ? 0 : bits == 8 ? 257 : 1;
        for (int i = 0; i < 256 * 256; i += 37)
            QVERIFY(std::abs(layer->texel(i % 256, i / 256)[0] - resolved.texel(i % 256, i / 256)[0]) <= step);
    }

    void aDamagedImageIsRefusedOrReadWhole_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("name");
        QByteArray png;
        QBuffer buffer(&png);
        buffer.open(QIODevice::WriteOnly);
        QImage noise(100, 100, QImage::Format_RGB888);
        std::mt19937 random(3);
        for (int i = 0; i < 100 * noise.bytesPerLine(); ++i)
            noise.bits()[i] = static_cast<uchar>(random());
        noise.save(&buffer, "png");
        QTest::newRow("a text named PNG") << QByteArray("not a picture at all") << QStringLiteral("a.png");
        QTest::newRow("a text") << QByteArray("hello") << QStringLiteral("a.txt");
        QTest::newRow("a signature") << png.first(8) << QStringLiteral("b.png");
        QTest::newRow("half a PNG") << png.first(png.size() / 2) << QStringLiteral("c.png");
        QTest::newRow("a PNG of 2 billion pixels a side")
            << test::pngSignature() + test::pngHeader(0x7FFFFFFF, 0x7FFFFFFF, 16, 6) + test::pngChunk("IDAT", "x")
            << QStringLiteral("d.png");
        QTest::newRow("a PNG of 60000 pixels a side")
            << test::pngSignature() + test::pngHeader(60'000, 60'000, 8, 2) +
                   test::pngChunk("IDAT", qCompress(QByteArray(1000, '\0')).sliced(4)) + test::pngChunk("IEND", {})
            << QStringLiteral("e.png");
        QTest::newRow("a name of odd characters") << QByteArray("x") << QStringLiteral("a b'ü\n.png");
    }
    void aDamagedImageIsRefusedOrReadWhole()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        const QString file = path(name);
        test::writeBytes(file, bytes);
        const auto image = m_client.readImage(file);
        QVERIFY(!image);
        QString shown = file;
        shown.replace(QLatin1Char('\n'), QLatin1Char('?'));
        QVERIFY2(test::isOneSentenceNaming(image.error().message, shown), qPrintable(image.error().message));
    }

    void aPsdPackedByZipIsSaidToBeSo()
    {
        const QByteArray pixels = qCompress(QByteArray(3 * 4 * 4, '\x55')).sliced(4);
        const QByteArray psd = QByteArray("8BPS\0\1\0\0\0\0\0\0\0\3\0\0\0\4\0\0\0\4\0\x08\0\3", 26) +
                               QByteArray(12, '\0') + QByteArray("\0\2", 2) + pixels;
        const QString file = path(QStringLiteral("zip.psd"));
        test::writeBytes(file, psd);
        const auto image = m_client.readImage(file);
        QVERIFY(!image);
        QVERIFY2(image.error().message.contains(QStringLiteral("compressed")), qPrintable(image.error().message));
        QVERIFY2(test::isOneSentenceNaming(image.error().message, file), qPrintable(image.error().message));
    }

    void anImageOfAnotherProgramIsReadByItsFormat_data()
    {
        using Samples = QList<int>;
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("areColours");
        QTest::addColumn<int>("channels");
        QTest::addColumn<Samples>("expected");
        const auto row = [](const char* title, const QByteArray& bytes, const char* name, bool areColours, int channels,
                            const Samples& expected) {
            QTest::newRow(title) << bytes << QString::fromLatin1(name) << areColours << channels << expected;
        };
        const QList<QByteArray> rgb{"B", "G", "R"};
        row("linear EXR, colours", test::exr(rgb, {0.02F, 0.05F, 0.5F}, 0, 1, 1), "a.exr", true, 3,
            {48192, 16240, 9942});
        row("linear EXR, data", test::exr(rgb, {0.02F, 0.05F, 0.5F}, 0, 1, 1), "a.exr", false, 3, {32768, 3277, 1311});
        row("EXR with a display window", test::exr({"Y"}, {0.8F}, 1, 2, 4), "a.exr", false, 2,
            {0, 0, 52428, 65535, 52428, 65535, 0, 0});
        row("EXR with more than it shows", test::exr({"Y"}, {0.8F}, -2, 9, 2), "a.exr", false, 1, {52428, 52428});
        row("EXR with alpha", test::exr({"A", "B", "G", "R"}, {0.5F, 0.25F, 0.25F, 0.25F}, 0, 1, 1), "a.exr", false, 4,
            {32768, 32768, 32768, 32768});
        row("EXR with depth", test::exr({"B", "G", "R", "Z"}, {0.2F, 0.4F, 0.6F, 0.25F}, 0, 1, 1), "a.exr", false, 3,
            {39321, 26214, 13107});
        row("EXR of a layer", test::exr({"hair.B", "hair.G", "hair.R"}, {0.2F, 0.4F, 0.6F}, 0, 1, 1), "a.exr", false, 3,
            {39321, 26214, 13107});
        row("EXR of luminance and chroma", test::exr({"BY", "RY", "Y"}, {0.2F, 0.4F, 0.6F}, 0, 1, 1), "a.exr", false, 1,
            {39321});
        const QByteArray pixel("\x32\x64\x14\x80", 4);
        row("TIFF, associated alpha", test::tiff({.samples = 4, .photometric = 2, .extra = 1, .data = pixel}), "a.tif",
            false, 4, {25600, 51199, 10240, 32896});
        row("TIFF, unassociated alpha", test::tiff({.samples = 4, .photometric = 2, .extra = 2, .data = pixel}),
            "a.tif", false, 4, {12850, 25700, 5140, 32896});
        row("TIFF, a channel that is no alpha", test::tiff({.samples = 4, .photometric = 2, .extra = 0, .data = pixel}),
            "a.tif", false, 3, {12850, 25700, 5140});
        row("TIFF, 0 is white, 8 bits", test::tiff({.photometric = 0, .data = "\x0A"}), "a.tif", false, 1, {62965});
        row("TIFF, 0 is white, 16 bits", test::tiff({.bits = 16, .photometric = 0, .data = QByteArray("\xE8\x03", 2)}),
            "a.tif", false, 1, {64535});
        row("TIFF, 0 is white, with alpha",
            test::tiff({.samples = 2, .photometric = 0, .extra = 2, .data = QByteArray("\x0A\x80", 2)}), "a.tif", false,
            2, {62965, 32896});
        row("TIFF, bits not told", test::tiff({.width = 4, .bits = 1, .tellsBits = false, .data = "\xA0"}), "a.tif",
            false, 1, {65535, 0, 65535, 0});
        row("BMP, unused byte", test::bmp32(QByteArray("\x14\x64\x32\0", 4)), "a.bmp", false, 3, {12850, 25700, 5140});
        row("WebP, alpha", test::webp(), "a.webp", false, 4, {51400, 25700, 12850, 32896, 2570, 5140, 7710, 65535});
        row("WebP, turned", test::turnedWebp(), "a.webp", false, 3, {2570, 5140, 7710, 51400, 25700, 12850});
        row("PSD with its picture", test::psd(true), "a.psd", false, 3, {32896, 16448, 8224});
    }
    void anImageOfAnotherProgramIsReadByItsFormat()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        QFETCH(bool, areColours);
        QFETCH(int, channels);
        QFETCH(QList<int>, expected);
        const QString file = path(name);
        test::writeBytes(file, bytes);
        const auto image = areColours ? m_client.readColours(file) : m_client.readImage(file);
        QVERIFY2(image, image ? "" : qPrintable(image.error().message));
        QCOMPARE(image->channels, channels);
        QCOMPARE(QList<int>(image->pixels.begin(), image->pixels.end()), expected);
    }

    void aPsdOfLayersAloneIsRefused()
    {
        const QString file = path(QStringLiteral("layers.psd"));
        test::writeBytes(file, test::psd(false));
        const auto image = m_client.readImage(file);
        QVERIFY(!image);
        QVERIFY2(image.error().message.contains(QStringLiteral("layers")), qPrintable(image.error().message));
        QVERIFY2(test::isOneSentenceNaming(image.error().message, file), qPrintable(image.error().message));
    }

    void coloursGoOutToExrInLinearLightAndComeBackExactly()
    {
        ForeignImage image = sample(3, false);
        image.areColours = true;
        const QString file = path(QStringLiteral("colours.exr"));
        QVERIFY(m_client.writeImage(image, file, 16));
        const auto back = m_client.readColours(file);
        QVERIFY(back && back->pixels == image.pixels);
        const auto light = m_client.readImage(file);
        QVERIFY(light && light->pixels[0] < image.pixels[0]);
    }

    void aProfileCountsForColoursAlone()
    {
        QImage drawn(1, 1, QImage::Format_RGB888);
        drawn.setPixelColor(0, 0, QColor(0, 255, 0));
        drawn.setColorSpace(
            QColorSpace(QColorSpace::ProPhotoRgb).withTransferFunction(QColorSpace::TransferFunction::SRgb));
        drawn.setPixelColor(0, 0, QColor(100, 120, 90));
        const QString file = path(QStringLiteral("profile.png"));
        QVERIFY(drawn.save(file));
        const QColor expected = drawn.convertedToColorSpace(QColorSpace(QColorSpace::SRgb)).pixelColor(0, 0);
        const auto colours = m_client.readColours(file);
        QVERIFY(colours);
        QVERIFY(std::abs(colours->pixels[0] / 257 - expected.red()) <= 2);
        QVERIFY(std::abs(colours->pixels[1] / 257 - expected.green()) <= 2);
        QVERIFY(std::abs(colours->pixels[2] / 257 - expected.blue()) <= 2);
        QVERIFY(expected.green() != 120);
        const auto data = m_client.readImage(file);
        QCOMPARE(data->pixels, (std::vector<std::uint16_t>{25700, 30840, 23130}));
        drawn.setColorSpace(QColorSpace(QColorSpace::SRgb));
        QVERIFY(drawn.save(file));
        QCOMPARE(m_client.readColours(file)->pixels, data->pixels);
    }

#ifdef Q_OS_UNIX
    void onAFullDiskTheOldImageStays()
    {
        const QString file = path(QStringLiteral("full.png"));
        test::writeBytes(file, "old");
        {
            const test::FullDisk disk(100);
            const auto written = m_client.writeImage(sample(3, false), file, 16);
            QVERIFY(!written);
            QVERIFY2(test::isOneSentenceNaming(written.error().message, file), qPrintable(written.error().message));
        }
        QCOMPARE(test::readBytes(file), QByteArray("old"));
        QVERIFY(m_client.writeImage(sample(3, false), file, 16));
    }
#endif

    void anEndingThatCannotBeWrittenIsRefused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("unknown") << QStringLiteral("map.xyz");
        QTest::newRow("none") << QStringLiteral("map");
        QTest::newRow("odd") << QStringLiteral("map.p/ng");
        QTest::newRow("a folder that is not there") << QStringLiteral("none/map.png");
    }
    void anEndingThatCannotBeWrittenIsRefused()
    {
        QFETCH(QString, name);
        const auto written = m_client.writeImage(sample(3, false), path(name));
        QVERIFY(!written);
        QVERIFY2(test::isOneSentenceNaming(written.error().message, path(name)), qPrintable(written.error().message));
        QVERIFY(!QFile::exists(path(name)));
    }
};

HAIRPAINT_TEST(TestImportImage, Core)
#include "test_import_image.moc"
