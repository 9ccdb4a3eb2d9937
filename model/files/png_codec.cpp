// Layers to PNG and back. Nothing reaches libpng whose chunks were not walked first.
#include "model/files/png_codec.h"

#include <QBuffer>
#include <QImage>
#include <QImageReader>
#include <QImageWriter>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <cstring>

namespace hairpaint::model {

namespace {

constexpr int kTile = sim::TiledRaster::kTileSize;
constexpr int kDotsPerMeter = 2835; // 72 to an inch; Qt would write the screen's own
constexpr int kCompression = 20;    // of 100: zlib's level 1 or 2
constexpr std::array<char, 8> kSignature = {'\x89', 'P', 'N', 'G', '\r', '\n', '\x1a', '\n'};

tl::unexpected<Clause> brokenImage()
{
    return refuse(say(QT_TRANSLATE_NOOP("Files", "one of its images is broken")));
}

std::array<quint32, 256> makeCrcTable()
{
    std::array<quint32, 256> table{};
    for (quint32 n = 0; n < table.size(); ++n) {
        quint32 c = n;
        for (int bit = 0; bit < 8; ++bit)
            c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1U) : c >> 1U;
        table[n] = c;
    }
    return table;
}

/// CRC-32 of PNG (ISO 3309).
quint32 crc32(const char* bytes, qsizetype count)
{
    static const std::array<quint32, 256> table = makeCrcTable();
    quint32 c = 0xFFFFFFFFU;
    for (qsizetype i = 0; i < count; ++i)
        c = table[(c ^ static_cast<unsigned char>(bytes[i])) & 0xFFU] ^ (c >> 8U);
    return c ^ 0xFFFFFFFFU;
}

bool acceptableHeader(const char* data, quint32 length, int size)
{
    if (length != 13)
        return false;
    const auto side = static_cast<quint32>(size);
    // Width, height, 16 bits, colour type RGBA, deflate, adaptive filters, not interlaced.
    return qFromBigEndian<quint32>(data) == side && qFromBigEndian<quint32>(data + 4) == side && data[8] == 16 &&
           data[9] == 6 && data[10] == 0 && data[11] == 0 && data[12] == 0;
}

struct CheckedPng
{
    QByteArray bytes; ///< IHDR, IDAT and IEND only.
    bool onlyOurChunks = true;
};

Checked<CheckedPng> checkPng(const QByteArray& png, int size)
{
    if (png.size() < 8 || std::memcmp(png.constData(), kSignature.data(), kSignature.size()) != 0)
        return refuse(say(QT_TRANSLATE_NOOP("Files", "one of its images is not a PNG")));
    CheckedPng checked;
    checked.bytes.reserve(png.size());
    checked.bytes.append(png.constData(), 8);
    qsizetype at = 8;
    bool sawHeader = false;
    bool sawPixels = false;
    while (at + 12 <= png.size()) {
        const char* chunk = png.constData() + at;
        const auto length = qFromBigEndian<quint32>(chunk);
        if (length > 0x7FFFFFFFU || length > png.size() - at - 12)
            return brokenImage();
        const QByteArrayView type(chunk + 4, 4);
        if (crc32(chunk + 4, static_cast<qsizetype>(length) + 4) != qFromBigEndian<quint32>(chunk + 8 + length))
            return brokenImage();
        const bool header = type == QByteArrayView("IHDR");
        const bool end = type == QByteArrayView("IEND");
        const bool pixels = type == QByteArrayView("IDAT");
        if (header == sawHeader || (end && !sawPixels))
            return brokenImage();
        sawPixels = sawPixels || pixels;
        if (header && !acceptableHeader(chunk + 8, length, size))
            return refuse(say(QT_TRANSLATE_NOOP("Files", "one of its images is not %1 x %1 in 16-bit RGBA")).arg(size));
        sawHeader = true;
        const bool ancillary = (static_cast<unsigned char>(chunk[4]) & 0x20U) != 0;
        if (header || end || pixels)
            checked.bytes.append(chunk, static_cast<qsizetype>(length) + 12);
        else if (!ancillary && type != QByteArrayView("PLTE"))
            return brokenImage();
        else
            checked.onlyOurChunks = checked.onlyOurChunks && type == QByteArrayView("pHYs");
        at += static_cast<qsizetype>(length) + 12;
        if (end) {
            checked.onlyOurChunks = checked.onlyOurChunks && at == png.size();
            return at == png.size() ? Checked<CheckedPng>(std::move(checked)) : Checked<CheckedPng>(brokenImage());
        }
    }
    return brokenImage();
}

/// Sizes are checked before; Qt's own limit (MB, of the whole program) must admit the largest.
void raiseAllocationLimit()
{
    constexpr int kMegabytes = 1024;
    static const bool raised = [] {
        if (QImageReader::allocationLimit() != 0 && QImageReader::allocationLimit() < kMegabytes)
            QImageReader::setAllocationLimit(kMegabytes);
        return true;
    }();
    Q_UNUSED(raised)
}

Checked<QImage> decodeImage(QByteArray& bytes, int size)
{
    QBuffer buffer(&bytes);
    QImageReader reader(&buffer, "png");
    reader.setAutoTransform(false);
    raiseAllocationLimit();
    QImage image = reader.read();
    if (image.isNull() || image.width() != size || image.height() != size)
        return brokenImage();
    if (image.format() != QImage::Format_RGBA64)
        image = std::move(image).convertToFormat(QImage::Format_RGBA64);
    if (image.isNull())
        return brokenImage();
    return image;
}

/// Fills one row of texels from RGBA64; true where the image held just what encodeLayer would write.
bool takeRow(const quint16* rgba, std::uint16_t* texels, int count, int channels, std::uint16_t greatestIndex)
{
    bool ours = true;
    for (int x = 0; x < count; ++x, rgba += 4, texels += channels) {
        if (channels == 4) {
            std::memcpy(texels, rgba, 8);
            continue;
        }
        ours = ours && rgba[1] == rgba[0] && rgba[2] == rgba[0] && rgba[0] <= greatestIndex;
        texels[0] = rgba[0] <= greatestIndex ? rgba[0] : std::uint16_t{0};
        texels[1] = rgba[3];
    }
    return ours;
}

bool isUniform(const std::vector<std::uint16_t>& pixels, std::size_t channels)
{
    return std::equal(pixels.begin() + static_cast<std::ptrdiff_t>(channels), pixels.end(), pixels.begin());
}

} // namespace

