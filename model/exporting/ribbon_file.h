// Hair as ribbons in a binary glTF.
#pragma once

#include "model/exporting/curve_set.h"
#include "model/exporting/export_space.h"
#include "model/values/error.h"

namespace hairpaint::model {

/// A mesh a group, and one for each thing that is worn; a ribbon a strand, two vertices a point, with normals, uv
/// (across, and from the root down) and colours in linear light. Where fewer hairs are exported than there are, ribbons
/// are as much wider. Atomic. Any thread.
[[nodiscard]] Result<void> writeRibbonFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                                           const Progress& progress = {});

} // namespace hairpaint::model
