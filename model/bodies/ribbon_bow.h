// A bow of ribbon: two loops, two tails and a knot.
#pragma once

#include "sim/skin/head_mesh.h"

namespace hairpaint::model {

/// Adds one whose loops reach `scale` along x and -x from the knot at `at`; it faces z and its tails hang along -y.
void addRibbonBow(sim::HeadMesh& mesh, glm::vec3 at, float scale);

} // namespace hairpaint::model