QByteArray encodeLayer(const sim::TiledRaster& raster)
{
    const int size = raster.size();
    const int channels = raster.channels();
    QImage image(size, size, QImage::Format_RGBA64);
    for (int index = 0; index < raster.tileCount(); ++index) {
        const sim::RasterTile& tile = *raster.tile(index);
        const sim::TexelRect rect = raster.tileRect(index);
        for (int y = 0; y < kTile; ++y) {
            auto* rgba = reinterpret_cast<quint16*>(image.scanLine(rect.y0 + y)) + std::ptrdiff_t{4} * rect.x0;
            const std::uint16_t* texel =
                tile.isUniform() ? tile.uniform.data() : tile.pixels.data() + std::ptrdiff_t{y} * kTile * channels;
            const int step = tile.isUniform() ? 0 : channels;
            for (int x = 0; x < kTile; ++x, rgba += 4, texel += step) {
                rgba[0] = texel[0];
                rgba[1] = texel[channels == 4 ? 1 : 0];
                rgba[2] = texel[channels == 4 ? 2 : 0];
                rgba[3] = texel[channels - 1];
            }
        }
    }
    image.setDotsPerMeterX(kDotsPerMeter);
    image.setDotsPerMeterY(kDotsPerMeter);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QImageWriter writer(&buffer, "png");
    writer.setCompression(kCompression);
    if (!writer.write(image))
        bytes.clear();
    return bytes;
}

Checked<DecodedLayer> decodeLayer(const QByteArray& png, const MapSpec& spec, int size)
{
    Checked<CheckedPng> checked = checkPng(png, size);
    if (!checked)
        return tl::unexpected(checked.error());
    const Checked<QImage> image = decodeImage(checked->bytes, size);
    if (!image)
        return tl::unexpected(image.error());

    const int channels = spec.layerChannels();
    const auto greatest = static_cast<std::uint16_t>(
        spec.texel == TexelKind::Index ? std::max<std::size_t>(spec.palette.size(), 1) - 1 : 65'535);
    DecodedLayer layer{.raster = sim::TiledRaster(size, channels), .ours = checked->onlyOurChunks};
    sim::RasterTilePtr lastUniform = layer.raster.tile(0);
    for (int index = 0; index < layer.raster.tileCount(); ++index) {
        const sim::TexelRect rect = layer.raster.tileRect(index);
        auto tile = std::make_shared<sim::RasterTile>();
        tile->pixels.resize(static_cast<std::size_t>(kTile) * kTile * static_cast<std::size_t>(channels));
        for (int y = 0; y < kTile; ++y) {
            const auto* rgba =
                reinterpret_cast<const quint16*>(image->constScanLine(rect.y0 + y)) + std::ptrdiff_t{4} * rect.x0;
            std::uint16_t* row = tile->pixels.data() + std::ptrdiff_t{y} * kTile * channels;
            const bool rowIsOurs = takeRow(rgba, row, kTile, channels, greatest);
            layer.ours = layer.ours && rowIsOurs;
        }
        if (isUniform(tile->pixels, static_cast<std::size_t>(channels))) {
            sim::Texel value{};
            std::copy_n(tile->pixels.begin(), channels, value.begin());
            if (lastUniform->uniform != value) {
                auto uniform = std::make_shared<sim::RasterTile>();
                uniform->uniform = value;
                lastUniform = std::move(uniform);
            }
            layer.raster.setTile(index, lastUniform);
        } else {
            layer.raster.setTile(index, std::move(tile));
        }
    }
    return layer;
}

} // namespace hairpaint::model
