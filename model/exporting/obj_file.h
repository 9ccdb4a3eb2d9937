// Hair as the lines of a Wavefront OBJ.
#pragma once

#include "model/exporting/curve_set.h"
#include "model/exporting/export_space.h"
#include "model/values/error.h"

namespace hairpaint::model {

/// An object a group, and one with faces for each thing that is worn; vertices with colours (sRGB as encoded), and a
/// line a segment, since some readers keep no more of a longer one. Where something is worn, its materials lie
/// beside it (objMaterialsPath), and the images that they name, NAME-worn-1.png and so on. Atomic, all together. Any
/// thread.
[[nodiscard]] Result<void> writeObjFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                                        const Progress& progress = {});

[[nodiscard]] QString objMaterialsPath(const QString& path);

} // namespace hairpaint::model
