// Hair read from USD text: its BasisCurves.
#pragma once

#include "model/importing/foreign_curves.h"
#include "model/values/progress.h"
#include "model/values/sentences.h"

#include <QByteArray>

namespace hairpaint::model {

/// Reads points, widths and displayColor (per point, per curve or for all) of every visible BasisCurves, moved as their
/// prims are, and the stage's unit and up axis. Cubic curves become lines through what they run through. Of animated
/// ones the first moment. References, variants and instances are not followed. Curves that are guides are only there
/// where all are. None inside where `progress` cancels. Throws std::bad_alloc.
[[nodiscard]] Checked<std::optional<ForeignCurves>> readUsdText(const QByteArray& text, const Progress& progress = {});

} // namespace hairpaint::model
