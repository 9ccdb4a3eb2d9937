// Hair read from USD text: its BasisCurves.
#pragma once

#include "model/importing/foreign_curves.h"
#include "model/importing/usd_layers.h"
#include "model/values/progress.h"
#include "model/values/sentences.h"

#include <QByteArray>

namespace hairpaint::model {

/// Reads points, widths and displayColor (per point, per curve or for all) of every visible BasisCurves, moved as their
/// prims are, and the stage's unit and up axis. Cubic curves become lines through what they run through. Of animated
/// ones the first moment. Layers, references and payloads are followed as far as `opener` opens them, and so is what
/// inherits, but opinions on other layers' prims count only of transforms and of what is hidden. Of variants the chosen
/// ones. Curves that are guides are only there where all are. None inside where `progress` cancels. Throws
/// std::bad_alloc.
[[nodiscard]] Checked<std::optional<ForeignCurves>> readUsdText(const QByteArray& text, const Progress& progress = {},
                                                                const UsdOpener& opener = {});

} // namespace hairpaint::model
