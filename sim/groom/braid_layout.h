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
    float lengthM = 0.0F;             ///< From its root to its tip; for a cornrow from the row's end on.
    float radiusM = 0.0F;             ///< r of equation 3: the group's, but no more than its length and its hairs fill.
    /// A cornrow's course, whose `root` is the hair at its end; null for others.
    std::shared_ptr<const BraidRow> row = nullptr;
    friend bool operator==(const Braid& a, const Braid& b)
    {
        return a.root == b.root && a.basis == b.basis && a.kind == b.kind && a.lengthM == b.lengthM &&
               a.radiusM == b.radiusM && (a.row == b.row || (a.row && b.row && *a.row == *b.row));
    }
};

/// Touching texels of one kind on which hair grows are a patch, also across seams; so bare or unpainted skin is a
/// parting. A cornrow's patch is a single braid along it; texels of another row's number are another patch. Another
/// patch has braids at least the group's spacing apart, each then moved to the middle of the hairs that are nearest to
/// it. All hairs of a patch belong to its nearest braid. One thread at a time.
class BraidLayout
{
public:
    struct Inputs
    {
        const RootSet& roots;
        const MapRaster& braid;
        const MapRaster& density;
        std::span<const std::uint8_t> kinds; ///< [slots] BraidKind of hairs that are to be braided, else 0.
        bool otherKinds;                     ///< Some `kinds` differ from those of the update before.
        const GroupSettings& settings;
        const MapSampler& length;
        std::span<const float> basisLengthM; ///< [basis hairs]
    };
    /// Removes all braids; the islands of the skin are kept for as long as the skin is the same.
    void startOver();
    /// Adds the hairs whose braid differs to `dirty`. Returns whether any braid differs.
    bool update(const Inputs& inputs, SlotSet& dirty);

    [[nodiscard]] std::span<const Braid> braids() const { return m_braids; }
    /// The braid of a hair; null where it is not braided.
    [[nodiscard]] const Braid* of(std::uint32_t slot) const
    {
        return m_braidOfSlot.empty() || m_braidOfSlot[slot] == kNoCentre ? nullptr : &m_braids[m_braidOfSlot[slot]];
    }

private:
    [[nodiscard]] bool updateLabels(const Inputs& inputs);
    void sortByPatch(const Inputs& inputs);
    /// Adds the braids of one patch, whose hairs are m_members[begin..end).
    void plant(const Inputs& inputs, std::size_t begin, std::size_t end);
    void borrowBasis(const Inputs& inputs);
    void assignHairs(const Inputs& inputs);
    void measure(const Inputs& inputs);

    std::shared_ptr<const SkinIslands> m_islands;
    PatchLabels m_labels;
    MapRaster m_braid, m_density;
    std::shared_ptr<const TiledRaster> m_laced; ///< The braid map where hair grows, 0 elsewhere.
    std::vector<Braid> m_braids;
    std::vector<std::uint32_t> m_braidOfSlot; ///< [slots] kNoCentre: none; empty where there is no braid.
    std::vector<std::uint32_t> m_hairCount;   ///< [braids] number of hairs.
    // While laying out:
    std::vector<std::uint32_t> m_members;     ///< Slots, patch by patch.
    std::vector<std::uint32_t> m_firstMember; ///< [patches + 1]
    std::vector<std::uint32_t> m_firstBraid;  ///< [patches + 1]
    std::vector<glm::vec3> m_middlesHd;       ///< [braids] the middle of each one's hairs.
};

} // namespace hairpaint::sim
