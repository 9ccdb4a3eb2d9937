// Strands as the GPU reads them.
#pragma once

#include "sim/groom/groom.h"

#include <cstdint>

namespace hairpaint::rendering {

using uint = std::uint32_t; // GLSL's name, for the shared layout.
#include "resources/shaders/strand_layout.glsl"

static_assert(sizeof(DrawnStrand) == 8);
static_assert(sizeof(PackedStyle) == 80);
static_assert(kStrandLanes == sim::kLanes);

/// `rootTangentHd`: of the slot that turns the strand's frame, see sim::frameTangentHd.
[[nodiscard]] PackedStyle packedStyle(const sim::StrandStyle& style, glm::vec3 rootTangentHd);

} // namespace hairpaint::rendering
