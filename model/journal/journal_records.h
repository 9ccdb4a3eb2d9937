// The records of a journal's file: appended one after the other, each with its length and checksum, so that whatever
// stands before the byte at which a crash cut the file is whole.
#pragma once

#include <QByteArray>
#include <QIODevice>

#include <cstdint>
#include <optional>

namespace hairpaint::model {

enum class RecordKind : std::uint32_t
{
    Start = 1,  ///< Version of the format of what follows.
    Tile = 2,   ///< One tile's texels; tiles are numbered from 0 as they come.
    Head = 3,   ///< An imported head's mesh; numbered likewise.
    State = 4,  ///< The content after one edit, naming tiles and a head by number.
    Clean = 5,  ///< What the last state holds is also in the project's file.
    OwnMesh = 6 ///< A mesh that a user brought to be worn; numbered likewise.
};

struct JournalRecord
{
    RecordKind kind = RecordKind::Start;
    QByteArray payload;
};

inline constexpr std::uint32_t kMostRecordBytes = 256U << 20U;

/// Little endian: 4 bytes of mark, kind, payload's size, its CRC-32; then the payload.
[[nodiscard]] QByteArray recordBytes(RecordKind kind, QByteArrayView payload);
/// The next one; none at the end and where the file is cut short or damaged.
[[nodiscard]] std::optional<JournalRecord> nextRecord(QIODevice& file);

} // namespace hairpaint::model
