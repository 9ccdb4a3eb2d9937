// Images become layers through each map's scale, and maps become images that read back the same.
#include "model/files/image_map.h"
#include "model/maps/texel_ops.h"
#include "model/values/texel_math.h"
#include "sim/groom/direction_texel.h"
#include "sim/groom/groom.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace hairpaint;
using namespace hairpaint::model;

namespace {

ForeignImage flat(int width, int height, const std::vector<double>& colour)
{
    ForeignImage image{.width = width, .height = height, .channels = static_cast<int>(colour.size()), .pixels = {}};
    for (int i = 0; i < width * height; ++i)
        for (const double channel : colour)
            image.pixels.push_back(static_cast<std::uint16_t>(std::lround(channel * 65535.0)));
    return image;
}

} // namespace

class TestImageMapFile : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aColourIsReadAlongTheMapsScale_data()
    {
        QTest::addColumn<QByteArray>("map");
        QTest::addColumn<std::vector<double>>("colour");
        QTest::addColumn<double>("value");
        const auto row = [](const char* name, const char* map, const std::vector<double>& colour, double value) {
            QTest::newRow(name) << QByteArray(map) << colour << value;
        };
        row("white is no hair", "density", {1, 1, 1}, 0);
        row("black is no hair", "density", {0, 0, 0}, 0);
        row("grey is no hair", "density", {0.4, 0.4, 0.4}, 0);
        row("green is all hair", "density", {0, 1, 0}, 1);
        row("pale green is half", "density", {0.5, 1, 0.5}, 0.5);
        row("dark green is half", "density", {0, 0.5, 0}, 0.5);
        row("yellow is no green", "density", {1, 1, 0}, 0);
        row("a grey image is no hair", "density", {0.7}, 0);
        row("blue is longest", "length", {0, 0, 1}, 1);
        row("pale blue is a quarter", "length", {0.75, 0.75, 1}, 0.25);
        row("red is most curled", "curl", {1, 0, 0}, 1);
        row("dark red", "curl", {0.3, 0, 0}, 0.3);
        row("yellow is one wisp", "clump", {1, 1, 0}, 1);
        row("cyan is held", "gel", {0, 1, 1}, 1);
        row("violet strays furthest", "frizz", {0.5, 0, 1}, 1);
        row("pale violet strays half as far", "frizz", {0.75, 0.5, 1}, 0.5);
        row("brown is thickest", "width", {150 / 255.0, 75 / 255.0, 0}, 1);
        row("pale brown is as the group", "width", {405 / 510.0, 330 / 510.0, 0.5}, 0.5);
        row("rose mirrors", "gloss", {1, 0, 0.5}, 1);
        row("white is matte", "gloss", {1, 1, 1}, 0);
        row("pale cyan is half held", "gel", {0.5, 1, 1}, 0.5);
    }
    void aColourIsReadAlongTheMapsScale()
    {
        QFETCH(QByteArray, map);
        QFETCH(std::vector<double>, colour);
        QFETCH(double, value);
        const MapSpec& spec = *findMapSpec(QString::fromLatin1(map));
        const auto layer = layerFromImage(flat(256, 256, colour), spec, false, 0);
        QVERIFY(layer);
        QCOMPARE(layer->size(), 256);
        const sim::Texel texel = layer->texel(100, 30);
        QVERIFY2(std::abs(texel[0] - value * 65535.0) <= 1.0, qPrintable(QString::number(texel[0])));
        QCOMPARE(texel[1], std::uint16_t{65535});
    }

    void braidColoursBecomeIndices_data()
    {
        QTest::addColumn<std::vector<double>>("colour");
        QTest::addColumn<int>("index");
        QTest::newRow("white") << std::vector<double>{1, 1, 1} << 0;
        QTest::newRow("black") << std::vector<double>{0, 0, 0} << 0;
        QTest::newRow("magenta") << std::vector<double>{1, 0, 1} << 1;
        QTest::newRow("pale magenta") << std::vector<double>{1, 0.45, 1} << 1;
        QTest::newRow("paler magenta") << std::vector<double>{1, 0.7, 1} << 0;
    }
    void braidColoursBecomeIndices()
    {
        QFETCH(std::vector<double>, colour);
        QFETCH(int, index);
        const auto layer = layerFromImage(flat(300, 200, colour), mapSpec(MapKind::Braid), false, 0);
        QVERIFY(layer);
        QCOMPARE(layer->size(), 512);
        QCOMPARE(static_cast<int>(layer->texel(511, 0)[0]), index);
    }

    void directionsAreReadFromANormalMap_data()
    {
        QTest::addColumn<std::vector<double>>("colour");
        QTest::addColumn<glm::vec2>("direction");
        QTest::newRow("the blue of normal maps") << std::vector<double>{0.5, 0.5, 1} << glm::vec2(0.0F);
        QTest::newRow("to the right") << std::vector<double>{1, 0.5, 0.5} << glm::vec2(1.0F, 0.0F);
        QTest::newRow("up the map") << std::vector<double>{0.5, 1, 0.5} << glm::vec2(0.0F, 1.0F);
        QTest::newRow("half to the left") << std::vector<double>{0.25, 0.5, 0.933} << glm::vec2(-0.5F, 0.0F);
        QTest::newRow("longer than can be") << std::vector<double>{0, 0, 0.5} << glm::vec2(-0.70711F, -0.70711F);
        QTest::newRow("alpha is coverage") << std::vector<double>{0.5, 0, 0.5, 1} << glm::vec2(0.0F, -1.0F);
    }
    void directionsAreReadFromANormalMap()
    {
        QFETCH(std::vector<double>, colour);
        QFETCH(glm::vec2, direction);
        const auto layer = layerFromImage(flat(256, 256, colour), mapSpec(MapKind::Direction), false, 0);
        QVERIFY(layer);
        const sim::Texel texel = layer->texel(100, 30);
        QVERIFY(glm::distance(sim::directionOf(texel), direction) < 1e-4F);
        QCOMPARE(texel[2], std::uint16_t{65535});
    }

    void aDirectionIsWrittenAsAnOrdinaryNormalMap()
    {
        const MapSpec& spec = mapSpec(MapKind::Direction);
        sim::TiledRaster resolved(256, 2, sim::texelOfDirection({0.6F, -0.48F}));
        const ForeignImage image = imageFromMap(resolved, spec);
        const auto coordinate = [&](std::size_t c) { return image.pixels[c] / 65535.0 * 2.0 - 1.0; };
        QVERIFY(std::abs(coordinate(0) - 0.6) < 1e-4);
        QVERIFY(std::abs(coordinate(1) + 0.48) < 1e-4);
        QVERIFY(std::abs(coordinate(2) - 0.64) < 1e-4);
        QCOMPARE(colourOfTexel(spec, spec.defaultValue, true), qRgb(128, 128, 255));
    }

    void greyIsTheValueItself_data()
    {
        QTest::addColumn<std::vector<double>>("colour");
        QTest::addColumn<double>("value");
        QTest::newRow("grey") << std::vector<double>{0.3} << 0.3;
        QTest::newRow("grey in RGB") << std::vector<double>{0.3, 0.3, 0.3} << 0.3;
        QTest::newRow("white") << std::vector<double>{1, 1, 1, 1} << 1.0;
        QTest::newRow("black") << std::vector<double>{0, 0, 0} << 0.0;
    }
    void greyIsTheValueItself()
    {
        QFETCH(std::vector<double>, colour);
        QFETCH(double, value);
        for (const MapKind kind : {MapKind::Density, MapKind::Length, MapKind::Colour}) {
            const auto layer = layerFromImage(flat(256, 256, colour), mapSpec(kind), true, 0);
            QVERIFY(layer);
            QCOMPARE(layer->texel(1, 2)[0], static_cast<std::uint16_t>(std::lround(value * 65535.0)));
        }
    }

    void alphaBecomesCoverage()
    {
        const auto scalar = layerFromImage(flat(256, 256, {0, 1, 0, 0.25}), mapSpec(MapKind::Density), false, 0);
        QCOMPARE(scalar->texel(9, 9), (sim::Texel{65535, 16384, 0, 0}));
        const auto colour = layerFromImage(flat(256, 256, {0.2, 0.4, 0.6, 0}), mapSpec(MapKind::Colour), false, 0);
        QCOMPARE(colour->texel(9, 9), (sim::Texel{13107, 26214, 39321, 0}));
        const auto greyAlpha = layerFromImage(flat(256, 256, {0.2, 0.5}), mapSpec(MapKind::Gel), true, 0);
        QCOMPARE(greyAlpha->texel(9, 9), (sim::Texel{13107, 32768, 0, 0}));
    }

    void anImageGetsTheNextSizeThatAMapMayHave_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<int>("wanted");
        QTest::addColumn<int>("size");
        QTest::newRow("small") << 10 << 10 << 0 << 256;
        QTest::newRow("right") << 512 << 512 << 0 << 512;
        QTest::newRow("odd") << 513 << 300 << 0 << 1024;
        QTest::newRow("not square") << 256 << 512 << 0 << 512;
        QTest::newRow("asked smaller") << 1024 << 1024 << 256 << 256;
        QTest::newRow("asked larger") << 256 << 256 << 1024 << 1024;
        QTest::newRow("four times as wide") << 1024 << 256 << 0 << 1024;
        QTest::newRow("five times as tall") << 200 << 1000 << 0 << 1024;
        QTest::newRow("ribbon") << 5000 << 2 << 0 << 256;
        QTest::newRow("upright ribbon") << 100 << 8192 << 0 << 512;
        QTest::newRow("one pixel") << 1 << 1 << 0 << 256;
    }
    void anImageGetsTheNextSizeThatAMapMayHave()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(int, wanted);
        QFETCH(int, size);
        const auto layer = layerFromImage(flat(width, height, {0.5, 1, 0.5}), mapSpec(MapKind::Density), false, wanted);
        QVERIFY(layer);
        QCOMPARE(layer->size(), size);
        for (const int at : {0, size / 3, size - 1})
            QVERIFY(std::abs(layer->texel(at, size - 1 - at)[0] - 32768) <= 1);
    }

    void anImageOfTheRightSizeIsTakenTexelByTexel()
    {
        ForeignImage image{.width = 256, .height = 256, .channels = 1, .pixels = {}};
        for (int i = 0; i < 256 * 256; ++i)
            image.pixels.push_back(static_cast<std::uint16_t>(static_cast<unsigned>(i) * 40'503U));
        const auto layer = layerFromImage(image, mapSpec(MapKind::Length), true, 0);
        for (int i = 0; i < 256 * 256; i += 77)
            QCOMPARE(layer->texel(i % 256, i / 256)[0], image.pixels[static_cast<std::size_t>(i)]);
    }

    void aRampStaysARampWhenResampled_data()
    {
        QTest::addColumn<int>("side");
        QTest::addColumn<int>("size");
        QTest::newRow("enlarged") << 300 << 512;
        QTest::newRow("doubled") << 256 << 512;
        QTest::newRow("shrunk a little") << 300 << 256;
        QTest::newRow("shrunk four times") << 1024 << 256;
    }
    void aRampStaysARampWhenResampled()
    {
        QFETCH(int, side);
        QFETCH(int, size);
        ForeignImage image{.width = side, .height = side, .channels = 1, .pixels = {}};
        for (int i = 0; i < side * side; ++i)
            image.pixels.push_back(static_cast<std::uint16_t>((i % side + 0.5) / side * 60'000));
        const auto layer = layerFromImage(image, mapSpec(MapKind::Length), true, size);
        const int border = 2 * size / side + 2;
        for (int x = border; x < size - border; ++x)
            QVERIFY(std::abs(layer->texel(x, size / 2)[0] - (x + 0.5) / size * 60'000) < 250);
    }

    void transparentPixelsGiveNoColourWhenResampled()
    {
        ForeignImage image{.width = 2, .height = 1, .channels = 4, .pixels = {0, 65535, 0, 65535, 0, 0, 0, 0}};
        const auto layer = layerFromImage(image, mapSpec(MapKind::Density), false, 256);
        for (int x = 0; x < 256; ++x)
            if (layer->texel(x, 0)[1] > 0)
                QVERIFY(layer->texel(x, 0)[0] >= 65534);
        QCOMPARE(layer->texel(255, 0)[1], std::uint16_t{0});
    }

    void aMapWrittenAsAnImageReadsBackTheSame_data()
    {
        QTest::addColumn<int>("map");
        for (const MapSpec& spec : mapSpecs())
            QTest::newRow(spec.id) << static_cast<int>(spec.kind);
    }
    void aMapWrittenAsAnImageReadsBackTheSame()
    {
        QFETCH(int, map);
        const MapSpec& spec = mapSpec(static_cast<MapKind>(map));
        sim::TiledRaster resolved(256, spec.valueChannels);
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) {
                sim::Texel texel{};
                for (std::size_t c = 0; c < static_cast<std::size_t>(spec.valueChannels); ++c)
                    texel[c] = spec.texel == TexelKind::Index
                                   ? static_cast<std::uint16_t>((x / 8 + y) % static_cast<int>(spec.palette.size()))
                                   : static_cast<std::uint16_t>(x * 257 - y + static_cast<int>(c));
                if (spec.texel == TexelKind::Vector) // No longer than a vector can be.
                    texel = sim::texelOfDirection(sim::directionOf(texel));
                resolved.setTexel(x, y, texel);
            }
        const auto back = layerFromImage(imageFromMap(resolved, spec), spec, false, 0);
        QVERIFY(back);
        for (int i = 0; i < 256 * 256; i += 13)
            for (std::size_t c = 0; c < static_cast<std::size_t>(spec.valueChannels); ++c)
                QVERIFY(std::abs(back->texel(i % 256, i / 256)[c] - resolved.texel(i % 256, i / 256)[c]) <=
                        (spec.texel == TexelKind::Scalar || spec.texel == TexelKind::Vector ? 1 : 0));
    }

    /// Rows that touch stay rows of their own in an image of 16 bits; in one of 8 they are rows, of one number.
    void rowsKeepTheirNumbersInAnImage()
    {
        const MapSpec& spec = mapSpec(MapKind::Braid);
        sim::TiledRaster resolved(256, 1);
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                resolved.setTexel(x, y,
                                  {static_cast<std::uint16_t>((y * 256 + x) % (sim::kLastRowNumber + 1)), 0, 0, 0});
        ForeignImage image = imageFromMap(resolved, spec);
        const auto read = layerFromImage(image, spec, false, 256);
        QVERIFY(read.has_value());
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                QCOMPARE(read->texel(x, y)[0], resolved.texel(x, y)[0]);
        for (std::uint16_t& channel : image.pixels)
            channel = widened(narrowed(channel));
        const auto coarse = layerFromImage(image, spec, false, 256);
        for (int x = 0; x < 256; ++x)
            QCOMPARE(int{coarse->texel(x, 0)[0]}, std::min(x, int{7}));
    }

    void paintedTexelsShowTheScale_data()
    {
        QTest::addColumn<MapKind>("kind");
        QTest::addColumn<bool>("night");
        QTest::addColumn<int>("value");
        QTest::addColumn<QRgb>("colour");
        QTest::newRow("paper") << MapKind::Density << false << 0 << 0xFFFFFFFF;
        QTest::newRow("full green") << MapKind::Density << false << 65535 << 0xFF00FF00;
        QTest::newRow("half on paper") << MapKind::Density << false << 32768 << 0xFF55FF55;
        QTest::newRow("night paper") << MapKind::Density << true << 0 << 0xFF000000;
        QTest::newRow("full green at night") << MapKind::Density << true << 65535 << 0xFF00FF00;
        QTest::newRow("half at night") << MapKind::Density << true << 32768 << 0xFF00AA00;
        QTest::newRow("no braid on paper") << MapKind::Braid << false << 0 << 0xFFFFFFFF;
        QTest::newRow("no braid at night") << MapKind::Braid << true << 0 << 0xFF000000;
        QTest::newRow("a plait at night") << MapKind::Braid << true << 1 << 0xFFFF00FF;
    }
    void paintedTexelsShowTheScale()
    {
        QFETCH(MapKind, kind);
        QFETCH(bool, night);
        QFETCH(int, value);
        QFETCH(QRgb, colour);
        sim::TiledRaster resolved(256, 1);
        resolved.setUniform(0, {static_cast<std::uint16_t>(value)});
        for (int y = 0; y < 64; ++y)
            for (int x = 64; x < 128; ++x)
                resolved.setTexel(x, y, {static_cast<std::uint16_t>(value)});
        std::vector<QRgb> pixels(40 * 5, 0);
        paintMapTexels(resolved, mapSpec(kind), night, {50, 60, 80, 64}, pixels.data(), 40);
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 40; ++x) {
                const QRgb pixel = pixels[static_cast<std::size_t>(y) * 40 + static_cast<std::size_t>(x)];
                if (x >= 30) {
                    QCOMPARE(pixel, QRgb{0}); // outside the rectangle
                    continue;
                }
                QCOMPARE(qAlpha(pixel), 255);
                QVERIFY(std::abs(qRed(pixel) - qRed(colour)) <= 1 && std::abs(qGreen(pixel) - qGreen(colour)) <= 1 &&
                        std::abs(qBlue(pixel) - qBlue(colour)) <= 1);
            }
    }

    void anImageWithoutPixelsIsRefused()
    {
        QVERIFY(!layerFromImage({}, mapSpec(MapKind::Gel), false, 0));
        QVERIFY(!layerFromImage({.width = 5, .height = 5, .channels = 3, .pixels = {1, 2, 3}}, mapSpec(MapKind::Gel),
                                false, 0));
    }
};

HAIRPAINT_TEST(TestImageMapFile, Core)
#include "test_image_map_file.moc"
