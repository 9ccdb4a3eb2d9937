// What the comb makes of hair where it does not follow the pointer.
#pragma once

#include "model/tools/lying/fallen_hair.h"
#include "model/tools/strokes/skin_frames.h"
#include "model/tools/tool_settings.h"

namespace hairpaint::model {

/// The direction of hair that lies as `before` at `uv`, lifted or laid, ruffled, or smoothed with what lies within
/// `reachUv`, as `settings.comb` says. GUI thread.
[[nodiscard]] glm::vec2 restyled(FallenHair& before, SkinFrames& frames, glm::vec2 uv, glm::vec2 reachUv,
                                 const ToolSettings& settings);

} // namespace hairpaint::model
