// The moving hair of one group: its basis hairs' state through grooms, steps and sleep, and its frame.
#pragma once

#include "sim/motion/dependents.h"
#include "sim/motion/first_fall.h"
#include "sim/motion/gathered_hair.h"
#include "sim/motion/strand_frame.h"
#include "sim/solver/braid_contact.h"
#include "sim/solver/hair_body.h"
#include "sim/solver/strand_state.h"

#include <memory>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// Knows nothing of how grooms are built. Not thread safe; loops run through parallelFor, with the same result for any
/// number of threads.
class GroupDynamics
{
public:
    /// Strands that stay keep their motion to the last bit; new ones start hanging still under `calm` (gravity alone);
    /// those whose rest shape differs go along with it; any other difference wakes the strand. The groom and
    /// colliders of before leave everything as it is. `neck` divides hair that is new: see FirstFall.
    void setGroom(std::shared_ptr<const Groom> groom, const ColliderSet& colliders, const StepForces& calm,
                  const Neck& neck = {});
    /// Every strand to its rest shape, without speed.
    void reset();
    /// Every strand hanging still, as one that is new. `calm`: the forces where nothing moves.
    void hangAnew(const StepForces& calm);
    void wake();
    /// None of its strands was there before the last groom.
    [[nodiscard]] bool isNew() const { return m_isNew && (tails() == nullptr || tails()->isNew()); }
    /// No strand moves any more, or none is seen.
    [[nodiscard]] bool asleep() const;

    void step(std::span<const StepForces> steps);
    /// `fraction`: 0 at the step before, 1 at the present one. The pose is that of the same moment; of the hairs those
    /// below frame.detail are positioned.
    void write(GroupFrame& frame, float fraction, const HeadPose& pose, const Neck& neck = {}) const;

    [[nodiscard]] const std::shared_ptr<const Groom>& groom() const { return m_groom; }
    [[nodiscard]] const StrandState& state() const { return m_state; }
    /// What keeps hair out of hair; null where the group has no body.
    [[nodiscard]] const HairBody* body() const { return m_body.get(); }
    /// What keeps braids off each other; null where there are none.
    [[nodiscard]] const BraidContact* braids() const { return m_braids.get(); }
    /// The hair behind ties; null where none is gathered.
    [[nodiscard]] const GroupDynamics* tails() const { return m_gathered.tails(); }

private:
    void setBraids();
    [[nodiscard]] std::vector<std::size_t> takeStrands(const Groom& before, std::span<const std::int32_t> origin,
                                                       const StrandState& old, glm::vec3 downHd);
    void reshape(const Groom& before, std::size_t was, std::size_t strand, glm::vec3 downHd);
    /// A strand of this state (of the groom now) as it hangs by its rest shape, root first.
    void hang(const StrandState& state, std::size_t strand, std::span<const glm::vec3> restHd, glm::vec3 downHd,
              std::span<glm::vec3> nodesHd) const;
    void settle(std::span<const std::size_t> strands, const StepForces& calm);
    /// Sets the lean of the strand at a place of a state, by how it would hang from an upright head; a braid has none.
    void setLean(StrandState& state, std::size_t at, std::size_t strand, std::span<const glm::vec3> restHd) const;
    /// Something else than gravity moves the hair, or did until now.
    void rouse();
    /// Sets m_gains.stillM and m_gains.drag; returns for how many of the steps, from the first on, it is right.
    [[nodiscard]] std::size_t calmDown(std::span<const StepForces> steps);

    std::shared_ptr<const Groom> m_groom;
    ColliderSet m_colliders;
    GroupGains m_gains;
    float m_drag = 1.0F; ///< m_gains.drag where the hair was not calm for long.
    StrandState m_state;
    std::unique_ptr<HairBody> m_body;
    std::unique_ptr<BraidContact> m_braids;
    mutable Dependents m_dependents; ///< Its buffers are reused from frame to frame.
    GatheredHair m_gathered;
    Neck m_neck;
    FirstFall m_fall;
    std::size_t m_calmSteps = 0; ///< Since something else than gravity moved the hair.
    bool m_awake = false;
    bool m_isNew = true;
};

} // namespace hairpaint::sim
