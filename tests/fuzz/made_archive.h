// Archives whose checksums are right, so that fuzzing gets past them: an input is the archive's own bytes, or the JSON,
// a head and images, of which each entry says where it lies.
#pragma once

#include "model/project/map_spec.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/model/archive_maker.h"

namespace hairpaint::fuzz {

enum class ArchiveForm : std::uint8_t
{
    AsItIs,
    Made,
    MadeAndSpoilt ///< Made, and then some bytes changed.
};

inline QByteArray archiveOf(Input& input, const char* mimetype)
{
    const auto form = static_cast<ArchiveForm>(input.byte() % 3);
    if (form == ArchiveForm::AsItIs)
        return input.rest();
    const int spoilt = form == ArchiveForm::MadeAndSpoilt ? input.byte() % 8 : 0;
    QByteArray offsets;
    for (int i = 0; i < spoilt; ++i)
        offsets += input.take(5);
    std::vector<test::ZipEntry> entries{{.name = "mimetype", .bytes = mimetype},
                                        {.name = "project.json", .bytes = input.piece()},
                                        {.name = "head.glb", .bytes = input.piece()}};
    while (!input.atEnd() && entries.size() < 64) {
        const int group = input.byte() % 4;
        const model::MapSpec& spec = model::mapSpecs()[static_cast<std::size_t>(input.byte() % model::kMapKindCount)];
        const QByteArray name = QByteArray("groups/") + QByteArray::number(group) + '/' + spec.id + '/' +
                                QByteArray::number(input.byte() % 32) + ".png";
        entries.push_back({.name = name, .bytes = input.piece()});
    }
    QByteArray bytes = test::makeZip(entries);
    for (qsizetype i = 0; i + 5 <= offsets.size(); i += 5)
        bytes[qFromLittleEndian<quint32>(offsets.constData() + i) % bytes.size()] = offsets[i + 4];
    return bytes;
}

} // namespace hairpaint::fuzz
