// Records to content: see the header.
#include "model/journal/journal_reader.h"

#include "model/files/head_file.h"
#include "model/files/project_json.h"
#include "model/journal/journal_format.h"
#include "model/journal/journal_records.h"

#include <QFile>
#include <QtEndian>

#include <map>
#include <memory>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr qsizetype kMostMeshBytes = qsizetype{192} << 20;
constexpr qsizetype kMostTileBytes = sim::kTileTexels * 4 * sizeof(std::uint16_t);

using Table = std::shared_ptr<const QByteArray>;

/// A state as it stands in the file, with the tables that were in force there.
struct FoundState
{
    StateFields fields; ///< Its tables moved out.
    std::map<Id, Table> tables;
};

/// Walks the records, and makes content of the states that turn out to count.
class Scan
{
public:
    explicit Scan(QIODevice& file) : m_file(file) {}

    [[nodiscard]] bool walk(const Progress& progress)
    {
        const std::optional<JournalRecord> start = nextRecord(m_file);
        if (!start || start->kind != RecordKind::Start || !isJournalStart(start->payload))
            return true; // Nothing of ours.
        while (std::optional<JournalRecord> record = nextRecord(m_file)) {
            if (progress && !progress(0.5 * static_cast<double>(m_file.pos()) / static_cast<double>(m_file.size())))
                return false;
            if (record->kind == RecordKind::Tile)
                m_tiles.push_back({.packed = std::move(record->payload)});
            else if (record->kind == RecordKind::Head)
                m_heads.push_back({.packed = std::move(record->payload)});
            else if (record->kind == RecordKind::Clean)
                m_clean = true;
            else if (record->kind == RecordKind::State && !take(record->payload))
                return true; // Damaged: what stands before it counts.
        }
        return true;
    }

    [[nodiscard]] bool hasWork() const { return !m_clean && m_current.has_value(); }

    /// None where cancelled; without steps where not even the last one can be made.
    [[nodiscard]] std::optional<RecoveredWork> build(const Progress& progress)
    {
        // Neighbours of the last one, as far as there is no gap.
        int first = *m_current;
        while (m_states.contains(first - 1))
            --first;
        int last = *m_current;
        while (m_states.contains(last + 1))
            ++last;
        RecoveredWork work;
        for (int index = first; index <= last; ++index) {
            if (progress && !progress(0.5 + 0.5 * (index - first) / (last - first + 1)))
                return std::nullopt;
            std::optional<JournalState> state = stateOf(m_states.at(index));
            if (!state) {
                if (index > *m_current)
                    break;
                work.steps.clear();
                continue;
            }
            if (index == *m_current)
                work.current = work.steps.size();
            work.steps.push_back(std::move(*state));
        }
        if (work.current >= work.steps.size())
            work.steps.clear();
        return work;
    }

private:
    struct Tile
    {
        QByteArray packed;
        sim::RasterTilePtr tile = {}; ///< Once it was needed.
        int channels = 0;
    };
    struct SourceHead
    {
        QByteArray packed;
        std::shared_ptr<const Head> head = {};
    };

    bool take(const QByteArray& payload)
    {
        std::optional<StateFields> fields = stateFields(payload);
        if (!fields)
            return false;
        for (auto& [layer, table] : fields->tables)
            m_tables[layer] = std::make_shared<const QByteArray>(std::move(table));
        fields->tables.clear();
        if (fields->count == 0)
            m_states.clear();
        m_states.erase(m_states.upper_bound(fields->count), m_states.end());
        m_current = fields->index;
        m_clean = false;
        const int index = fields->index;
        m_states[index] = FoundState{.fields = std::move(*fields), .tables = m_tables};
        return true;
    }

    sim::RasterTilePtr tileOf(std::uint32_t number, int channels)
    {
        if (number >= m_tiles.size())
            return nullptr;
        Tile& found = m_tiles[number];
        if (found.tile)
            return found.channels == channels ? found.tile : nullptr;
        const QByteArray& packed = found.packed;
        if (packed.size() < 2 || packed[0] != channels)
            return nullptr;
        auto tile = std::make_shared<sim::RasterTile>();
        const QByteArrayView body = QByteArrayView(packed).sliced(2);
        if (packed[1] != 0) {
            if (body.size() != static_cast<qsizetype>(sizeof(sim::Texel)))
                return nullptr;
            qFromLittleEndian<quint16>(body.data(), static_cast<qsizetype>(tile->uniform.size()), tile->uniform.data());
        } else {
            const std::optional<QByteArray> bytes = unpacked(body, kMostTileBytes);
            const std::size_t values = sim::kTileTexels * static_cast<std::size_t>(channels);
            if (!bytes || static_cast<std::size_t>(bytes->size()) != values * sizeof(std::uint16_t))
                return nullptr;
            tile->pixels.resize(values);
            qFromLittleEndian<quint16>(bytes->constData(), static_cast<qsizetype>(values), tile->pixels.data());
        }
        found.channels = channels;
        found.packed.clear();
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
            const std::optional<QByteArray> glb = unpacked(found.packed, kMostMeshBytes);
            if (!glb)
                return nullptr;
            const Checked<std::shared_ptr<const Head>> head =
                headFromGlb(reference.name, *glb, reference.unitScale, reference.upAxis, {}, reference.landmarks);
            if (!head)
                return nullptr;
            found.head = *head;
        }
        return found.head;
    }

    bool fill(Layer& layer, int size, int channels, const FoundState& from)
    {
        const auto table = from.tables.find(layer.id);
        sim::TiledRaster raster(size, channels);
        if (table == from.tables.end() || table->second->size() != raster.tileCount() * kTableEntryBytes)
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
        Checked<ProjectManifest> manifest = projectFromJson(from.fields.project);
        if (!manifest)
            return std::nullopt;
        JournalState state;
        state.project = std::move(manifest->project);
        state.project.head = headOf(manifest->head, from.fields.head);
        if (!state.project.head)
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
        state.path = from.fields.path;
        state.step = from.fields.step;
        state.index = from.fields.index;
        state.count = from.fields.count;
        state.timeMs = from.fields.timeMs;
        return state;
    }

    QIODevice& m_file;
    std::vector<Tile> m_tiles;
    std::vector<SourceHead> m_heads;
    std::map<Id, Table> m_tables;
    std::map<int, FoundState> m_states; ///< Of the history that is open, by index.
    std::optional<int> m_current;
    bool m_clean = false;
};

Result<std::optional<RecoveredWork>> read(const QString& path, const Progress& progress)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return cannotOpen(path, {.text = readRefusal(file.errorString()), .cure = Clause::Cure::OtherFile});
    Scan scan(file);
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

Result<std::optional<RecoveredWork>> readJournal(const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotOpen, [&] { return read(path, progress); });
}

} // namespace hairpaint::model
