// Records to content: see the header.
#include "model/journal/journal_reader.h"

#include "model/disk/own_folder.h"
#include "model/files/head_file.h"
#include "model/files/own_mesh_file.h"
#include "model/files/project_json.h"
#include "model/journal/journal_format.h"
#include "model/journal/journal_records.h"
#include "model/project/content_budget.h"

#include <QFile>
#include <QFileInfo>
#include <QtEndian>

#include <iterator>
#include <map>
#include <memory>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr qsizetype kMostMeshBytes = qsizetype{192} << 20;
/// Limit on the bytes kept about states while the file is read; beyond it the oldest states are forgotten.
constexpr std::size_t kMostKnownBytes = std::size_t{256} << 20U;
constexpr qsizetype kMostTileBytes = sim::kTileTexels * 4 * sizeof(std::uint16_t);

using Table = std::shared_ptr<const QByteArray>;

/// Where a state stands in the file, with the tables that were in force there.
struct FoundState
{
    qint64 at = 0;
    std::map<Id, Table> tables = {};
    std::size_t bytes = 0; ///< Bytes that this state alone keeps.
};

/// Walks the records, and makes content of the states that turn out to count. What a record holds is read where it is
/// needed: a few bytes can stand for many.
class Scan
{
public:
    Scan(QIODevice& file, std::size_t mostBytes) : m_file(file), m_mostBytes(mostBytes) {}

    [[nodiscard]] bool walk(const Progress& progress)
    {
        const std::optional<JournalRecord> start = nextRecord(m_file);
        if (!start || start->kind != RecordKind::Start || !isJournalStart(start->payload))
            return true; // Nothing of ours.
        for (qint64 at = m_file.pos();; at = m_file.pos()) {
            const std::optional<JournalRecord> record = nextRecord(m_file);
            if (!record)
                return true;
            if (progress && !progress(0.5 * static_cast<double>(m_file.pos()) / static_cast<double>(m_file.size())))
                return false;
            if (record->kind == RecordKind::Tile)
                m_tiles.push_back({.at = at});
            else if (record->kind == RecordKind::Head)
                m_heads.push_back({.at = at});
            else if (record->kind == RecordKind::OwnMesh)
                m_ownMeshes.push_back({.at = at});
            else if (record->kind == RecordKind::Clean)
                m_clean = true;
            else if (record->kind == RecordKind::State && !take(record->payload, at))
                return true; // Damaged: what stands before it counts.
        }
    }

    [[nodiscard]] bool hasWork() const { return !m_clean && m_current.has_value(); }

    /// None where cancelled; without steps where not even the last one can be made.
    [[nodiscard]] std::optional<RecoveredWork> build(const Progress& progress)
    {
        RecoveredWork work;
        const int current = *m_current;
        if (std::optional<JournalState> state = stateOf(m_states.at(current)))
            work.steps.push_back(std::move(*state));
        else
            return work;
        // Neighbours of the last one, as far as there is no gap and there is room: those that undo leads to first.
        std::vector<JournalState> before;
        const auto told = [&](std::size_t made) {
            return !progress || progress(0.5 + 0.5 * static_cast<double>(made) / static_cast<double>(m_states.size()));
        };
        for (auto at = m_states.find(current - 1); at != m_states.end(); at = m_states.find(at->first - 1)) {
            if (!told(before.size()))
                return std::nullopt;
            std::optional<JournalState> state = stateOf(at->second);
            if (!state)
                break;
            before.push_back(std::move(*state));
        }
        work.current = before.size();
        for (auto at = m_states.find(current + 1); at != m_states.end(); at = m_states.find(at->first + 1)) {
            if (!told(before.size() + work.steps.size()))
                return std::nullopt;
            std::optional<JournalState> state = stateOf(at->second);
            if (!state)
                break;
            work.steps.push_back(std::move(*state));
        }
        work.steps.insert(work.steps.begin(), std::make_move_iterator(before.rbegin()),
                          std::make_move_iterator(before.rend()));
        return work;
    }

private:
    struct Tile
    {
        qint64 at = 0;
        sim::RasterTilePtr tile = {}; ///< Once it was needed.
        int channels = 0;
    };
    struct SourceHead
    {
        qint64 at = 0;
        std::shared_ptr<const Head> head = {};
    };

    struct FoundMesh
    {
        qint64 at = 0;
        std::shared_ptr<const OwnMesh> mesh = {};
    };

