// Hair in Cem Yuksel's `.hair` format.
#pragma once

#include "model/error.h"
#include "model/files/project_file.h"
#include "sim/motion/strand_frame.h"

namespace hairpaint::model {

/// Every drawn hair as its curve: segments, points, thickness, transparency and colours per point, in metres, y up (the
/// header's text says so), ordered by group and by the candidates' rank. Thickness and transparency run to the tip as
/// on the screen, where a hair thins out by its opacity; so do colours, sRGB as encoded, mixed in linear light. Atomic.
/// Any thread; `progress` never steps back, and nothing is written where it cancels.
[[nodiscard]] Result<void> writeHairFile(const sim::StrandFrame& frame, const QString& path,
                                         const Progress& progress = {});

} // namespace hairpaint::model
