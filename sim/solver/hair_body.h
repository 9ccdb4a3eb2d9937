// The body of a group's hair: it keeps out of hair and moves along with it.
#pragma once

#include "sim/base/aligned_floats.h"
#include "sim/groom/groom.h"
#include "sim/solver/body_kernel.h"
#include "sim/solver/strand_state.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// Hair that is denser than at rest is left, as in a contact, and hair that moves against the hair around it is dragged
/// along. Density and velocity are those of a grid, which is made anew every kStepsAGrid steps; between, contacts stay
/// as they are. At rest is what the rest shape has at each node, or what loose hair has where that is more. A contact
/// bends where a node is headed, as gravity does, so that stiffness, lengths and skin answer to it in the same step.
/// Only hair of one group meets. Loops run through parallelFor, with the same result for any number of threads.
class HairBody
{
public:
    void setGroom(const Groom& groom);
    /// The hair is elsewhere than it was: no contact until the next grid, which is made with the next step.
    void forget();
    /// Before a step; makes a grid where it is time for one. Returns how many steps of `wanted` it is for.
    [[nodiscard]] std::size_t meet(const StrandState& state, std::size_t wanted);
    /// What the grid does to blocks begin..end where meet() has just made one; nothing elsewhere. Before their step,
    /// on the thread that takes it, while they are in its cache. Ranges that do not overlap may be pushed at once.
    void push(const SolverBlocks& blocks, int present, std::size_t begin, std::size_t end);

    /// See SolverBlocks.
    [[nodiscard]] const float* contact() const { return m_contact.data(); }
    [[nodiscard]] const std::uint8_t* dense() const { return m_dense.data(); }
    [[nodiscard]] std::uint64_t gridsMade() const { return m_gridsMade; }

private:
    using Cells = std::vector<std::int32_t, CacheLineAllocator<std::int32_t>>;

    void countHairs(const Groom& groom);
    void measureRest(const Groom& groom);
    /// Splats into m_grid.
    void makeGrid(const BodyNodes& nodes);
    [[nodiscard]] BodyNodes nodesOf(const StrandState& state) const;
    [[nodiscard]] float densityPerUnit() const;

    int m_nodes = 0;
    std::size_t m_blocks = 0;
    float m_cellM = 0.01F;
    float m_metresPerUnit = 0.0F; ///< Length of hair that a unit of the grid stands for.
    BodyGains m_gains;
    BodyGrid m_grid;
    std::vector<Cells> m_parts; ///< Each thread's cells; the sum is in the first.
    AlignedFloats m_hair;       ///< See BodyNodes.
    AlignedFloats m_perRest;    ///< See BodyPush,
    AlignedFloats m_contact;    ///< and so its `out`.
    std::vector<std::uint8_t> m_dense;
    std::size_t m_stepsLeft = 0; ///< Until the next grid.
    bool m_isNew = false;        ///< Whether the grid is, for the step that comes.
    std::uint64_t m_gridsMade = 0;
};

} // namespace hairpaint::sim
