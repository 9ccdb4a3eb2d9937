// Hair read from Cem Yuksel's `.hair` format.
#pragma once

#include "model/importing/foreign_curves.h"
#include "model/values/progress.h"
#include "model/values/sentences.h"

class QIODevice;

namespace hairpaint::model {

/// Reads curves from a file that can be sought in. Strict: counts must agree with each other and with the file's size,
/// so that memory stays within a few times that size. Unit and axes are set where Hair Paint wrote the file. Throws
/// std::bad_alloc. The optional is empty where `progress` cancels.
[[nodiscard]] Checked<std::optional<ForeignCurves>> readHairFile(QIODevice& file, const Progress& progress = {});

} // namespace hairpaint::model
