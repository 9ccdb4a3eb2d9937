// Hair as USD: text, and the ZIP form of it.
#pragma once

#include "model/exporting/curve_set.h"
#include "model/exporting/export_space.h"
#include "model/values/error.h"

namespace hairpaint::model {

/// A Mesh with its material for each thing that is worn, and an Xform a group, with its strands and, as further curves,
/// its basis hairs as guides: linear BasisCurves with widths and colours per point (linear light) and Unreal's groom
/// attributes. The stage names unit and axis. Textures of what is worn lie beside it, as NAME-worn-1.png and so on.
/// Atomic, all together. Any thread.
[[nodiscard]] Result<void> writeUsdFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                                        const Progress& progress = {});
/// The same as `hair.usda` and its images in a `.usdz`: stored, their bytes aligned to 64.
[[nodiscard]] Result<void> writeUsdArchive(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                                           const Progress& progress = {});

} // namespace hairpaint::model
