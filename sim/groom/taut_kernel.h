// kLanes strings over the skin, to one point, pulled taut at once.
#pragma once

#include "sim/base/strand_blocks.h"
#include "sim/groom/skin_distance.h"
#include "sim/groom/taut_string.h"

namespace hairpaint::sim {

/// Where strings begin and end. Hd, m.
struct TautTask
{
    const SkinDistance* distance = nullptr;
    glm::vec3 centreHd{0.0F};  ///< About the middle of the head.
    glm::vec3 outwardHd{0.0F}; ///< Unit: the skin's normal below the end.
    glm::vec3 endHd{0.0F};
    /// [kStringPoints][3][kLanes] The first points are where strings begin; gets the others.
    float* pointsHd = nullptr;
};

/// A string is laid as a great circle about the middle of the head and then pulled: each point to the middle of its
/// neighbours and out of the skin, coarse to fine, so that it leaves the skin where the straight line to the end does,
/// and spans hollows. From the other side of the head it takes the shorter of the paths over it, around its back and
/// straight on. Allocates nothing; the same bytes with every instruction set.
void pullLanes(const TautTask& task);

} // namespace hairpaint::sim
