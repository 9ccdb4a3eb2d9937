// Hair in Cem Yuksel's `.hair` format.
#pragma once

#include "model/exporting/curve_set.h"
#include "model/exporting/export_space.h"
#include "model/values/error.h"

namespace hairpaint::model {

/// Segments, points, thickness, transparency and colours per point (the header's text tells unit and axes). Thickness
/// and transparency run to the tip as on the screen, where a hair thins out by its opacity; so do colours, sRGB as
/// encoded. Atomic. Any thread.
[[nodiscard]] Result<void> writeHairFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                                         const Progress& progress = {});

} // namespace hairpaint::model
