// Map, rectangle, size, the group's settings as JSON, texels deflated. Whoever else writes this format is not believed:
// every size is checked before memory is taken.
#include "app/window/clip_data.h"

#include "model/files/group_json.h"
#include "model/maps/texel_ops.h"

#include <QDataStream>
#include <QIODevice>
#include <QJsonArray>
#include <QJsonDocument>
#include <QtEndian>

#include <algorithm>
#include <cmath>

namespace hairpaint::app {

namespace {

constexpr quint32 kClipVersion = 1;
constexpr int kMostSide = sim::TiledRaster::kLargestSize;
constexpr qsizetype kMostTexelBytes = qsizetype{1} << 28;

/// The JSON of a group that has these settings and nothing else.
QByteArray settingsText(const sim::GroupSettings& settings)
{
    model::Project project;
    model::HairGroup group = model::makeGroup(project, QStringLiteral("clip"), sim::TiledRaster::kSmallestSize);
    group.settings = settings;
    return QJsonDocument(model::groupsToJson({group})).toJson(QJsonDocument::Compact);
}

std::optional<sim::GroupSettings> settingsFrom(const QByteArray& text)
{
    const model::Checked<std::vector<model::HairGroup>> groups =
        model::groupsFromJson(QJsonDocument::fromJson(text).array(), model::kGreatestNextId);
    if (!groups || groups->size() != 1)
        return std::nullopt;
    return groups->front().settings;
}

bool isRectangle(const QRectF& rect)
{
    return std::isfinite(rect.x()) && std::isfinite(rect.y()) && rect.width() > 0.0 && rect.height() > 0.0 &&
           rect.left() >= -1.0 && rect.top() >= -1.0 && rect.right() <= 2.0 && rect.bottom() <= 2.0;
}

} // namespace

QByteArray bytesFromClip(const model::Clip& clip)
{
    const auto channels = static_cast<std::size_t>(model::mapSpec(clip.map).layerChannels());
    if (clip.texels.empty() ||
        clip.texels.size() * channels * sizeof(quint16) > static_cast<std::size_t>(kMostTexelBytes))
        return {};
    QByteArray texels;
    texels.reserve(static_cast<qsizetype>(clip.texels.size() * channels * sizeof(quint16)));
    for (const sim::Texel& texel : clip.texels)
        texels.append(reinterpret_cast<const char*>(texel.data()), static_cast<qsizetype>(channels * sizeof(quint16)));
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_6_4);
    stream << kClipVersion << QByteArray(model::mapSpec(clip.map).id) << clip.uvRect << qint32{clip.width}
           << qint32{clip.height} << (clip.settings ? settingsText(*clip.settings) : QByteArray())
           << qCompress(texels, 1);
    return bytes;
}

std::optional<model::Clip> clipFromBytes(const QByteArray& bytes)
{
    QDataStream stream(bytes);
    stream.setVersion(QDataStream::Qt_6_4);
    quint32 version = 0;
    QByteArray map;
    model::Clip clip;
    qint32 width = 0;
    qint32 height = 0;
    QByteArray settings;
    QByteArray packed;
    stream >> version;
    if (version != kClipVersion)
        return std::nullopt;
    stream >> map >> clip.uvRect >> width >> height >> settings >> packed;
    const model::MapSpec* spec = model::findMapSpec(QString::fromLatin1(map));
    if (stream.status() != QDataStream::Ok || spec == nullptr || !isRectangle(clip.uvRect) || width < 1 || height < 1 ||
        width > kMostSide || height > kMostSide || packed.size() < 4)
        return std::nullopt;
    const auto channels = static_cast<std::size_t>(spec->layerChannels());
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::size_t wanted = count * channels * sizeof(quint16);
    const auto told = static_cast<std::size_t>(qFromBigEndian<quint32>(packed.constData()));
    if (wanted > static_cast<std::size_t>(kMostTexelBytes) || told != wanted)
        return std::nullopt;
    const QByteArray texels = qUncompress(packed);
    if (static_cast<std::size_t>(texels.size()) != wanted)
        return std::nullopt;
    clip.map = spec->kind;
    clip.width = width;
    clip.height = height;
    clip.settings = settingsFrom(settings);
    clip.texels.resize(count);
    const std::uint16_t greatest = model::texelOps(*spec).greatest(*spec);
    const char* at = texels.constData();
    for (sim::Texel& texel : clip.texels) {
        std::copy_n(at, channels * sizeof(quint16), reinterpret_cast<char*>(texel.data()));
        at += channels * sizeof(quint16);
        for (std::size_t i = 0; i + 1 < channels; ++i)
            texel[i] = std::min(texel[i], greatest);
    }
    return clip;
}

} // namespace hairpaint::app
