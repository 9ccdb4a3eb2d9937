// The groom: every hair's style and rest shape, in immutable chunks.
#pragma once

#include "sim/base/strand_blocks.h"
#include "sim/groom/groom_input.h"
#include "sim/groom/roots.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <vector>

namespace hairpaint::sim {

inline constexpr float kShortestDrawnM = 1e-4F; ///< Shorter hairs count, but are neither drawn nor exported.

enum class BraidKind : std::uint8_t
{
    None = 0,
    Plait = 1,
    Twist = 2,
    Loc = 3,
    PlaitOfFour = 4,
    PlaitOfFive = 5,
    Fishtail = 6,
    Cornrow = 7 ///< A plait along the skin. In the braid map only; styles hold Plait for it.
};
inline constexpr BraidKind kLastBraidKind = BraidKind::Cornrow;
/// The greatest number in the braid map.
inline constexpr std::uint16_t kLastRowNumber = 1023;
/// What a number of the braid map stands for. Those from Cornrow on are all cornrows: rows of different numbers stay
/// two where they touch.
[[nodiscard]] constexpr BraidKind braidKindOf(std::uint16_t painted)
{
    return painted < static_cast<std::uint16_t>(kLastBraidKind) ? static_cast<BraidKind>(painted) : kLastBraidKind;
}
[[nodiscard]] constexpr BraidKind lacedKind(BraidKind painted)
{
    return painted == BraidKind::Cornrow ? BraidKind::Plait : painted;
}

/// What a strand looks like. Rendering packs it for the GPU (view/rendering/gl/packed_style.h).
struct StrandStyle
{
    float lengthM = 0.0F; ///< The skeleton's; a braided hair's path over the scalp and its braid together.
    float turns = 0.0F;   ///< Turns of equation 1's coil over the whole hair.
    float curlRadiusM = 0.0F;
    float phase = 0.0F; ///< t at the root, rad; where a hair joins a cornrow, the row's turns before that point.
    std::uint32_t rootColour = 0; ///< 0xAABBGGRR, sRGB as encoded.
    std::uint32_t tipColour = 0;
    float width = 1.0F;  ///< Diameter as a multiple of the material's.
    float detail = 2.0F; ///< threshold/density, 0..1: drawn at level of detail f where detail < f; 2: never drawn.
    float braidRadiusM = 0.0F; ///< r of equation 3.
    /// Fraction of the skeleton, 0..1, where the braid begins: node braidStart * (nodes - 1) stands on the centre's
    /// root, those before it lie on the scalp, those after it follow the centre's skeleton, evenly to its tip. Of hair
    /// that is gathered the fraction where its ring is; before it no hair curls.
    float braidStart = 0.0F;
    float braidTurns = 0.0F;    ///< Turns of equation 3 from braidStart to the tip.
    glm::vec2 wispOffset{0.0F}; ///< Position inside the wisp, in units of the wisp's radius.
    float variation = 0.0F;     ///< -1..1, this hair's own lightness.
    BraidKind braid = BraidKind::None;
    std::uint8_t wisp = 0;                                        ///< wispNumber() in the low four bits, and kTautBit.
    std::uint16_t gloss = ruleOf(MapSlot::Gloss).defaultValue[0]; ///< The gloss map's: 65535 is 1.
    float frizzM = 0.0F;   ///< m: how far it strays from its course at the tip, at most; a short hair strays less.
    float tipStart = 0.0F; ///< The tip start map's value, 0..1; 0 where the tip has the root's colour.
    std::uint16_t braidTaper = 0;  ///< 0..255: GroupSettings::braidTaper in 255ths,
    std::uint16_t braidTied = 255; ///< and braidTie.

