// Pictures for judging a bake by eye: shaded views under two lights, and the uv layout. Written as PPM.
#pragma once

#include <filesystem>
#include <functional>

#include "sim/skin/head_mesh.h"

namespace hairpaint::heads {

// front, three-quarter, profile, back, below, face, ear; the same with a checker of the uv; the uv layout with uv
// overlaps in red. `tint` colours a point of the skin (hairlines); 0 to 1 each channel.
void writePreviews(const sim::HeadMesh& fine, const sim::HeadMesh& carrying,
                   const std::function<glm::vec3(const glm::vec3&)>& tint, const std::filesystem::path& folder);

} // namespace hairpaint::heads