    bool take(const QByteArray& payload, qint64 at)
    {
        std::optional<StateFields> fields = stateFields(payload);
        if (!fields)
            return false;
        FoundState found{.at = at};
        for (auto& [layer, table] : fields->tables) {
            Table& known = m_tables[layer];
            m_tableBytes +=
                static_cast<std::size_t>(table.size()) - static_cast<std::size_t>(known ? known->size() : 0);
            found.bytes += static_cast<std::size_t>(table.size());
            known = std::make_shared<const QByteArray>(std::move(table));
        }
        constexpr std::size_t kEntryBytes = 64;
        found.bytes += (m_tables.size() + 4) * kEntryBytes;
        if (fields->count == 0)
            forget(m_states.begin(), m_states.end());
        forget(m_states.lower_bound(fields->index), m_states.upper_bound(fields->index));
        forget(m_states.upper_bound(fields->count), m_states.end());
        m_current = fields->index;
        m_clean = false;
        found.tables = m_tables;
        m_knownBytes += found.bytes;
        m_states[fields->index] = std::move(found);
        while (m_knownBytes > kMostKnownBytes && m_states.begin()->first < *m_current)
            forget(m_states.begin(), std::next(m_states.begin()));
        return m_knownBytes <= kMostKnownBytes && m_tableBytes <= kMostKnownBytes;
    }

    void forget(std::map<int, FoundState>::iterator from, std::map<int, FoundState>::iterator to)
    {
        for (auto at = from; at != to; ++at)
            m_knownBytes -= at->second.bytes;
        m_states.erase(from, to);
    }

    /// None where the file is another one by now.
    [[nodiscard]] std::optional<JournalRecord> recordAt(qint64 at, RecordKind kind)
    {
        if (!m_file.seek(at))
            return std::nullopt;
        std::optional<JournalRecord> record = nextRecord(m_file);
        return record && record->kind == kind ? std::move(record) : std::nullopt;
    }

    /// Whether there is room for it.
    [[nodiscard]] bool hold(std::size_t bytes)
    {
        m_builtBytes += bytes;
        return m_builtBytes <= m_mostBytes;
    }

    sim::RasterTilePtr tileOf(std::uint32_t number, int channels)
    {
        if (number >= m_tiles.size())
            return nullptr;
        Tile& found = m_tiles[number];
        if (found.tile)
            return found.channels == channels ? found.tile : nullptr;
        const std::optional<JournalRecord> record = recordAt(found.at, RecordKind::Tile);
        const QByteArray packed = record ? record->payload : QByteArray();
        if (packed.size() < 2 || packed[0] != channels)
            return nullptr;
        auto tile = std::make_shared<sim::RasterTile>();
        const QByteArrayView body = QByteArrayView(packed).sliced(2);
        std::size_t values = 0;
        if (packed[1] != 0) {
            if (body.size() != static_cast<qsizetype>(sizeof(sim::Texel)))
                return nullptr;
            qFromLittleEndian<quint16>(body.data(), static_cast<qsizetype>(tile->uniform.size()), tile->uniform.data());
        } else {
            const std::optional<QByteArray> bytes = unpackedPayload(body, kMostTileBytes);
            values = sim::kTileTexels * static_cast<std::size_t>(channels);
            if (!bytes || static_cast<std::size_t>(bytes->size()) != values * sizeof(std::uint16_t))
                return nullptr;
            tile->pixels.resize(values);
            qFromLittleEndian<quint16>(bytes->constData(), static_cast<qsizetype>(values), tile->pixels.data());
        }
        if (!hold(sizeof(sim::RasterTile) + values * sizeof(std::uint16_t)))
            return nullptr;
        found.channels = channels;
        found.tile = std::move(tile);
        return found.tile;
    }

    std::shared_ptr<const Head> headOf(const HeadReference& reference, int number)
    {
        if (reference.builtIn) {
            const Checked<std::shared_ptr<const Head>> head = builtInHead(reference.name);
            return head ? *head : nullptr;
        }
        if (number < 0 || static_cast<std::size_t>(number) >= m_heads.size())
            return nullptr;
        SourceHead& found = m_heads[static_cast<std::size_t>(number)];
        if (!found.head) {
            const std::optional<JournalRecord> record = recordAt(found.at, RecordKind::Head);
            const std::optional<QByteArray> glb =
                record ? unpackedPayload(record->payload, kMostMeshBytes) : std::optional<QByteArray>();
            if (!glb || !hold(static_cast<std::size_t>(glb->size())))
                return nullptr;
            const Checked<std::shared_ptr<const Head>> head =
                headFromGlb(reference.name, *glb, reference.unitScale, reference.upAxis, {}, reference.landmarks);
            if (!head)
                return nullptr;
            found.head = *head;
        }
        return found.head;
    }

    /// Puts the mesh of that record there; false where it can't be had.
    bool fill(Worn& worn, const std::vector<int>& numbers)
    {
        if (worn.ownMesh.own == nullptr)
            return true;
        const auto entry = static_cast<std::size_t>(worn.ownMesh.own->entry);
        if (entry < 1 || entry > numbers.size())
            return false;
        const auto number = static_cast<std::size_t>(numbers[entry - 1]);
        if (number >= m_ownMeshes.size()) // Negative ones, too.
            return false;
        FoundMesh& found = m_ownMeshes[number];
        if (!found.mesh) {
            const std::optional<JournalRecord> record = recordAt(found.at, RecordKind::OwnMesh);
            const std::optional<QByteArray> glb =
                record ? unpackedPayload(record->payload, kMostOwnMeshBytes) : std::optional<QByteArray>();
            constexpr std::size_t kMeshesOfIt = 3; // As bytes, as a mesh and as its mirror image.
            if (!glb || !hold(kMeshesOfIt * static_cast<std::size_t>(glb->size())))
                return false;
            const Checked<std::shared_ptr<const OwnMesh>> mesh = ownMeshFromGlb(worn.ownMesh.own->name, *glb);
            if (!mesh)
                return false;
            found.mesh = *mesh;
        }
        worn.ownMesh.own = found.mesh;
        return true;
    }