    static constexpr std::uint8_t kTautBit = 0x80;
    [[nodiscard]] std::uint8_t wispNumber() const { return wisp & 15U; }
    /// It begins taut on the head, so that its curve bends from the root on.
    [[nodiscard]] bool isTaut() const { return (wisp & kTautBit) != 0; }
};

/// Basis hairs that a hair follows, and how much.
struct Followed
{
    std::array<std::uint32_t, RootSet::kNeighbours> basis{};
    std::array<float, RootSet::kNeighbours> weights{}; ///< Sum to 1; all 0 where there is none to follow.
    friend bool operator==(const Followed&, const Followed&) = default;
};

/// What the hair of a cornrow has beside its style.
struct CornrowHair
{
    float end = 0.0F;       ///< Fraction of its skeleton at which it leaves the skin; 0: in no cornrow.
    float tailM = 0.0F;     ///< Its braid's length from there on.
    glm::vec3 endHd{0.0F};  ///< Where it leaves the skin.
    glm::vec3 sideHd{0.0F}; ///< Unit: across the row, along the skin.
    friend bool operator==(const CornrowHair&, const CornrowHair&) = default;
};

/// 1024 slots. Hd, m.
struct StrandChunk
{
    std::bitset<kChunkSlots> hairs;    ///< Slots that are hairs.
    std::bitset<kChunkSlots> drawn;    ///< Those long enough to be drawn and exported.
    std::vector<StrandStyle> styles;   ///< [kChunkSlots]
    std::vector<float> restPositions;  ///< [kBlocksPerChunk][nodes][3][kLanes]; clump already in it.
    std::vector<float> segmentLengths; ///< [kBlocksPerChunk][kLanes]: distance of neighbouring nodes (their mean
                                       ///< where braided); 0 where no hair.
    std::vector<float>
        clump; ///< [kChunkSlots], 0..1: how far each hair lies on its nearest basis hair, and follows it.
    /// For braided hairs: index into basis hairs of the braid's centre, else kNoCentre.
    std::vector<std::uint32_t> braidCentre; ///< [kChunkSlots]
    /// [kChunkSlots] the basis hair that leads each hair's lock; empty where that is the nearest one.
    std::vector<std::uint32_t> lockLeader;
    /// The least StrandStyle::detail in a block: at a coarser level of detail nothing of it is drawn.
    std::array<float, kBlocksPerChunk> leastDetail{};
    std::bitset<kChunkSlots> gathered; ///< Hairs that lie taut to a tie: their segmentLengths are 0.
    std::bitset<kChunkSlots> tailed;   ///< Those of them whose nodes from the ring on move, see Groom::tails.
    std::vector<CornrowHair> cornrows; ///< [kChunkSlots]; empty where none is in one.
    /// [kChunkSlots] the basis hairs that each hair follows; empty where all follow those nearest on the skin.
    std::vector<Followed> followed;
};
inline constexpr std::uint32_t kNoCentre = 0xFFFFFFFFU;

/// What a solved hair carries beside its rest shape, a number each. Whatever makes room for them, copies or compares
/// them goes over all.
enum class BasisQuantity : std::uint8_t
{
    SegmentLength, ///< m; never 0 for a real basis hair.
    Gel,           ///< 0..1
    Give,          ///< Fraction of its length by which a coil stretches or shortens; else 0.
    Girth,         ///< m: half the thickness of the braid it is in; else 0.
    Height,        ///< 0..1: height in the coat, times volumeM (see PhysicsSettings).
    Count
};
inline constexpr auto kBasisQuantities = static_cast<std::size_t>(BasisQuantity::Count);

/// The solved hairs' own styles, in blocks of 16 in the order of RootSet::basisSlot, padded with zero length.
struct BasisStyles
{
    std::vector<float> restPositions;                         ///< [blocks][nodes][3][kLanes]
    std::array<std::vector<float>, kBasisQuantities> numbers; ///< By BasisQuantity: [blocks][kLanes].
    std::vector<std::uint32_t> wanted; ///< [blocks]: bit per lane, whether the hair or a dependent of it is drawn.

