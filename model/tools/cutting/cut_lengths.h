// The length map that cuts single strands, and leaves those beside them as they are.
#pragma once

#include "model/tools/cutting/length_reads.h"
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

/// Each texel belongs to the nearest root, of the hairs that are positioned. Those of roots that are cut are shortened,
/// except the ones that the map is read from at a root that is not cut; then they are corrected until the map, read
/// between its texels at each root that is cut, gives the length that it should. Where there are more roots than texels
/// not all can be had: no hair stays longer than it is cut then, and some become shorter, also of those that are not
/// cut, but only as far as no texel that matters less to them could be changed. No texel becomes much less than the
/// hair around it needs. One thread; cut() uses parallelFor.
class CutLengths
{
public:
    /// `shown`: the group's length map. 5 ms for 100,000 hairs.
    CutLengths(const sim::GroupFrame& hair, sim::MapRaster shown);

    /// Instead of the cuts before; of one slot's the one that keeps least. `spares`: a hair that is not cut never
    /// changes, and some of those that are stay too long instead.
    void cut(std::span<const StrandCut> cuts, bool spares);
    /// That the cuts change, in ascending order.
    [[nodiscard]] const std::vector<int>& tiles() const { return m_tiles; }
    /// Of one of those tiles: which texels the cuts change, and their values.
    [[nodiscard]] const MaskTile& mask(int tileIndex) const { return m_works[workOf(tileIndex)].mask; }
    [[nodiscard]] const std::uint16_t* values(int tileIndex) const { return m_works[workOf(tileIndex)].values.data(); }
    /// At any texel: the fraction of its length that stays.
    [[nodiscard]] float keptAt(int x, int y) const;
    [[nodiscard]] int size() const { return m_shown->size(); } ///< Of the map, texels a side.
    [[nodiscard]] sim::TexelRect tileRect(int tileIndex) const { return m_shown->tileRect(tileIndex); }

private:
    /// A positioned hair's, by tile.
    struct Root
    {
        std::uint32_t slot = 0;
        glm::ivec2 first{0};      ///< The upper left one of the four texels that are read there.
        glm::vec2 fraction{0.0F}; ///< From its centre toward the lower right one's.
        [[nodiscard]] glm::vec2 positionTx() const { return glm::vec2(first) + fraction; }
    };
    /// A tile that is worked on.
    struct Work
    {
        int tile = 0;
        std::vector<float> wanted;     ///< [64][64], 0..65535.
        std::vector<float> least = {}; ///< What a texel may become.
        MaskTile mask{};
        std::vector<std::uint16_t> values = {};
    };

    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    [[nodiscard]] std::size_t workOf(int tileIndex) const
    {
        return static_cast<std::size_t>(m_workOfTile[static_cast<std::size_t>(tileIndex)]);
    }
    [[nodiscard]] float cutValue(float value, float kept) const;
    void findTiles();
    [[nodiscard]] LengthRead readAt(std::uint32_t root);
    void findOwners(int tile);
    void divide(Work& work) const;
    void findLeast();
    void correct(bool spares);
    [[nodiscard]] std::vector<LengthRead> readsBeside();

    sim::MapRaster m_shown;
    float m_shortestM = 0.0F, m_rangeM = 1.0F; ///< Of the length map.
    std::vector<Root> m_roots;
    std::vector<std::uint32_t> m_firstOfTile; ///< [tiles + 1], into m_roots.
    std::vector<float> m_reachTx;             ///< [tiles]: how far from a root its texels lie, at most.
    std::vector<std::uint32_t> m_rootOfSlot;
    std::vector<float> m_kept;             ///< By root; 1: not cut.
    std::vector<std::uint32_t> m_cutRoots; ///< In ascending order.
    /// [tiles][64][64]: the nearest root, or kNone; empty where no cut has been near.
    std::vector<std::vector<std::uint32_t>> m_owners;
    std::vector<int> m_tiles;
    std::vector<int> m_workOfTile; ///< -1: none.
    std::vector<Work> m_works;
};

} // namespace hairpaint::model
