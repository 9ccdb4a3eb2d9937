// Joints along the parts of worn things that hang, and what follows them.
#pragma once

#include "model/cards/bone_glb.h"
#include "model/exporting/worn_body.h"

#include <span>
#include <vector>

namespace hairpaint::model {

/// One a part that hangs, in their order, where the body's mesh stands in the file.
[[nodiscard]] std::vector<SpringChain> springsOf(const WornBody& body);
/// One a vertex: joint 0, the head, but where a part hangs the joints of its chain. `springs`: springsOf(body);
/// `firstJoint`: number of the first one's first joint.
[[nodiscard]] std::vector<BoneWeights> springWeights(const WornBody& body, std::span<const SpringChain> springs,
                                                     std::size_t firstJoint);

} // namespace hairpaint::model
