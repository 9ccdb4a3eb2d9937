// Images of layers and thumbnails: what decodes encodes to texels that are equal, and salvaging it loses nothing.
#include "model/files/png_codec.h"
#include "model/files/png_reader.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/model/archive_maker.h"

using namespace hairpaint;

namespace {

constexpr int kSize = 256;

/// So that fuzzing gets past them.
void mendChecksums(QByteArray& png)
{
    for (qsizetype at = 8; at + 12 <= png.size();) {
        const qint64 length = qFromBigEndian<quint32>(png.constData() + at);
        if (length > png.size() - at - 12)
            return;
        qToBigEndian(test::crcOf(png.sliced(at + 4, length + 4)), png.data() + at + 8 + length);
        at += 12 + length;
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const bool isMended = input.byte() % 4 != 0;
    const model::MapSpec& spec = model::mapSpecs()[static_cast<std::size_t>(input.byte() % model::kMapKindCount)];
    QByteArray png = input.rest();
    if (isMended)
        mendChecksums(png);
    (void)model::decodePicture(png, 64);
    const model::SalvagedLayer left = model::salvageLayer(png, spec, kSize);
    fuzz::require(left.rows >= 0 && left.rows <= kSize);
    const model::Checked<model::DecodedLayer> layer = model::decodeLayer(png, spec, kSize);
    if (!layer)
        return 0;
    fuzz::require(left.rows == kSize && left.raster == layer->raster);
    const QByteArray encoded = model::encodeLayer(layer->raster).bytes;
    const model::Checked<model::DecodedLayer> again = model::decodeLayer(encoded, spec, kSize);
    fuzz::require(again && again->raster == layer->raster && again->ours);
    return 0;
}
