// The head in an archive: named where it is built in, else its mesh.
// Any thread.
#pragma once

#include "model/files/archive.h"
#include "model/files/project_json.h"

#include <functional>
#include <memory>

namespace hairpaint::model {

/// The head that a file's project.json refers to. Null where `goesOn` stopped it. Errors: clauses for a sentence of
/// sentences.h.
[[nodiscard]] Checked<std::shared_ptr<const Head>>
readHead(const ArchiveReader& archive, const HeadReference& reference, const std::function<bool()>& goesOn = {});
/// Adds what the reference needs: nothing for a built-in head or none.
void addHead(ArchiveWriter& archive, const std::shared_ptr<const Head>& head);

} // namespace hairpaint::model
