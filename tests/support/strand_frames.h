// Reading single strands out of frames.
#pragma once

#include "sim/motion/simulation.h"

#include <vector>

namespace hairpaint::test {

inline sim::StrandFrame frameOf(const sim::Simulation& simulation)
{
    sim::StrandFrame frame;
    simulation.writeFrame(frame);
    return frame;
}

/// A slot's nodes in the first group; empty where it is not drawn.
inline std::vector<glm::vec3> nodesOf(const sim::StrandFrame& frame, std::size_t slot)
{
    const sim::Groom& groom = *frame.groups.front().groom;
    if (!groom.isDrawn(slot))
        return {};
    std::vector<glm::vec3> result(static_cast<std::size_t>(groom.nodes));
    groom.blocks().read(frame.groups.front().positions, groom.frameStrand(slot), result);
    return result;
}

} // namespace hairpaint::test
