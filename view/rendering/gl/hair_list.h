// Which strands of a group are drawn, and where each one's points begin.
#pragma once

#include "sim/groom/groom.h"
#include "view/rendering/gl/packed_style.h"
#include "view/rendering/gl/smooth_segments.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace hairpaint::rendering {

/// A run of strands whose points fit into the renderer's buffers together.
struct StrandBatch
{
    std::uint32_t firstStrand;
    std::uint32_t strandCount;
    std::uint32_t pointCount;
};

/// The drawn strands in steps of detail, so that a coarser picture's list is the beginning of a finer one's. Chunks
/// that did not change keep their part. No OpenGL in it.
class HairList
{
public:
    static constexpr std::uint32_t kBatchPoints = 1U << 20U;

    /// Brings the list up to date; false where nothing differs from the call before.
    bool update(const std::shared_ptr<const sim::Groom>& groom, float detail, SegmentsWanted segments);

    /// The strands and one more, whose firstPoint ends the last one.
    [[nodiscard]] const std::vector<DrawnStrand>& strands() const { return m_strands; }
    [[nodiscard]] const std::vector<StrandBatch>& batches() const { return m_batches; }
    [[nodiscard]] std::size_t strandCount() const { return m_strands.empty() ? 0 : m_strands.size() - 1; }
    [[nodiscard]] std::size_t segmentCount() const { return m_segments; }

private:
    static constexpr std::size_t kSteps = 64; ///< Steps of detail.
    struct IndexedStrand
    {
        std::uint16_t slot;
        std::uint16_t curveSegments; ///< That curl and braid ask for.
        bool hasTipStart;            ///< Its tip colour begins elsewhere than the group's.
        float detail;
    };
    struct ChunkPart
    {
        std::shared_ptr<const sim::StrandChunk> chunk;
        std::vector<IndexedStrand> entries; ///< By step of detail, then slot.
        std::array<std::uint16_t, kSteps + 1> begin{};
    };
    /// `part` names its chunk only when it is done.
    static void index(ChunkPart& part, const std::shared_ptr<const sim::StrandChunk>& from,
                      const sim::CurlSettings* coils);

    std::shared_ptr<const sim::Groom> m_groom;
    float m_detail = -1.0F;
    SegmentsWanted m_wanted;
    std::vector<ChunkPart> m_parts;
    std::vector<DrawnStrand> m_strands;
    std::vector<StrandBatch> m_batches;
    std::size_t m_segments = 0;
};

} // namespace hairpaint::rendering
