// Which hair of a group is gathered by which tie, and the solved hairs of the tails.
#pragma once

#include "sim/groom/gathered_path.h"
#include "sim/groom/groom.h"
#include "sim/groom/lock_partition.h"
#include "sim/groom/map_changes.h"
#include "sim/groom/map_sampler.h"
#include "sim/groom/slot_set.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace hairpaint::sim {

/// Tails are a groom of their own: strands that begin in the ring, with fewer nodes, solved as others are. A tie's
/// solved hairs are the basis hairs on its patch; a patch without any borrows one nearby. One thread writes.
class Gathering
{
public:
    struct Inputs
    {
        const std::vector<Tie>& ties;
        const MapRaster& map;
        const std::shared_ptr<const DistanceGrid>& distances;
        const GroupSettings& settings;
    };
    /// Nothing is gathered.
    void startOver(std::shared_ptr<const RootSet> roots);
    [[nodiscard]] bool isOff() const { return m_ties.empty(); }
    /// Whether these inputs leave everything as it is.
    [[nodiscard]] bool isFor(const Inputs& inputs) const;
    /// Adds the hairs that are gathered otherwise than before.
    void update(const Inputs& inputs, MapChanges& changes, SlotSet& dirty);

    /// What the tails' solved hairs are made from.
    struct BasisInputs
    {
        const GroupSettings& settings;
        const MapSamplers& maps;
        std::span<const std::uint8_t> kinds; ///< [slots] BraidKind
        std::span<const float> basisLengthM; ///< [basis hairs]
        const LockPartition& locks;
    };
    /// Lays the tails' solved hairs that are on a dirty root, or whose tie differs; adds the hairs that follow them
    /// closely.
    void updateBasis(const BasisInputs& inputs, const SlotSet& dirtyBasis, SlotSet& dirty);
    /// Gives the groom its tails; those of chunks that are what they were in `before` (may be null) are kept.
    void makeTails(const Groom* before, Groom& groom) const;

    /// Number of the tie that gathers a hair; 0: loose.
    [[nodiscard]] std::uint16_t numberOf(std::uint32_t slot) const { return m_numbers.empty() ? 0 : m_numbers[slot]; }
    [[nodiscard]] std::uint16_t numberOfBasis(std::size_t basis) const
    {
        return m_numberOfBasis.empty() ? 0 : m_numberOfBasis[basis];
    }
    /// The basis hair, of its own tie, to which a hair's tail clumps.
    [[nodiscard]] std::uint32_t leaderOf(std::uint32_t slot, const LockPartition& locks, float ragged) const;
    [[nodiscard]] const Followed& followed(std::uint32_t slot) const { return m_followed[slot]; }
    [[nodiscard]] const BasisStyles& basis() const { return *m_basis; }

    struct TieState
    {
        Tie tie;
        TautStrings strings;
        GatheredLay lay; ///< Lays hair along `strings`.
        std::vector<std::uint32_t> basis;
        std::uint32_t core = kNoCentre; ///< The basis hair through the middle of the ring, which braids follow.
        std::uint32_t formerCore = kNoCentre;
        bool isOtherCore = false; ///< `core` changed since the tails' solved hairs were last laid.
        float coreFreeM = 0.0F;   ///< Length of the core behind the ring.
        bool isNew = true;        ///< The tie is new or changed in this update.
    };
    [[nodiscard]] const TieState& tieOf(std::uint16_t number) const;

private:
    using WantedTail = std::pair<TieState*, std::uint32_t>; ///< With its basis hair.
    /// Lays the tails of at most kLanes solved hairs of one tie, which were as in `before`.
    void layTails(const BasisInputs& inputs, TieState& tie, std::span<const WantedTail> wanted,
                  const BasisStyles& before, BasisStyles& next);
    void takeTies(const Inputs& inputs);
    void readNumbers(const Inputs& inputs, MapChanges& changes, SlotSet& dirty);
    void findBasis();
    void borrowBasis(TieState& tie);
    [[nodiscard]] bool isConcerned(std::uint32_t slot, const SlotSet& dirty) const;
    void findFollowed(SlotSet& dirty);
    [[nodiscard]] Followed followedBy(std::uint32_t slot) const;
    void prepareStrings(const SlotSet& dirty);
    [[nodiscard]] TieState* find(std::uint16_t number) const;
    /// Adds the hairs that clump to one of the tails' hairs that lie otherwise now.
    void findClumped(const BasisInputs& inputs, SlotSet& dirty) const;

    std::shared_ptr<const RootSet> m_roots;
    std::vector<std::unique_ptr<TieState>> m_ties; ///< Sorted by their numbers.
    MapRaster m_map;
    std::shared_ptr<const DistanceGrid> m_distances;
    float m_coatM = 0.0F;
    bool m_otherNumbers = false;                ///< In this update the set of ties' numbers differs,
    bool m_anyMoved = false;                    ///< and some root has another number.
    std::vector<std::uint16_t> m_numbers;       ///< [slots]; empty where off.
    std::vector<std::uint16_t> m_numberOfBasis; ///< [basis hairs], borrowed ones too.
    std::vector<Followed> m_followed;           ///< [slots]
    std::shared_ptr<const BasisStyles> m_basis;
    std::vector<std::uint8_t> m_relaid; ///< [basis hairs] 1 where its shape in the tail changed in this update,
    std::vector<std::uint8_t> m_moved;  ///< and 1 where it belongs to another tie now.
};

} // namespace hairpaint::sim
