// Payloads of a journal's records.
#include "model/journal/journal_format.h"

#include "model/files/project_json.h"

#include <QCborArray>
#include <QCborMap>
#include <QCborValue>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>

#include <algorithm>
#include <new>

namespace hairpaint::model {

namespace {

constexpr int kJournalVersion = 1;
constexpr qsizetype kMostStateBytes = qsizetype{32} << 20; ///< Tables and project.json have at most 4 MB each.
constexpr qsizetype kMostPathLetters = 32767;              ///< The longest path that any supported system allows.
constexpr qsizetype kMostStepLetters = 1000;
constexpr qint64 kLastMs = 253'402'300'799'000; ///< The last second of the year 9999, UTC.
const QString kJournalFormat = QStringLiteral("hairpaint journal");

} // namespace

QByteArray journalStart()
{
    return QJsonDocument(
               QJsonObject{{QStringLiteral("format"), kJournalFormat}, {QStringLiteral("version"), kJournalVersion}})
        .toJson(QJsonDocument::Compact);
}

bool isJournalStart(const QByteArray& payload)
{
    const QJsonObject start = QJsonDocument::fromJson(payload).object();
    return start.value(QStringLiteral("format")).toString() == kJournalFormat &&
           start.value(QStringLiteral("version")).toInt() == kJournalVersion;
}

QByteArray statePayload(const StateFields& fields)
{
    QCborMap tables;
    for (const auto& [layer, table] : fields.tables)
        tables.insert(layer, table);
    QCborArray ownMeshes;
    for (const int number : fields.ownMeshes)
        ownMeshes.append(number);
    const QCborMap map{{QStringLiteral("project"), fields.project},    {QStringLiteral("head"), fields.head},
                       {QStringLiteral("ownMeshes"), ownMeshes},       {QStringLiteral("tables"), tables},
                       {QStringLiteral("path"), fields.path},          {QStringLiteral("step"), fields.step},
                       {QStringLiteral("index"), fields.index},        {QStringLiteral("count"), fields.count},
                       {QStringLiteral("time"), fields.timeMs},        {QStringLiteral("fileBytes"), fields.fileBytes},
                       {QStringLiteral("fileTime"), fields.fileTimeMs}};
    return packedPayload(QCborValue(map).toCbor());
}

std::optional<StateFields> stateFields(const QByteArray& payload)
{
    const std::optional<QByteArray> cbor = unpackedPayload(payload, kMostStateBytes);
    if (!cbor)
        return std::nullopt;
    const QCborMap map = QCborValue::fromCbor(*cbor).toMap();
    StateFields fields;
    fields.project = map.value(QStringLiteral("project")).toByteArray();
    if (fields.project.isEmpty() || fields.project.size() > kMostJsonBytes)
        return std::nullopt;
    fields.head = static_cast<int>(map.value(QStringLiteral("head")).toInteger(kBuiltInHead));
    const QCborArray ownMeshes = map.value(QStringLiteral("ownMeshes")).toArray();
    for (const QCborValueConstRef number : ownMeshes)
        fields.ownMeshes.push_back(static_cast<int>(number.toInteger(-1)));
    for (const auto& [layer, table] : map.value(QStringLiteral("tables")).toMap())
        fields.tables[static_cast<Id>(layer.toInteger())] = table.toByteArray();
    // A path that is too long is dropped and a step's name is cut: the content can be recovered all the same.
    if (fields.path = map.value(QStringLiteral("path")).toString(); fields.path.size() > kMostPathLetters)
        fields.path.clear();
    fields.step = map.value(QStringLiteral("step")).toString();
    fields.step.truncate(kMostStepLetters);
    fields.index = static_cast<int>(map.value(QStringLiteral("index")).toInteger());
    fields.count = static_cast<int>(map.value(QStringLiteral("count")).toInteger());
    fields.timeMs = std::clamp(map.value(QStringLiteral("time")).toInteger(), qint64{0}, kLastMs);
    fields.fileBytes = std::max(map.value(QStringLiteral("fileBytes")).toInteger(-1), qint64{-1});
    fields.fileTimeMs = std::clamp(map.value(QStringLiteral("fileTime")).toInteger(), -kLastMs, kLastMs);
    if (fields.index < 0 || fields.index > fields.count)
        return std::nullopt;
    return fields;
}

QByteArray packedPayload(const QByteArray& bytes)
{
    constexpr int kFastest = 1; // of zlib's levels
    QByteArray compressed = qCompress(bytes, kFastest);
    if (compressed.isEmpty()) // So it tells of want of memory.
        throw std::bad_alloc();
    return compressed;
}

std::optional<QByteArray> unpackedPayload(QByteArrayView bytes, qsizetype mostBytes)
{
    constexpr qsizetype kSizeBytes = 4; // which qCompress puts first
    if (bytes.size() < kSizeBytes || qFromBigEndian<quint32>(bytes.data()) > static_cast<quint64>(mostBytes))
        return std::nullopt;
    QByteArray whole = qUncompress(reinterpret_cast<const uchar*>(bytes.data()), bytes.size());
    if (whole.isEmpty() || whole.size() > mostBytes)
        return std::nullopt;
    return whole;
}

} // namespace hairpaint::model
