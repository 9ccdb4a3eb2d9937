// The hair in motion: grooms, solver and dependent hairs, stepped by hand. The worker, the tests and the command line
// use it.
#pragma once

#include "sim/groom/groom_input.h"
#include "sim/motion/strand_frame.h"
#include "sim/motion/wind.h"
#include "sim/solver/solver_layout.h"

#include <memory>

namespace hairpaint::sim {

/// Not thread safe. Results do not depend on the number of threads that parallelFor uses.
///
/// Step: Verlet with drag (equation 5), gravity, wind against each segment's relative velocity, rest shape held by gel
/// and body, hair against hair (HairBody), length constraint (equation 4, algorithm 2, then one exact root-to-tip pass,
/// Mueller et al. 2012), ellipsoids and skin with friction; dependent hairs by displacement (algorithm 3), their length
/// restored.
class Simulation
{
public:
    Simulation();
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// Rebuilds what differs. Strands that stay keep their motion; those that are new start hanging still, those whose
    /// length or lay changed go along with it. A new skin starts everything from rest.
    void setInput(const GroomInput& input);
    void setWind(const Wind& wind);
    void setPose(const HeadPose& pose);
    /// A puff of air: speed in m/s, falling off over `radiusM` around a point; lasts a tenth of a second.
    void puff(glm::vec3 centreWo, glm::vec3 velocity, float radiusM);
    /// Every strand back to its rest shape, without speed: how the maps say it grows, before its weight.
    void reset();
    /// Every strand as if it were new: hanging still.
    void hangAnew();

    /// Advances by fixed substeps of kStepSeconds; at most 8 a call, the rest of a longer gap is dropped.
    void advance(double seconds);
    /// Advances without the limit, for settling before a picture.
    void settle(double seconds);
    [[nodiscard]] bool asleep() const;
    /// No strand was there before the last input.
    [[nodiscard]] bool isNew() const;

    /// Writes the present moment (interpolated between the last two steps) into `frame`, reusing its memory. `detail`:
    /// see GroupFrame.
    void writeFrame(StrandFrame& frame, float detail = 1.0F) const;

    /// Sum over builds of strands evaluated.
    [[nodiscard]] std::size_t rebuiltStrands() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace hairpaint::sim
