// The drawn hairs of a group, placed around its basis hairs; braided ones along their braid's centre.
#pragma once

#include "sim/base/aligned_floats.h"
#include "sim/groom/groom.h"
#include "sim/motion/strand_frame.h"
#include "sim/skin/neck.h"
#include "sim/solver/solver_layout.h"
#include "sim/solver/strand_state.h"

#include <memory>
#include <vector>

namespace hairpaint::sim {

/// Keeps, per chunk, what the kernel needs beside the groom; a chunk that the next groom shares is not looked at again.
class Dependents
{
public:
    /// `everything`: the ellipsoids or the coat's thickness differ, so every chunk is prepared anew.
    void prepare(const Groom& groom, const ColliderSet& colliders, bool everything);

    /// Fills frame.positions for this moment: `fraction` 0 is the step before, 1 the present one.
    void write(const Groom& groom, const StrandState& state, const ColliderSet& colliders, float fraction,
               const HeadPose& pose, const Neck& neck, GroupFrame& frame);

private:
    struct Chunk
    {
        std::shared_ptr<const StrandChunk> styles;
        AlignedFloats lanes;                ///< [kBlocksPerChunk][kDependentRows][kLanes]
        std::vector<std::uint16_t> braided; ///< Slots within the chunk that are drawn.
    };
    void prepareChunk(const Groom& groom, const ColliderSet& colliders, std::size_t index);
    void findDisplacements(const Groom& groom, const StrandState& state, float fraction);
    void writeBraided(const Groom& groom, const Chunk& chunk, const RigidMotion& world, float* out) const;

    std::vector<Chunk> m_chunks;
    std::vector<std::uint32_t> m_placed; ///< Chunks that have a place in the frame.
    AlignedFloats m_displacements;       ///< [basis lanes][nodes][kBasisFloats], see DependentsTask.
};

} // namespace hairpaint::sim
