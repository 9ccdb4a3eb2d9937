// One moment of the moving hair, as the worker hands it to the renderer.
#pragma once

#include "sim/groom/groom.h"
#include "sim/skin/neck.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace hairpaint::sim {

/// Where the head stands in the world: the hair swings when it turns.
struct HeadPose
{
    glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
    glm::vec3 positionWo{0.0F};
    friend bool operator==(const HeadPose&, const HeadPose&) = default;
};

struct GroupFrame
{
    std::shared_ptr<const Groom> groom;
    /// Skeleton nodes of every slot of every positioned chunk: [positionedChunks][kBlocksPerChunk][nodes][3][kLanes],
    /// Wo, m. Slots that are no hair hold zeros. Empty where the group is hidden.
    std::vector<float> positions;
    /// 0..1: only hairs whose StrandStyle::detail is below it have positions of this moment; 1: all.
    float detail = 1.0F;

    /// Whether a slot's nodes are those of a drawn hair at this moment.
    [[nodiscard]] bool isPositioned(std::size_t slot) const
    {
        return groom->isDrawn(slot) && groom->style(slot).detail < detail;
    }
    /// visit(block) for each block of positions in which hairs are positioned.
    template<class Visit>
    void forEachPositionedBlock(const Visit& visit) const
    {
        if (!groom || positions.empty())
            return;
        for (std::size_t chunk = 0; chunk < groom->chunks.size(); ++chunk) {
            if (!groom->chunks[chunk] || groom->packedChunk[chunk] < 0)
                continue;
            for (std::size_t block = 0; block < kBlocksPerChunk; ++block)
                if (groom->chunks[chunk]->leastDetail[block] < detail)
                    visit(static_cast<std::size_t>(groom->packedChunk[chunk]) * kBlocksPerChunk + block);
        }
    }
};

/// Immutable once published.
struct StrandFrame
{
    std::vector<GroupFrame> groups;
    HeadPose pose;
    Neck neck; ///< Whose shoulders do not turn with the head.
    double simulatedSeconds = 0.0;
    double stepMilliseconds = 0.0; ///< Time that the last step took, all groups.
    std::size_t hairCount = 0;
    std::size_t basisCount = 0;
    HairLimit limit = HairLimit::None; ///< The limit of the first group that has one.
    bool asleep = false;               ///< Nothing moves: no newer frame will come until something changes.
    std::uint64_t number = 0;
    std::uint64_t revision = 0;     ///< GroomInput::revision of the input that the hair was made from.
    bool preview = false;           ///< That input held something not committed yet.
    std::size_t rebuiltStrands = 0; ///< Number of strands evaluated since the first frame.
};

/// The least GroupFrame::detail; 1 where every hair is positioned.
[[nodiscard]] inline float frameDetail(const StrandFrame& frame)
{
    float least = 1.0F;
    for (const GroupFrame& group : frame.groups)
        least = std::min(least, group.detail);
    return least;
}

} // namespace hairpaint::sim
