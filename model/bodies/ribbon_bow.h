// A bow of ribbon: two loops, two tails and a knot.
#pragma once

#include "model/bodies/hanging_part.h"
#include "sim/skin/head_mesh.h"

#include <array>
#include <memory>

namespace hairpaint::model {

/// A body that a bow is part of.
struct BodyWithTails
{
    std::shared_ptr<const sim::HeadMesh> mesh;
    std::array<HangingPart, 2> tails;
};

/// Adds one whose loops reach `scale` along x and -x from the knot at `at`; it faces z and its tails hang along -y.
/// Returns these.
std::array<HangingPart, 2> addRibbonBow(sim::HeadMesh& mesh, glm::vec3 at, float scale);

} // namespace hairpaint::model
