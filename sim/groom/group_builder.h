// One group's groom, kept up to date: finds the hairs that differ and rebuilds those.
#pragma once

#include "sim/groom/braid_layout.h"
#include "sim/groom/gathering.h"
#include "sim/groom/groom.h"
#include "sim/groom/hairline.h"
#include "sim/groom/lay.h"
#include "sim/groom/lock_partition.h"
#include "sim/groom/map_changes.h"
#include "sim/groom/map_sampler.h"
#include "sim/groom/passed_cells.h"
#include "sim/groom/slot_set.h"

#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::sim {

/// One thread at a time. After update() the groom has the bytes that a new builder would give it.
class GroupBuilder
{
public:
    struct Result
    {
        std::shared_ptr<const Groom> groom; ///< The one before where nothing differs.
        SlotSet rebuilt;                    ///< Hairs, and slots that were hairs, that were evaluated.
    };
    /// What the head has for hair to lie on; see Lay.
    struct HeadLay
    {
        MapRaster natural;
        std::shared_ptr<const SkinBand> band;
        std::shared_ptr<const DistanceGrid> distances; ///< Null: the skin itself tells how far it is.
    };
    [[nodiscard]] Result update(const GroomInput::Group& input, const std::shared_ptr<const RootSet>& roots,
                                const HeadLay& head, HairLimit limit);

private:
    /// Brings m_layField to the input; adds what lies otherwise than before, where there is a before.
    void updateLay(const GroomInput::Group& input, const HeadLay& head, ChangedSlots& dirty);
    /// Adds the hairs, and basis hairs, whose lay passed a cell that differs.
    void findRelaid(const LayField::Difference& difference, ChangedSlots& dirty) const;
    void startOver(const GroomInput::Group& input, const std::shared_ptr<const RootSet>& roots);
    void readKinds(const MapSamplers& maps, const SlotSet& dirty);
    /// A basis hair's own, or where that is much shorter than the longest of the hairs that it leads, theirs: what
    /// hangs at the edge of a cut is not led by stubble.
    [[nodiscard]] float basisLengthOf(std::size_t basisIndex, const GroupSettings& settings,
                                      const MapSampler& length) const;
    void updateBasis(const GroupSettings& settings, const MapSamplers& maps, const LayInputs& lay,
                     const SlotSet& dirty);
    void updateBraids(const GroomInput::Group& input, const GroupSettings& settings, const MapSamplers& maps,
                      SlotSet& dirty);
    [[nodiscard]] bool readBraided(const VariationSettings& variation, const MapSamplers& maps, const SlotSet& dirty);
    /// Adds the hairs that clump to a basis hair that lies otherwise.
    void updateClumped(const GroupSettings& settings, const MapSampler& clump, SlotSet& dirty) const;
    /// The same where locks have leaders.
    void updateLocks(const GroupSettings& settings, const MapSampler& clump, SlotSet& dirty) const;
    void rebuildChunks(const GroupSettings& settings, const MapSamplers& maps, const LayInputs& lay,
                       const ChangedSlots& dirty, Groom& groom, SlotSet& rebuilt);
    void countDependents(const StrandChunk* chunk, std::size_t chunkIndex, const SlotSet& slots, std::uint32_t one);
    void updateWanted(Groom& groom);
    /// A copy of the basis styles that this update may write to.
    [[nodiscard]] BasisStyles& writableBasis();

    std::shared_ptr<const RootSet> m_roots;
    GroomInput::Group m_input;
    HeadLay m_head;
    std::shared_ptr<const Groom> m_groom;
    std::optional<MapChanges> m_changes;
    std::optional<LayField> m_layField;
    std::shared_ptr<const BasisStyles> m_basis;
    std::shared_ptr<BasisStyles> m_newBasis;      ///< While updating, once something differs.
    std::vector<std::uint32_t> m_led;             ///< Slots by the basis hair nearest to them,
    std::vector<std::uint32_t> m_firstLed;        ///< [basis hairs + 1] and where each one's begin.
    std::vector<float> m_basisLengthM;            ///< [basis hairs]
    PassedCells m_passed;                         ///< By the slots,
    PassedCells m_passedByBasis;                  ///< and by the basis hairs, as they were laid.
    std::vector<std::uint8_t> m_basisRelaid;      ///< [basis hairs]: those that lie otherwise.
    std::vector<std::uint32_t> m_drawnDependents; ///< [basis hairs]: drawn hairs that follow each.
    std::vector<std::uint8_t> m_kinds;            ///< [slots], the braid map.
    std::vector<std::uint8_t> m_braided;          ///< [slots], the same of hairs that are braided: not of tied ones.
    BraidLayout m_braids;
    LockPartition m_locks;
    Hairline m_hairline;
    Gathering m_gathering;
    float m_lockSizeM = 0.0F; ///< That m_locks was made for, of m_roots.
};

} // namespace hairpaint::sim
