// One moment of the moving hair, as the worker hands it to the renderer.
#pragma once

#include "sim/groom/groom.h"
#include "sim/skin/neck.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

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
    /// Skeleton nodes of every slot of every placed chunk: [placedChunks][kBlocksPerChunk][nodes][3][kLanes], Wo, m.
    /// Slots that are no hair hold zeros. Empty where the group is hidden.
    std::vector<float> positions;
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
    HairLimit limit = HairLimit::None; ///< Of the first group that feels one.
    bool asleep = false;               ///< Nothing moves: no newer frame will come until something changes.
    std::uint64_t number = 0;
    std::uint64_t revision = 0;     ///< Of the input that the hair was made from.
    bool preview = false;           ///< That input held something not committed yet.
    std::size_t rebuiltStrands = 0; ///< Evaluated since the first frame, in all.
};

} // namespace hairpaint::sim
