// The gathered hairs of a group in motion: what lies on the head goes with it, their tails are solved as hair of their
// own.
#pragma once

#include "sim/motion/strand_frame.h"
#include "sim/solver/solver_layout.h"

#include <memory>
#include <span>

namespace hairpaint::sim {

class GroupDynamics;

/// Not thread safe; loops run through parallelFor.
class GatheredHair
{
public:
    GatheredHair();
    ~GatheredHair();
    GatheredHair(GatheredHair&&) noexcept;
    GatheredHair& operator=(GatheredHair&&) noexcept;

    /// As GroupDynamics::setGroom; drops the tails where the groom has none.
    void setGroom(const Groom& groom, const ColliderSet& colliders, const StepForces& calm, const Neck& neck);
    /// How the tails move; null where there are none.
    [[nodiscard]] GroupDynamics* tails() const { return m_tails.get(); }
    /// Writes the gathered hairs into a frame of the group whose other hairs are written.
    void write(GroupFrame& frame, float fraction, const HeadPose& pose, const Neck& neck) const;

private:
    std::unique_ptr<GroupDynamics> m_tails;
    mutable GroupFrame m_frame; ///< The tails' frame; its buffer is reused.
};

} // namespace hairpaint::sim
