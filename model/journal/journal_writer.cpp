// Records of what is new: see the header. What a state holds: journal_format.h.
#include "model/journal/journal_writer.h"

#include "model/disk/atomic_file.h"
#include "model/files/project_json.h"
#include "model/files/worn_json.h"
#include "model/journal/journal_format.h"

#include <QFileInfo>
#include <QtEndian>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace hairpaint::model {

namespace {

QByteArray tilePayload(const sim::RasterTile& tile, int channels)
{
    QByteArray payload;
    payload.append(static_cast<char>(channels));
    payload.append(tile.isUniform() ? '\1' : '\0');
    const std::span<const std::uint16_t> values =
        tile.isUniform() ? std::span<const std::uint16_t>(tile.uniform) : std::span<const std::uint16_t>(tile.pixels);
    QByteArray bytes(static_cast<qsizetype>(values.size_bytes()), Qt::Uninitialized);
    qToLittleEndian<quint16>(values.data(), static_cast<qsizetype>(values.size()), bytes.data());
    payload.append(tile.isUniform() ? bytes : packedPayload(bytes));
    return payload;
}

std::shared_ptr<const OwnFolder> folderOf(const QString& path)
{
    std::optional<OwnFolder> folder = OwnFolder::open(path);
    return folder ? std::make_shared<const OwnFolder>(std::move(*folder)) : nullptr;
}

} // namespace

JournalWriter::JournalWriter(std::shared_ptr<const OwnFolder> folder, QString name, std::deque<JournalState> states,
                             qint64 leastRewriteBytes)
    : m_folder(std::move(folder)), m_name(std::move(name)), m_leastRewriteBytes(leastRewriteBytes),
      m_states(std::move(states))
{}

JournalWriter::JournalWriter(const QString& path, qint64 leastRewriteBytes)
    : JournalWriter(folderOf(QFileInfo(path).path()), QFileInfo(path).fileName(), {}, leastRewriteBytes)
{}

bool JournalWriter::isAtPath() const
{
    return m_folder && m_folder->isAtPath() && (!m_file || m_folder->isNamed(*m_file, m_name));
}

void JournalWriter::forget()
{
    m_tiles.clear();
    m_tileCount = 0;
    m_tables.clear();
    m_heads.clear();
    m_ownMeshes.clear();
    m_bytes = 0;
}

Checked<void> JournalWriter::put(QFile& file, QByteArrayView bytes)
{
    m_bytes += bytes.size();
    while (!bytes.isEmpty()) {
        const qint64 written = file.write(bytes.data(), bytes.size());
        if (written <= 0) {
            m_failed = true;
            return refuse(writeProblem(file));
        }
        bytes = bytes.sliced(static_cast<qsizetype>(written));
    }
    return {};
}

Checked<void> JournalWriter::start(QFile& file)
{
    forget();
    if (!m_folder || !m_folder->openNew(file, besideName())) {
        m_failed = true;
        return refuse(m_folder ? m_folder->problem() : writeRefusal(qt_error_string(ENOENT)));
    }
    return put(file, recordBytes(RecordKind::Start, journalStart()));
}

QString JournalWriter::besideName() const
{
    return m_name + QStringLiteral(".new");
}

std::uint32_t JournalWriter::numberOf(const sim::RasterTilePtr& tile, int channels, QByteArray& records)
{
    KnownTile& known = m_tiles[tile.get()];
    if (known.tile.lock() == tile)
        return known.number;
    records += recordBytes(RecordKind::Tile, tilePayload(*tile, channels));
    known = {.tile = tile, .number = m_tileCount++};
    return known.number;
}

int JournalWriter::headNumberOf(const std::shared_ptr<const Head>& head, QByteArray& records)
{
    if (!head || head->builtIn)
        return kBuiltInHead;
    auto known = std::ranges::find(m_heads, head);
    if (known == m_heads.end()) {
        records += recordBytes(RecordKind::Head, packedPayload(head->sourceGlb));
        known = m_heads.insert(m_heads.end(), head);
    }
    return static_cast<int>(known - m_heads.begin());
}

int JournalWriter::ownMeshNumberOf(const std::shared_ptr<const OwnMesh>& mesh, QByteArray& records)
{
    auto known = std::ranges::find(m_ownMeshes, mesh);
    if (known == m_ownMeshes.end()) {
        records += recordBytes(RecordKind::OwnMesh, packedPayload(mesh->glb));
        known = m_ownMeshes.insert(m_ownMeshes.end(), mesh);
    }
    return static_cast<int>(known - m_ownMeshes.begin());
}

