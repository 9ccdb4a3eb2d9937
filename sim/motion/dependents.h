// The drawn hairs of a group, positioned around its basis hairs; braided ones along their braid's centre.
#pragma once

#include "sim/base/aligned_floats.h"
#include "sim/groom/groom.h"
#include "sim/motion/basis_leads.h"
#include "sim/motion/strand_frame.h"
#include "sim/skin/neck.h"
#include "sim/solver/solver_layout.h"
#include "sim/solver/strand_state.h"

#include <memory>
#include <vector>

namespace hairpaint::sim {

/// Keeps, per chunk, what the kernel needs beside the groom; of a chunk that the next groom shares, only what
/// follows a basis hair that differs is looked at again.
class Dependents
{
public:
    /// `everything`: the ellipsoids or the coat's thickness differ, so every chunk is prepared anew.
    void prepare(const Groom& groom, const ColliderSet& colliders, bool everything);

    /// Fills frame.positions for this moment: `fraction` 0 is the step before, 1 the present one. Blocks in which no
    /// hair is below frame.detail are left as they are.
    void write(const Groom& groom, const StrandState& state, const ColliderSet& colliders, float fraction,
               const HeadPose& pose, const Neck& neck, GroupFrame& frame);

private:
    struct Chunk
    {
        std::shared_ptr<const StrandChunk> styles;
        AlignedFloats lanes;                ///< [kBlocksPerChunk][dependentRows][kLanes]
        std::vector<std::uint16_t> braided; ///< Slots within the chunk that are drawn.
        /// [kChunkSlots] weights of the basis hairs that each follows.
        std::vector<std::array<float, RootSet::kNeighbours>> weights;
        /// [kChunkSlots] those basis hairs; empty where every hair follows the nearest ones.
        std::vector<std::array<std::uint32_t, RootSet::kNeighbours>> followed;
        std::vector<std::uint16_t>
            parted; ///< Slots whose nearest basis hairs all lie to another side or are too short.
        /// A copy of the styles' rest positions in which some long hairs, that lie as none around them, differ; empty
        /// where there are no such hairs.
        std::vector<float> rest;
    };
    /// Follows anew, in a chunk that is kept, for the hairs whose basis hairs changed.
    void followChangedBasis(const Groom& groom, const std::vector<std::uint8_t>& changed, std::size_t index);
    /// How much a drawn hair follows each of its basis hairs. One of another length (at the edge of a cut), or that
    /// lies to another side, counts less, and the nearest counts the more the closer the hair clumps to it. Where all
    /// of the nearest lie to another side, as beside a parting, it follows one next to them that does not; and a long
    /// one among short ones, which a cut has missed, one further away that hangs.
    void follow(const Groom& groom, std::size_t index, std::size_t slot);
    /// Makes a hair follow the basis hairs of StrandChunk::followed.
    void followGiven(const Groom& groom, std::size_t index, std::size_t slot);
    /// Makes a hair follow the basis hair that leads its lock as closely as it clumps.
    void followLock(const Groom& groom, std::size_t index, std::size_t slot, float clump);
    /// The basis hair whose lock it is in; the nearest where locks have no others.
    [[nodiscard]] static std::uint32_t leaderOf(const Groom& groom, std::size_t index, std::size_t slot);
    /// Fills a chunk's `followed` with the nearest basis hairs, for hairs that will follow others.
    void makeFollowed(const Groom& groom, std::size_t index);
    void layAlong(const Groom& groom, std::size_t index, std::size_t slot, std::uint32_t basis);
    void setClump(const Groom& groom, std::size_t index, std::size_t slot, float clump);
    void prepareChunk(const Groom& groom, const ColliderSet& colliders, std::size_t index);
    void findDisplacements(const Groom& groom, const StrandState& state, float fraction);
    void writeBraided(const Groom& groom, const Chunk& chunk, const RigidMotion& world, float detail, float* out) const;

    BasisLeads m_leads;
    std::vector<Chunk> m_chunks;
    std::vector<std::uint32_t> m_positioned; ///< Chunks that have positions in the frame.
    AlignedFloats m_displacements;           ///< [basis lanes][nodes][kBasisFloats], see DependentsTask.
};

} // namespace hairpaint::sim
