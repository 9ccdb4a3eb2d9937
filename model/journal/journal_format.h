// What stands in a journal's records, version 1. Ours alone: a journal is read by the program that is started next, and
// one of another version is left as it is.
//
// Start: the JSON object {"format": "hairpaint journal", "version": 1}.
// Tile: one byte of channels, one that is 1 where the tile is uniform; then 4 values of 16 bits, or its texels,
// [64][64][channels], as qCompress packs them. Little endian.
// Head: the source mesh of an imported head (head.glb of hairpaint_format.md), as qCompress packs it.
// OwnMesh: worn/<number>.glb of hairpaint_format.md, likewise.
// State: StateFields as CBOR, as qCompress packs it.
// Clean: nothing.
#pragma once

#include "model/project/change.h"

#include <QByteArray>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace hairpaint::model {

inline constexpr int kBuiltInHead = -1;
inline constexpr qsizetype kTableEntryBytes = 4;

struct StateFields
{
    QByteArray project; ///< project.json of hairpaint_format.md.
    int head = kBuiltInHead;
    std::vector<int> ownMeshes; ///< By their number in project.json, from 1 on: that of the record.
    /// By layer: 4 bytes for each of its tiles, the tile's number. A layer that is missing has those it had before.
    std::map<Id, QByteArray> tables;
    QString path, step;
    /// JournalState::file; -1 and 0 in journals of version 0.1, which lack them.
    qint64 fileBytes = -1, fileTimeMs = 0;
    int index = 0, count = 0;
    qint64 timeMs = 0;
};

[[nodiscard]] QByteArray journalStart();
[[nodiscard]] bool isJournalStart(const QByteArray& payload);
[[nodiscard]] QByteArray statePayload(const StateFields& fields);
/// None where the payload is no valid state.
[[nodiscard]] std::optional<StateFields> stateFields(const QByteArray& payload);
/// Packs at the fastest level, since an undo step waits for it. Throws std::bad_alloc.
[[nodiscard]] QByteArray packedPayload(const QByteArray& bytes);
/// Unpacks what qCompress packed; none where it is broken or claims to hold more than `mostBytes`.
[[nodiscard]] std::optional<QByteArray> unpackedPayload(QByteArrayView bytes, qsizetype mostBytes);

} // namespace hairpaint::model