    bool fill(Layer& layer, int size, int channels, const FoundState& from)
    {
        const auto table = from.tables.find(layer.id);
        sim::TiledRaster raster(size, channels);
        if (table == from.tables.end() || table->second->size() != raster.tileCount() * kTableEntryBytes ||
            !hold(static_cast<std::size_t>(raster.tileCount()) * sizeof(sim::RasterTilePtr)))
            return false;
        for (int i = 0; i < raster.tileCount(); ++i) {
            const auto number =
                qFromLittleEndian<quint32>(table->second->constData() + static_cast<qsizetype>(i) * kTableEntryBytes);
            sim::RasterTilePtr tile = tileOf(number, channels);
            if (!tile)
                return false;
            raster.setTile(i, std::move(tile));
        }
        layer.raster = std::move(raster);
        return true;
    }

    std::optional<JournalState> stateOf(const FoundState& from)
    {
        const std::optional<JournalRecord> record = recordAt(from.at, RecordKind::State);
        std::optional<StateFields> fields = record ? stateFields(record->payload) : std::nullopt;
        if (!fields)
            return std::nullopt;
        Checked<ProjectManifest> manifest = projectFromJson(fields->project);
        if (!manifest)
            return std::nullopt;
        JournalState state;
        state.project = std::move(manifest->project);
        state.project.head = headOf(manifest->head, fields->head);
        if (!state.project.head)
            return std::nullopt;
        for (Worn& worn : state.project.worn)
            if (!fill(worn, fields->ownMeshes))
                return std::nullopt;
        for (HairGroup& group : state.project.groups) {
            for (SharedStack& shared : group.maps) {
                MapStack& stack = shared.write();
                const int channels = mapSpec(stack.kind).layerChannels();
                for (Layer& layer : stack.layers)
                    if (!fill(layer, stack.size, channels, from))
                        return std::nullopt;
            }
        }
        state.path = fields->path;
        state.file = {.bytes = fields->fileBytes, .timeMs = fields->fileTimeMs};
        state.step = fields->step;
        state.index = fields->index;
        state.count = fields->count;
        state.timeMs = fields->timeMs;
        return state;
    }

    QIODevice& m_file;
    std::vector<Tile> m_tiles;
    std::vector<SourceHead> m_heads;
    std::vector<FoundMesh> m_ownMeshes;
    std::map<Id, Table> m_tables;
    std::map<int, FoundState> m_states; ///< States of the undo history that is being read, by their index in it.
    std::optional<int> m_current;
    bool m_clean = false;
    std::size_t m_knownBytes = 0;
    std::size_t m_tableBytes = 0; ///< Bytes of the tables in m_tables.
    std::size_t m_builtBytes = 0;
    std::size_t m_mostBytes; ///< Limit on m_builtBytes.
};

Result<std::optional<RecoveredWork>> read(const OwnFolder& folder, const QString& name, const Progress& progress,
                                          std::size_t mostBytes)
{
    const QString path = folder.pathOf(name);
    QFile file;
    if (!folder.openToRead(file, name))
        return cannotOpen(path, {.text = folder.problem(), .cure = Clause::Cure::OtherFile});
    Scan scan(file, mostBytes);
    if (!scan.walk(progress))
        return cancelled(path);
    if (!scan.hasWork())
        return std::optional<RecoveredWork>();
    std::optional<RecoveredWork> work = scan.build(progress);
    if (!work)
        return cancelled(path);
    if (work->steps.empty())
        return cannotOpen(path, {.text = say(QT_TRANSLATE_NOOP("Files", "what it holds is damaged"))});
    return work;
}

} // namespace

Result<std::optional<RecoveredWork>> readJournal(const OwnFolder& folder, const QString& name, const Progress& progress,
                                                 std::size_t mostBytes)
{
    return withinMemory(folder.pathOf(name), cannotOpen, [&] { return read(folder, name, progress, mostBytes); });
}

Result<std::optional<RecoveredWork>> readJournal(const QString& path, const Progress& progress)
{
    const QFileInfo named(path);
    const std::optional<OwnFolder> folder = OwnFolder::open(named.path());
    if (!folder)
        return cannotOpen(path, {.text = say(QT_TRANSLATE_NOOP("Files", "there is no such file; check the name and the "
                                                                        "folder")),
                                 .cure = Clause::Cure::OtherFile});
    return readJournal(*folder, named.fileName(), progress);
}

} // namespace hairpaint::model
