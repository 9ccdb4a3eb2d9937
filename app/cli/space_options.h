// Options that tell in what unit and axes a file of another program stands.
#pragma once

#include "model/files/head_guess.h"
#include "model/importing/curve_fit.h"

class QCommandLineParser;

namespace hairpaint::app {

/// The unit and axis of curves; none where either is nonsense, with the usage printed.
[[nodiscard]] std::optional<model::CurveSpaceChoice> curveSpaceOptions(const QCommandLineParser& parser,
                                                                       const char* command);
/// --head-unit, --head-axis and --head-facing, likewise, and --head-part, --grow-on and --own-layout.
[[nodiscard]] std::optional<model::HeadChoice> headSpaceOptions(const QCommandLineParser& parser, const char* command);

} // namespace hairpaint::app
