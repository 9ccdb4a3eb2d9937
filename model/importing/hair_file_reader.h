// Hair read from Cem Yuksel's `.hair` format.
#pragma once

#include "model/importing/foreign_curves.h"
#include "model/values/progress.h"
#include "model/values/sentences.h"

class QIODevice;

namespace hairpaint::model {

/// Of a file that can be sought in. Strict: counts must agree with each other and with the file's size, so that memory
/// stays within some times that. Unit and axes are told where Hair Paint wrote the file. Throws std::bad_alloc. None
/// inside where `progress` cancels.
[[nodiscard]] Checked<std::optional<ForeignCurves>> readHairFile(QIODevice& file, const Progress& progress = {});

} // namespace hairpaint::model
