// Journals, as they lie on a disk or with records whose checksums are right: work comes back whole, or not at all.
#include "model/journal/journal_format.h"
#include "model/journal/journal_reader.h"
#include "model/journal/journal_records.h"
#include "tests/fuzz/fuzz_input.h"

using namespace hairpaint;

namespace {

QByteArray stateOf(fuzz::Input& input)
{
    model::StateFields fields;
    fields.project = input.piece();
    fields.head = input.number<std::int8_t>();
    fields.index = input.number<std::int32_t>();
    fields.count = input.number<std::int32_t>();
    for (int tables = input.byte() % 16; tables > 0; --tables) {
        const model::Id layer = input.byte();
        QByteArray& table = fields.tables[layer];
        const int tile = input.byte();
        // Mostly as many as a map of 256 texels has.
        const int tiles = input.byte() < 240 ? 16 : input.byte();
        for (int i = 0; i < tiles; ++i)
            table.append(QByteArray(1, static_cast<char>(tile)) + QByteArray(3, '\0'));
    }
    return model::statePayload(fields);
}

QByteArray journalOf(fuzz::Input& input)
{
    if (input.byte() % 2 == 0)
        return input.rest();
    QByteArray bytes = model::recordBytes(model::RecordKind::Start, model::journalStart());
    while (!input.atEnd()) {
        const auto kind = static_cast<model::RecordKind>(input.byte() % 7);
        switch (kind) {
        case model::RecordKind::State:
            bytes += model::recordBytes(kind, stateOf(input));
            break;
        case model::RecordKind::Tile: {
            const QByteArray head = input.take(2);
            const QByteArray texels = input.piece();
            // A short one is uniform, a long one stands for itself again and again.
            const QByteArray packed = texels.size() < 9 ? texels : model::packedPayload(texels.repeated(4096 * 8 / 16));
            bytes += model::recordBytes(kind, head + packed);
            break;
        }
        case model::RecordKind::Head:
            bytes += model::recordBytes(kind, model::packedPayload(input.piece()));
            break;
        default:
            bytes += model::recordBytes(kind, input.piece());
        }
    }
    return bytes;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const QString path = fuzz::scratchFile(QStringLiteral("journal"), journalOf(input));
    const model::Result<std::optional<model::RecoveredWork>> work = model::readJournal(path);
    if (!work || !*work)
        return 0;
    fuzz::require((*work)->current < (*work)->steps.size());
    for (const model::JournalState& state : (*work)->steps)
        fuzz::require(state.project.head != nullptr && !state.project.groups.empty());
    return 0;
}
