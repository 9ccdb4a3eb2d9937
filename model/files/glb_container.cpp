// Opening containers.
#include "model/files/glb_container.h"

#include <QJsonDocument>

namespace hairpaint::model {

std::optional<GlbContainer> openGlb(const QByteArray& glb)
{
    if (glb.size() < 28 || glbWord(glb, 0) != kMagic || glbWord(glb, 4) != 2 || glbWord(glb, 8) != glb.size())
        return std::nullopt;
    const quint32 jsonBytes = glbWord(glb, 12);
    if (glbWord(glb, 16) != kJsonChunk || jsonBytes > kMostJsonChunkBytes || jsonBytes % 4 != 0 ||
        glb.size() - 28 < jsonBytes)
        return std::nullopt;
    const qsizetype binAt = 20 + static_cast<qsizetype>(jsonBytes);
    const quint32 binBytes = glbWord(glb, binAt);
    if (glbWord(glb, binAt + 4) != kBinChunk || glb.size() - binAt - 8 < binBytes)
        return std::nullopt;
    const QJsonDocument document = QJsonDocument::fromJson(glb.sliced(20, jsonBytes));
    if (!document.isObject())
        return std::nullopt;
    return GlbContainer{.json = document.object(), .bin = QByteArrayView(glb).sliced(binAt + 8, binBytes)};
}

std::optional<QByteArrayView> glbView(const GlbContainer& container, qint64 number)
{
    const QJsonArray views = container.list(QLatin1StringView("bufferViews"));
    if (number < 0 || number >= views.size())
        return std::nullopt;
    const QJsonObject view = views.at(number).toObject();
    const qint64 offset = wholeNumber(view.value(QLatin1String("byteOffset")), 0);
    const qint64 length = wholeNumber(view.value(QLatin1String("byteLength")), -1);
    if (wholeNumber(view.value(QLatin1String("buffer")), 0) != 0 || view.contains(QLatin1String("byteStride")) ||
        offset < 0 || offset > container.bin.size() || length < 0 || length > container.bin.size() - offset)
        return std::nullopt;
    return container.bin.sliced(offset, length);
}

} // namespace hairpaint::model
