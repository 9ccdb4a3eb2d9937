// Which of a character's parts hair grows on, and how a character of parts becomes a head. Any thread.
#pragma once

#include "model/heads/rigged_mesh.h"

#include <vector>

namespace hairpaint::model {

/// By part: the one with most of the skin that looks up near the top, of those that have a layout and are not named as
/// eyes, clothes or hair are, and one named as heads are before others, grows hair, and so do those that hang together
/// with it and are not further down, as a body is; others are seen. `up`: an axis of the file's space.
[[nodiscard]] std::vector<PartUse> likelyUses(const RiggedMesh& source, const glm::vec3& up, float metresPerUnit);

/// The parts that grow hair as the first, of one layout, then those that are seen; without those that are left out.
/// Layouts that lie over each other or in other tiles, and those with a texture of their own, lie side by side
/// (layout_packing.h). A mesh of one part stays as it is. At least one part grows hair, and those that do have layouts.
[[nodiscard]] RiggedMesh arranged(const RiggedMesh& source);

} // namespace hairpaint::model
