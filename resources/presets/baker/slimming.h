// Styles as small as PNG lets them be.
#pragma once

#include "model/values/sentences.h"

namespace hairpaint::presets {

/// Packs the layers of a style's file anew, with all the time that takes: grey alone where that says all.
[[nodiscard]] model::Checked<void> slim(const QString& path);

} // namespace hairpaint::presets
