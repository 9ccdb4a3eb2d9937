// Hair read from USD text: its BasisCurves.
#pragma once

#include "model/importing/foreign_curves.h"
#include "model/importing/usd_layers.h"
#include "model/values/progress.h"
#include "model/values/sentences.h"

#include <QByteArray>

namespace hairpaint::model {

/// Reads points, widths, colours and groom attributes of every visible BasisCurves of the stage, moved as their prims
/// are, and the stage's unit and up axis. What several layers say of a prim is composed by the standard's strength:
/// local opinions, then inherits, variants, references, payloads, specializes; layers, references and payloads as far
/// as `opener` opens them. Cubic curves become lines through what they run through. Of animated ones the first moment.
/// Curves that are guides are only there where all are. None inside where `progress` cancels. Throws std::bad_alloc.
[[nodiscard]] Checked<std::optional<ForeignCurves>> readUsdText(const QByteArray& text, const Progress& progress = {},
                                                                const UsdOpener& opener = {});

} // namespace hairpaint::model
