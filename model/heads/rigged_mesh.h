// A head's mesh as it comes from a foreign file: with its skeleton, where it has one.
#pragma once

#include "model/heads/head_skeleton.h"
#include "sim/skin/head_mesh.h"

#include <utility>

namespace hairpaint::model {

struct RiggedMesh : sim::HeadMesh
{
    HeadSkeleton skeleton = {};
    RiggedMesh() = default;
    RiggedMesh(sim::HeadMesh mesh) : sim::HeadMesh(std::move(mesh)) {}
};

} // namespace hairpaint::model
