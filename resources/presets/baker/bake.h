// Makes a preset's maps out of a style's functions.
#pragma once

#include "model/preset.h"
#include "sim/skin/skin.h"
#include "styles.h"

#include <optional>
#include <vector>

namespace hairpaint::presets {

/// Every place that a texel of a map shows, so that it is looked up once for all maps; none beside the skin.
using SkinPoints = std::vector<std::optional<SkinPoint>>;
[[nodiscard]] SkinPoints pointsOn(const sim::Skin& skin);

[[nodiscard]] model::Preset bake(const Style& style, const SkinPoints& points); ///< Without its picture.

} // namespace hairpaint::presets
