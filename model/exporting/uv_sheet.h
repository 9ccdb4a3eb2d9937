// The head's UV layout as a sheet to print and draw on.
#pragma once

#include "model/values/error.h"
#include "model/values/progress.h"
#include "sim/skin/head_mesh.h"

#include <QString>

namespace hairpaint::model {

/// Edges in fine grey lines, borders of islands in black, in a square on A4 paper: PDF or SVG by the name's ending.
/// Atomic. Any thread.
[[nodiscard]] Result<void> writeUvSheet(const sim::HeadMesh& mesh, const QString& path, const Progress& progress = {});
/// Whether the name ends in one of those.
[[nodiscard]] bool isUvSheet(const QString& path);

} // namespace hairpaint::model