QByteArray JournalWriter::tableOf(const Layer& layer, QByteArray& records)
{
    QByteArray table(static_cast<qsizetype>(layer.raster.tileCount()) * kTableEntryBytes, Qt::Uninitialized);
    for (int i = 0; i < layer.raster.tileCount(); ++i)
        qToLittleEndian<quint32>(numberOf(layer.raster.tile(i), layer.raster.channels(), records),
                                 table.data() + static_cast<qsizetype>(i) * kTableEntryBytes);
    return table;
}

Checked<void> JournalWriter::write(QFile& file, const JournalState& state)
{
    Checked<QByteArray> json = projectToJson(state.project);
    if (!json)
        return tl::unexpected(json.error());
    QByteArray records;
    StateFields fields;
    fields.head = headNumberOf(state.project.head, records);
    for (const std::shared_ptr<const OwnMesh>& mesh : ownMeshesOf(state.project.worn))
        fields.ownMeshes.push_back(ownMeshNumberOf(mesh, records));
    std::map<Id, QByteArray> tables;
    for (const HairGroup& group : state.project.groups) {
        for (const MapStack& stack : group.maps) {
            for (const Layer& layer : stack.layers) {
                QByteArray table = tableOf(layer, records);
                const auto before = m_tables.find(layer.id);
                if (before == m_tables.end() || before->second != table)
                    fields.tables[layer.id] = table;
                tables[layer.id] = std::move(table);
            }
        }
    }
    fields.project = *json;
    fields.path = state.path;
    fields.fileBytes = state.file.bytes;
    fields.fileTimeMs = state.file.timeMs;
    fields.step = state.step;
    fields.index = state.index;
    fields.count = state.count;
    fields.timeMs = state.timeMs;
    records += recordBytes(RecordKind::State, statePayload(fields));
    if (Checked<void> done = put(file, records); !done)
        return done;
    m_tables = std::move(tables);
    return {};
}

Checked<void> JournalWriter::rewrite()
{
    // Beside the old one, which counts until the new one is whole.
    auto file = std::make_unique<QFile>();
    Checked<void> written = start(*file);
    for (auto state = m_states.begin(); written && state != m_states.end(); ++state)
        written = write(*file, *state);
    if (written)
        written = flushToDisk(*file);
    if (!written) {
        m_failed = true;
        file->close();
        if (m_folder)
            m_folder->remove(besideName()); // It takes room.
        return written;
    }
#ifndef Q_OS_UNIX
    m_file.reset(); // There what is open can't be renamed.
    file->close();
#endif
    if (!m_folder->rename(besideName(), m_name)) {
        m_failed = true;
        return refuse(say(QT_TRANSLATE_NOOP(
            "Files", "it can't take the place of the one before; close what has that open and try again")));
    }
    m_folder->flush();
#ifndef Q_OS_UNIX
    file->setFileName(m_folder->pathOf(m_name));
    if (!file->open(QIODevice::WriteOnly | QIODevice::Append | QIODevice::Unbuffered)) {
        m_failed = true;
        return refuse(writeRefusal(file->errorString()));
    }
#endif
    m_file = std::move(file);
    m_rewrittenBytes = m_bytes;
    return {};
}

Checked<void> JournalWriter::writeAnew()
{
    Checked<void> written = rewrite();
    if (written || m_states.size() < 2)
        return written;
    // Without the steps before it there may be room; if not, they are for the writer after this one.
    std::deque<JournalState> all{m_states.back()};
    std::swap(all, m_states);
    m_failed = false;
    written = rewrite();
    if (!written)
        std::swap(all, m_states);
    return written;
}

void JournalWriter::keep(std::deque<JournalState>& states, const JournalState& state)
{
    if (state.count == 0)
        states.clear(); // Another project, or a history that was cleared: nothing can be undone.
    states.push_back(state);
    while (states.size() > kKeptStates)
        states.pop_front();
}

Checked<void> JournalWriter::append(const JournalState& state)
{
    if (m_failed)
        return refuse(say(QT_TRANSLATE_NOOP("Files", "an earlier part of it could not be written")));
    keep(m_states, state);
    m_clean = false;
    const bool isLarge = m_file && m_bytes > std::max(m_leastRewriteBytes, kLiveFactor * m_rewrittenBytes);
    if (!m_file || isLarge)
        return writeAnew();
    if (Checked<void> written = write(*m_file, state); !written)
        return written;
    if (Checked<void> lies = flushToDisk(*m_file); !lies) {
        m_failed = true;
        return lies;
    }
    return {};
}

Checked<void> JournalWriter::markClean()
{
    if (m_clean || m_failed || !m_file)
        return {};
    m_clean = true;
    if (Checked<void> written = put(*m_file, recordBytes(RecordKind::Clean, {})); !written)
        return written;
    return flushToDisk(*m_file);
}

} // namespace hairpaint::model
