// Writes a journal: after each edit what is new in the content, so that a crash loses nothing.
#pragma once

#include "model/disk/own_folder.h"
#include "model/document/journal_state.h"
#include "model/journal/journal_records.h"
#include "model/values/sentences.h"

#include <QFile>

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

namespace hairpaint::model {

/// One journal in one file. A state costs the tiles that no state before it had (told by identity, copies of a project
/// share them) and a list of tiles for each layer that differs. Where the file has become much larger than what its
/// last states hold, it is written anew. One thread. Errors: clauses for cannotWrite; after one nothing can be appended
/// any more, and the file still holds what it held.
class JournalWriter
{
public:
    /// A file is written anew once it is larger than this and than `kLiveFactor` times its size after the last time.
    static constexpr qint64 kLeastRewriteBytes = 64 << 20;
    static constexpr qint64 kLiveFactor = 3;
    static constexpr std::size_t kKeptStates = 24; ///< Number of states that a file written anew has.

    /// `states`: earlier states of this undo history, however many; they are written first. Follows no link.
    JournalWriter(std::shared_ptr<const OwnFolder> folder, QString name, std::deque<JournalState> states = {},
                  qint64 leastRewriteBytes = kLeastRewriteBytes);
    explicit JournalWriter(const QString& path, qint64 leastRewriteBytes = kLeastRewriteBytes);

    /// Adds `state` to `states` as append() does; states of a former history and the oldest beyond kKeptStates go.
    static void keep(std::deque<JournalState>& states, const JournalState& state);

    /// The state is on the disk when this returns.
    [[nodiscard]] Checked<void> append(const JournalState& state);
    /// Records that the last state is in the project's file, too. Does nothing before the first state.
    [[nodiscard]] Checked<void> markClean();

    /// Writes all states that it still keeps into a new file.
    [[nodiscard]] Checked<void> writeAnew();
    [[nodiscard]] std::deque<JournalState> takeStates() { return std::move(m_states); }

    [[nodiscard]] bool isClean() const { return m_clean; }
    /// Whether the file that it writes is still the one at its path.
    [[nodiscard]] bool isAtPath() const;
    [[nodiscard]] qint64 bytesInFile() const { return m_bytes; }

private:
    /// A tile that was written, told by identity; it is not kept alive.
    struct KnownTile
    {
        std::weak_ptr<const sim::RasterTile> tile;
        std::uint32_t number = 0;
    };

    [[nodiscard]] Checked<void> start(QFile& file);
    [[nodiscard]] Checked<void> write(QFile& file, const JournalState& state);
    [[nodiscard]] Checked<void> rewrite();
    [[nodiscard]] std::uint32_t numberOf(const sim::RasterTilePtr& tile, int channels, QByteArray& records);
    [[nodiscard]] int ownMeshNumberOf(const std::shared_ptr<const OwnMesh>& mesh, QByteArray& records);
    [[nodiscard]] int headNumberOf(const std::shared_ptr<const Head>& head, QByteArray& records);
    [[nodiscard]] QByteArray tableOf(const Layer& layer, QByteArray& records);
    [[nodiscard]] Checked<void> put(QFile& file, QByteArrayView bytes);
    void forget();
    [[nodiscard]] QString besideName() const; ///< Name of the new file that replaces the journal once it is complete.

    std::shared_ptr<const OwnFolder> m_folder; ///< Null where the folder did not exist.
    QString m_name;
    qint64 m_leastRewriteBytes;
    std::unique_ptr<QFile> m_file;
    std::unordered_map<const sim::RasterTile*, KnownTile> m_tiles;
    std::uint32_t m_tileCount = 0;
    std::map<Id, QByteArray> m_tables; ///< By layer, its table of tiles as it was written last.
    std::vector<std::shared_ptr<const Head>> m_heads;
    std::vector<std::shared_ptr<const OwnMesh>> m_ownMeshes;
    std::deque<JournalState> m_states; ///< The newest states that were appended.
    qint64 m_bytes = 0;
    qint64 m_rewrittenBytes = 0; ///< Size of the file when it was last written anew.
    bool m_clean = true;
    bool m_failed = false;
};

} // namespace hairpaint::model
