// By Qt's PNG writer at its slowest.
#include "slimming.h"

#include "model/files/archive.h"

#include <QBuffer>
#include <QImage>

namespace hairpaint::presets {

namespace {

/// The image in grey where it is opaque and grey throughout, else as it is.
QImage greyIfItIs(const QImage& image)
{
    QImage grey(image.size(), QImage::Format_Grayscale16);
    for (int y = 0; y < image.height(); ++y) {
        const auto* from = reinterpret_cast<const QRgba64*>(image.constScanLine(y));
        auto* to = reinterpret_cast<quint16*>(grey.scanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            const QRgba64 texel = from[x];
            if (!texel.isOpaque() || texel.red() != texel.green() || texel.red() != texel.blue())
                return image;
            to[x] = texel.red();
        }
    }
    return grey;
}

QByteArray slimmed(const QByteArray& png)
{
    constexpr int kSmallest = 0; // Of Qt's qualities of a PNG.
    const QImage image = QImage::fromData(png, "PNG").convertToFormat(QImage::Format_RGBA64);
    QBuffer packed;
    if (image.isNull() || !packed.open(QIODevice::WriteOnly) || !greyIfItIs(image).save(&packed, "PNG", kSmallest))
        return png;
    return packed.data().size() < png.size() ? packed.data() : png;
}

} // namespace

model::Checked<void> slim(const QString& path)
{
    constexpr qint64 kMostBytes = 1 << 28;
    const model::Checked<model::ArchiveReader> from = model::ArchiveReader::open(path);
    if (!from)
        return tl::unexpected(from.error());
    model::ArchiveWriter to;
    for (const QString& name : from->names()) {
        model::Checked<QByteArray> bytes = from->read(name, kMostBytes);
        if (!bytes)
            return tl::unexpected(bytes.error());
        if (name.startsWith(QStringLiteral("groups/")) && name.endsWith(QStringLiteral(".png")))
            bytes = slimmed(*bytes);
        to.add(name.toLatin1(), *bytes,
               name.endsWith(QStringLiteral(".json")) ? model::ArchiveWriter::Method::Deflated
                                                      : model::ArchiveWriter::Method::Stored);
    }
    const model::Checked<bool> written = to.writeTo(path);
    if (!written)
        return tl::unexpected(written.error());
    return {};
}

} // namespace hairpaint::presets
