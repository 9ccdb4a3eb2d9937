// A layout for skin that came without one, or with one that no brush can use. Any thread.
#pragma once

#include "model/heads/rigged_mesh.h"

namespace hairpaint::model {

/// Another layout: the mesh cut into charts that look along about the same axis, laid flat side by side at one scale.
/// No two points share a texel but where a chart folds. Of a mesh without parts.
[[nodiscard]] RiggedMesh withOwnLayout(const RiggedMesh& source);

} // namespace hairpaint::model
