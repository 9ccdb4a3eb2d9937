// The length map that cuts single strands, and leaves those beside them as they are.
#pragma once

#include "model/tools/cutting/length_reads.h"
#include "model/tools/cutting/strand_lengths.h"
#include "model/tools/strokes/stroke_buffer.h"
#include "sim/groom/map_slot.h"
#include "sim/motion/strand_frame.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// A strand that is cut.
struct StrandCut
{
    std::uint32_t slot = 0;
    float kept = 1.0F; ///< 0..1: the fraction of its length, from the root, that stays.
};

/// Each texel belongs to the nearest root of a positioned hair. The texels of cut roots are shortened, except those
/// that an uncut root reads; then they are corrected until the map, interpolated at each cut root, gives the wanted
/// length. Where there are more roots than texels, not every wanted length can be met: uncut hair keeps its length
/// within a millimetre, and some cut hairs stay too long. No texel becomes much less than the hair around it needs.
/// Baby hairs, whose length is not the map's, hold no texel. One thread; cut() uses parallelFor.
class CutLengths
{
public:
    /// `shown`: the group's length map; `lengths`: of that hair. 5 ms for 100,000 hairs.
    CutLengths(const sim::GroupFrame& hair, sim::MapRaster shown, const StrandLengths& lengths);

    /// Replaces the former cuts. Of several cuts of one slot, the one that keeps least counts. `spares`: uncut hairs
    /// change by nothing at all, and more cut hairs stay too long.
    void cut(std::span<const StrandCut> cuts, bool spares);
    /// The tiles that the cuts change, in ascending order.
    [[nodiscard]] const std::vector<int>& tiles() const { return m_tiles; }
    /// Which texels of one of those tiles the cuts change; values(): their values, [64][64].
    [[nodiscard]] const MaskTile& mask(int tileIndex) const { return m_works[workOf(tileIndex)].mask; }
    [[nodiscard]] const std::uint16_t* values(int tileIndex) const { return m_works[workOf(tileIndex)].values.data(); }
    /// The fraction of its length that any texel keeps, 0..1.
    [[nodiscard]] float keptAt(int x, int y) const;
    [[nodiscard]] int size() const { return m_shown->size(); } ///< Side of the map, texels.
    [[nodiscard]] sim::TexelRect tileRect(int tileIndex) const { return m_shown->tileRect(tileIndex); }

private:
    /// The root of a positioned hair.
    struct Root
    {
        std::uint32_t slot = 0;
        bool isBaby = false;
        glm::ivec2 first{0};      ///< The upper left one of the four texels that are read at the root.
        glm::vec2 fraction{0.0F}; ///< The root's position from that texel's centre toward the lower right one's, 0..1.
        [[nodiscard]] glm::vec2 positionTx() const { return glm::vec2(first) + fraction; }
    };
    /// A tile that the cuts change.
    struct Work
    {
        int tile = 0;
        std::vector<LengthTexel> texels; ///< [64][64]
        MaskTile mask{};
        std::vector<std::uint16_t> values = {};
    };

    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    [[nodiscard]] std::size_t workOf(int tileIndex) const
    {
        return static_cast<std::size_t>(m_workOfTile[static_cast<std::size_t>(tileIndex)]);
    }
    /// Whether the root's hair is to stay as it is.
    [[nodiscard]] bool isHeld(std::uint32_t root) const { return m_kept[root] == 1.0F && !m_roots[root].isBaby; }
    [[nodiscard]] float cutValue(float value, float kept) const;
    void findTiles();
    [[nodiscard]] LengthRead readAt(std::uint32_t root);
    void findOwners(int tile);
    void divide(Work& work) const;
    void correct(bool spares);
    [[nodiscard]] std::vector<LengthRead> readsBeside();

    sim::MapRaster m_shown;
    float m_shortestM = 0.0F, m_rangeM = 1.0F; ///< Length at the map's 0, and the length that its range adds, m.
    std::vector<Root> m_roots;
    std::vector<std::uint32_t> m_firstOfTile; ///< [tiles + 1]: index into m_roots, which is ordered by tile.
    std::vector<float> m_reachTx;             ///< [tiles]: greatest distance of a root's texels from it.
    std::vector<std::uint32_t> m_rootOfSlot;
    std::vector<float> m_kept;             ///< By root: the fraction of its length that stays; 1 where it is not cut.
    std::vector<std::uint32_t> m_cutRoots; ///< In ascending order.
    /// [tiles][64][64]: the nearest root, or kNone; empty where no cut has been near.
    std::vector<std::vector<std::uint32_t>> m_owners;
    std::vector<int> m_tiles;
    std::vector<int> m_workOfTile; ///< By tile: index into m_works; -1 for none.
    std::vector<Work> m_works;
};

} // namespace hairpaint::model
