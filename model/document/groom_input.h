// What the simulation makes hair of.
#pragma once

#include "model/maps/resolved_maps.h"
#include "model/patches/project_patches.h"
#include "model/project/project.h"
#include "sim/groom/groom_input.h"

namespace hairpaint::model {

/// A project as it is shown, with its maps and patches; shares them. Groups whose density is still being resolved are
/// left out. Neither revision nor preview is set. GUI thread.
[[nodiscard]] sim::GroomInput groomInputOf(const Project& shown, const ResolvedMaps& maps,
                                           const ProjectPatches& patches);

} // namespace hairpaint::model
