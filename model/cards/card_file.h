// Hair as cards in a binary glTF, with textures.
#pragma once

#include "model/exporting/curve_set.h"
#include "model/exporting/export_space.h"
#include "model/values/error.h"

#include <QStringList>

namespace hairpaint::model {

/// Where the images lie that the glTF itself does not hold: "hair.glb" has "hair-rootToTip.png" and others.
[[nodiscard]] QStringList cardImagePaths(const QString& path);

/// A mesh a group, all with one material: base colour with alpha, cut off at kCardCutoff, and normals; other images
/// beside it. All files are replaced together, or none is. Any thread.
[[nodiscard]] Result<void> writeCardFile(const CurveSet& curves, const ExportSettings& settings, const QString& path,
                                         const Progress& progress = {});

} // namespace hairpaint::model
