// Hair put together by hand that hangs under gravity alone, for tests of the solver.
#pragma once

#include "sim/motion/group_dynamics.h"
#include "sim/motion/wind_field.h"
#include "tests/support/hand_made_groom.h"

#include <span>
#include <vector>

namespace hairpaint::test {

/// A head that is one ball.
inline sim::ColliderSet ballCollider(float radiusM = 0.1F)
{
    const std::vector<sim::Ellipsoid> ball{{glm::vec3(0.0F), glm::vec3(radiusM), glm::quat(1.0F, 0.0F, 0.0F, 0.0F)}};
    return sim::prepareColliders(ball);
}

/// Where a node of a strand is now. Hd, m.
inline glm::vec3 nodeOf(const sim::GroupDynamics& hair, std::size_t strand, int node)
{
    const sim::StrandState& state = hair.state();
    return state.shape().node(state.now(), strand, static_cast<std::size_t>(node));
}

/// Steps of a world in which only gravity acts.
inline void fall(sim::GroupDynamics& hair, int steps)
{
    const sim::StepForces calm = sim::WindField::calm({});
    for (int i = 0; i < steps; ++i)
        hair.step(std::span(&calm, 1));
}

} // namespace hairpaint::test
