// The rest shape of a braided hair: over the scalp to its braid's centre, then along the centre's skeleton.
#pragma once

#include "sim/groom/rest_shape.h"
#include "sim/groom/strand_style.h"

#include <span>

namespace hairpaint::sim {

/// The node that stands on the centre's root: the first quarter of the skeleton gathers, the rest is the braid. The
/// same for all hairs, so that those of a braid share its nodes.
[[nodiscard]] int gatheringNode(int nodes);

/// Fills the nodes: evenly over the scalp from the root to a point `aboveM` over the centre's root, from there evenly
/// along `centreLengthM` of its normal. Returns the length of the part on the scalp, m.
[[nodiscard]] float braidRest(const RootFrame& root, const RootFrame& centre, float aboveM, float centreLengthM,
                              std::span<glm::vec3> nodesHd);

/// A plait has three wisps, a twist two, a loc one.
[[nodiscard]] std::uint32_t wispCount(BraidKind kind);

/// Half the thickness of a braid `lengthM` long, m: how far its hairs are from its skeleton at most.
[[nodiscard]] float braidGirthM(const GroupSettings& settings, BraidKind kind, float lengthM);
/// How far over the skin a braid begins, so that it is clear of it there, m.
[[nodiscard]] float braidBeginsAboveM(const GroupSettings& settings, BraidKind kind, float lengthM);

/// Makes a style that of a hair in a braid, whose path is `scalpM` on the scalp and `centreLengthM` along its centre.
void applyBraid(const GroupSettings& settings, BraidKind kind, const WispChance& chance, float scalpM,
                float centreLengthM, StrandStyle& style);

} // namespace hairpaint::sim
