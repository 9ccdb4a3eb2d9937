// Where braids grow: on each painted patch one or several, their roots, and the braid that each hair belongs to.
#pragma once

#include "sim/groom/braid_row.h"
#include "sim/groom/groom.h"
#include "sim/groom/map_sampler.h"
#include "sim/groom/patch_labels.h"
#include "sim/groom/slot_set.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hairpaint::sim {

struct Braid
{
    std::uint32_t root = 0;           ///< The slot on which it stands: a hair of its patch.
    std::uint32_t basis = 0;          ///< The solved hair that it follows: its root's own, or one nearby.
    BraidKind kind = BraidKind::None; ///< What is laced: see lacedKind().
    float lengthM = 0.0F;             ///< Of a cornrow from its end on.
    float radiusM = 0.0F;             ///< r of equation 3: the group's, but no more than its length and its hairs fill.
    std::shared_ptr<const BraidRow> row = nullptr; ///< Of a cornrow, which stands on the hair at its end; else null.
    friend bool operator==(const Braid& a, const Braid& b)
    {
        return a.root == b.root && a.basis == b.basis && a.kind == b.kind && a.lengthM == b.lengthM &&
               a.radiusM == b.radiusM && (a.row == b.row || (a.row && b.row && *a.row == *b.row));
    }
};

/// Touching texels of one kind on which hair grows are a patch, also across seams; so bare or unpainted skin is a
/// parting. A patch of cornrow is one, along it. Another has braids at least the group's spacing apart, then moved to
/// the middle of the hairs that are nearest to them. All its hairs belong to the nearest of them. One thread at a time.
class BraidLayout
{
public:
    struct Inputs
    {
        const RootSet& roots;
        const MapRaster& braid;
        const MapRaster& density;
        std::span<const std::uint8_t> kinds; ///< [slots] BraidKind of hairs that are to be braided, else 0.
        bool otherKinds;                     ///< Some differ from those of the update before.
        const GroupSettings& settings;
        const MapSampler& length;
        std::span<const float> basisLengthM; ///< [basis hairs]
    };
    /// Nothing is braided; what is known of the skin stays for as long as that is the same.
    void startOver();
    /// Adds the hairs whose braid differs. True where any braid does.
    bool update(const Inputs& inputs, SlotSet& dirty);

    [[nodiscard]] std::span<const Braid> braids() const { return m_braids; }
    /// Null: not braided.
    [[nodiscard]] const Braid* of(std::uint32_t slot) const
    {
        return m_braidOfSlot.empty() || m_braidOfSlot[slot] == kNoCentre ? nullptr : &m_braids[m_braidOfSlot[slot]];
    }

private:
    [[nodiscard]] bool updateLabels(const Inputs& inputs);
    void sortByPatch(const Inputs& inputs);
    /// Of one patch; `begin` and `end` in m_members.
    void plant(const Inputs& inputs, std::size_t begin, std::size_t end);
    void borrowBasis(const Inputs& inputs);
    void assignHairs(const Inputs& inputs);
    void measure(const Inputs& inputs);

    std::shared_ptr<const SkinIslands> m_islands;
    PatchLabels m_labels;
    MapRaster m_braid, m_density;
    std::shared_ptr<const TiledRaster> m_laced; ///< The braid map where hair grows, else 0.
    std::vector<Braid> m_braids;
    std::vector<std::uint32_t> m_braidOfSlot; ///< [slots] kNoCentre: none; empty where there is no braid.
    std::vector<std::uint32_t> m_hairCount;   ///< Of each braid.
    // While laying out:
    std::vector<std::uint32_t> m_members;     ///< Slots, patch by patch.
    std::vector<std::uint32_t> m_firstMember; ///< [patches + 1]
    std::vector<std::uint32_t> m_firstBraid;  ///< [patches + 1]
    std::vector<glm::vec3> m_middlesHd;       ///< Of each braid's hairs.
};

} // namespace hairpaint::sim