    /// Zeros, and no hair wanted.
    void resize(int nodes, std::size_t blocks)
    {
        restPositions.assign(StrandBlocks(nodes).floatsFor(blocks), 0.0F);
        for (std::vector<float>& lanes : numbers)
            lanes.assign(blocks * kLanes, 0.0F);
        wanted.assign(blocks, 0U);
    }
    [[nodiscard]] std::size_t blockCount() const { return wanted.size(); }
    /// [blocks][kLanes]
    [[nodiscard]] std::vector<float>& operator[](BasisQuantity one) { return numbers[static_cast<std::size_t>(one)]; }
    [[nodiscard]] const std::vector<float>& operator[](BasisQuantity one) const
    {
        return numbers[static_cast<std::size_t>(one)];
    }
};

/// Where a slot is: chunk and index in it.
[[nodiscard]] constexpr std::size_t chunkOf(std::size_t slot)
{
    return slot / kChunkSlots;
}
[[nodiscard]] constexpr std::size_t inChunk(std::size_t slot)
{
    return slot % kChunkSlots;
}

/// What keeps a group from having all the candidates that its density asks for.
enum class HairLimit : std::uint8_t
{
    None,
    MaxHairs, ///< The project's limit on candidates.
    Memory    ///< What all nodes may take.
};

/// Immutable once shared. Chunks without any hair are null.
struct Groom
{
    int groupId = 0;
    bool visible = true;
    GroupSettings settings;
    MapRaster density; ///< The density and colour maps that it was made from,
    MapRaster colour;  ///< kept for the tint of the skin between the hairs.
    std::shared_ptr<const RootSet> roots;
    int nodes = 8;
    std::vector<std::shared_ptr<const StrandChunk>> chunks; ///< ceil(candidates / kChunkSlots)
    /// Index of each chunk's first position in StrandFrame's array, in units of chunks; -1 where null.
    std::vector<std::int32_t> packedChunk;
    std::int32_t packedChunks = 0;
    std::shared_ptr<const BasisStyles> basis;
    std::size_t hairCount = 0;
    std::size_t drawnCount = 0; ///< Also the number exported.
    std::size_t basisCount = 0; ///< Basis hairs that are wanted.
    HairLimit limit = HairLimit::None;
    /// What hangs from the ties, or null: a groom of as many nodes as there are from the ring on. Its strands are those
    /// of the same slots, its solved hairs those of the same basis hairs, and both begin in the ring.
    std::shared_ptr<const Groom> tails;
    bool isOfTails = false; ///< It is such a groom: where its strands begin may move on the head.

    [[nodiscard]] StrandBlocks blocks() const { return StrandBlocks(nodes); }
    [[nodiscard]] bool isDrawn(std::size_t slot) const
    {
        const std::size_t chunk = chunkOf(slot);
        return chunk < chunks.size() && chunks[chunk] && packedChunk[chunk] >= 0 && chunks[chunk]->drawn[inChunk(slot)];
    }
    /// The style of a slot whose chunk is there.
    [[nodiscard]] const StrandStyle& style(std::size_t slot) const
    {
        return chunks[chunkOf(slot)]->styles[inChunk(slot)];
    }
    /// Which strand of a StrandFrame's positions a slot of a positioned chunk is.
    [[nodiscard]] std::size_t frameStrand(std::size_t slot) const
    {
        return static_cast<std::size_t>(packedChunk[chunkOf(slot)]) * kChunkSlots + inChunk(slot);
    }
};

/// Builds grooms, and rebuilds what differs from the input before. One thread at a time; loops run through parallelFor.
class GroomBuilder
{
public:
    GroomBuilder();
    ~GroomBuilder();
    GroomBuilder(const GroomBuilder&) = delete;
    GroomBuilder& operator=(const GroomBuilder&) = delete;

    struct Report
    {
        std::vector<std::shared_ptr<const Groom>> grooms; ///< In the input's order.
        std::size_t rebuiltStrands = 0;                   ///< Slots whose style was evaluated this time.
        /// Those slots of the last group touched; filled only after setCollectSlots(true).
        std::vector<std::uint32_t> rebuiltSlots;
    };
    void setCollectSlots(bool collect);
    /// Incremental: only candidates whose map values differ are evaluated; gives the same bytes as a fresh builder.
    [[nodiscard]] Report update(const GroomInput& input);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace hairpaint::sim
