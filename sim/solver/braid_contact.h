// Braids of a group keep off each other: what each of their nodes must stay beside.
#pragma once

#include "sim/base/aligned_floats.h"
#include "sim/groom/groom.h"
#include "sim/solver/braid_pairs.h"
#include "sim/solver/strand_state.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// A braid is a chain of capsules as thick as its girth, which it reaches as it does on the skin (kGirthSlope). Every
/// four steps, in wind every eight, the points where segments of two braids are nearest are found, and each of their
/// nodes is given half spaces (kBraidPlanes at most, one for each other braid) that it may not leave until then: up to
/// the middle of a gap, and out of an overlap by a part of it (Jacobi, from where all are then), mostly the outer one.
/// The half spaces move along as fast as the two on average. constraints/braids_inl.h applies them, with friction.
///
/// Braids that the rest shape has nearer to each other than their girths may stay so near at their roots and, where gel
/// holds them, all along; further down, falling braids come apart. Hair that is in no braid, braids of other groups and
/// those behind a tie are not met. Loops run through parallelFor, with the same result for any number of threads.
class BraidContact
{
public:
    void setGroom(const Groom& groom);
    /// No solved hair is a braid: nothing is to be done.
    [[nodiscard]] bool isEmpty() const { return m_strands.empty(); }
    /// The hair is elsewhere than it was: no contact until the next step finds them.
    void forget();
    /// Before a step; finds contacts where it is time to. Returns how many steps of `wanted`, one or more, they are
    /// for.
    [[nodiscard]] std::size_t meet(const StrandState& state, std::span<const StepForces> wanted);
    /// Those that were made of them.
    void pass(std::size_t steps) { m_stepsDone += steps; }

    /// For the next steps.
    [[nodiscard]] BraidPlanes planes() const;
    /// Times that neighbours were looked for.
    [[nodiscard]] std::uint64_t listsMade() const { return m_pairs.listsMade(); }

private:
    /// Where two segments are nearest.
    struct Contact
    {
        std::int32_t first = 0; ///< The nodes that they begin in.
        std::int32_t second = 0;
        float alongFirst = 0.0F; ///< 0..1
        float alongSecond = 0.0F;
        float gapM = 0.0F;         ///< Below 0: they overlap.
        float clearM = 0.0F;       ///< Distance at which there is none.
        float ofFirst = 0.5F;      ///< The part of an overlap that the first leaves, 0..1.
        glm::vec3 normal{0.0F};    ///< Unit vector from the second to the first.
        glm::vec3 velocityM{0.0F}; ///< Of both on average, m a step.
    };
    /// A half space for a node.
    struct Plane
    {
        std::int32_t other = 0; ///< The braid that it is of.
        float offsetM = 0.0F;   ///< How far along the normal the node must at least be from where it is.
        glm::vec3 normal{0.0F};
    };
    struct NodePlanes
    {
        std::array<Plane, kBraidPlanes> planes;
        std::uint32_t count = 0;
        std::uint32_t contacts = 0;
        glm::vec3 velocitiesM{0.0F}; ///< Their sum.
    };

    void read(const StrandState& state);
    [[nodiscard]] BraidNodes nodesInRows() const;
    void findContacts(std::size_t braid);
    [[nodiscard]] bool finish(Contact& contact) const;
    [[nodiscard]] float allowedM(const Contact& contact) const;
    void addTo(std::size_t node, float weight, const Contact& contact, bool isFirst);
    void addPlanes(const Contact& contact);
    void writeBlock(std::size_t row);

    int m_nodes = 0;
    int m_firstNode = 2;                             ///< The first that is moved.
    std::vector<std::uint32_t> m_strands;            ///< [braids]
    std::vector<std::int32_t> m_braids;              ///< [braids][nodes]: of each node.
    std::vector<glm::vec3> m_restHd;                 ///< [braids][nodes]
    std::vector<float> m_spreadM;                    ///< [braids][nodes]: see allowedM().
    AlignedFloats m_radiusM;                         ///< [braids][nodes]
    std::vector<glm::vec3> m_nodesHd, m_velocitiesM; ///< The same,
    AlignedFloats m_x, m_y, m_z;                     ///< and for the kernel.
    std::vector<std::uint8_t> m_asleep;              ///< [braids]
    BraidPairs m_pairs;
    std::vector<Contact> m_contacts; ///< [braids][m_mostContacts]
    std::vector<std::uint32_t> m_contactCounts;
    std::size_t m_mostContacts = 0;
    std::vector<NodePlanes> m_nodePlanes; ///< [braids][nodes]
    // See BraidPlanes.
    std::vector<std::int32_t> m_rowOfBlock;
    std::vector<std::uint32_t> m_firstOfRow; ///< [rows + 1]: the braids of a block.
    AlignedFloats m_rows;
    std::vector<std::uint8_t> m_counts;
    std::vector<std::uint8_t> m_written; ///< [braids][nodes]: planes in m_rows.
    bool m_isFound = false;
    std::size_t m_stepsDone = 0; ///< Since contacts were found.
};

} // namespace hairpaint::sim
