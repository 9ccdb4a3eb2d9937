// Drawn hairs as courses of nodes, for tools that bend them.
#pragma once

#include "model/tools/shaping/bent_hair.h"
#include "model/tools/tool.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

/// The drawn hair of the target's group that has its root there, where it is now; none where no hair is.
[[nodiscard]] std::optional<HairCourse> courseOf(const ToolContext& context, const sim::SurfacePoint& root);
/// Up to two dozen solved hairs around a root, within the brush or else the nearest dozen.
[[nodiscard]] std::vector<GuideStrand> guidesAround(const ToolContext& context, const sim::SurfacePoint& root);

} // namespace hairpaint::model
