// The chunks of a binary glTF of ours, and its accessors: see "head.glb" in model/files/hairpaint_format.md.
// Any thread. Every index and size is checked before it is used.
#pragma once

#include <QByteArray>
#include <QByteArrayView>
#include <QJsonArray>
#include <QJsonObject>
#include <QtEndian>

#include <bit>
#include <cstring>
#include <optional>
#include <vector>

namespace hairpaint::model {

inline constexpr quint32 kMagic = 0x46546C67;     // "glTF"
inline constexpr quint32 kJsonChunk = 0x4E4F534A; // "JSON"
inline constexpr quint32 kBinChunk = 0x004E4942;  // "BIN\0"
inline constexpr int kFloat = 5126;
inline constexpr int kUnsignedInt = 5125;
inline constexpr int kUnsignedShort = 5123;
inline constexpr int kArrayBuffer = 34962;
inline constexpr int kElementArrayBuffer = 34963;
inline constexpr int kNoTarget = 0;
inline constexpr quint32 kMostJsonChunkBytes = 1U << 22U;
static_assert(std::endian::native == std::endian::little, "arrays are copied as they lie in memory");

[[nodiscard]] inline quint32 glbWord(const QByteArray& bytes, qsizetype at)
{
    return qFromLittleEndian<quint32>(bytes.constData() + at);
}

/// The two chunks of a checked container.
struct GlbContainer
{
    QJsonObject json;
    QByteArrayView bin;
    [[nodiscard]] QJsonArray list(QLatin1StringView name) const { return json.value(name).toArray(); }
};

/// `glb` must outlive it; none where it is no such container.
[[nodiscard]] std::optional<GlbContainer> openGlb(const QByteArray& glb);

[[nodiscard]] inline qint64 wholeNumber(const QJsonValue& value, qint64 absent)
{
    return value.isUndefined() ? absent : value.toInteger(-1);
}

/// The bytes of a buffer view without a stride; none where it is not as our subset has it.
[[nodiscard]] std::optional<QByteArrayView> glbView(const GlbContainer& container, qint64 number);

/// Copies an accessor's elements; none where anything about it is not as our subset has it.
template<typename Element>
[[nodiscard]] std::optional<std::vector<Element>> readAccessor(const GlbContainer& container, const QJsonValue& index,
                                                               const QString& type, int componentType, qint64 most)
{
    const QJsonArray accessors = container.json.value(QLatin1String("accessors")).toArray();
    const qint64 number = wholeNumber(index, -1);
    if (number < 0 || number >= accessors.size())
        return std::nullopt;
    const QJsonObject accessor = accessors.at(number).toObject();
    const qint64 viewNumber = wholeNumber(accessor.value(QLatin1String("bufferView")), -1);
    const qint64 count = wholeNumber(accessor.value(QLatin1String("count")), -1);
    if (accessor.value(QLatin1String("type")).toString() != type ||
        accessor.value(QLatin1String("componentType")).toInt() != componentType || count < 1 || count > most ||
        wholeNumber(accessor.value(QLatin1String("byteOffset")), 0) != 0 || accessor.contains(QLatin1String("sparse")))
        return std::nullopt;
    const std::optional<QByteArrayView> bytes = glbView(container, viewNumber);
    const qint64 length = count * static_cast<qint64>(sizeof(Element));
    if (!bytes || bytes->size() != length)
        return std::nullopt;
    std::vector<Element> elements(static_cast<std::size_t>(count));
    std::memcpy(elements.data(), bytes->data(), static_cast<std::size_t>(length));
    return elements;
}

} // namespace hairpaint::model
