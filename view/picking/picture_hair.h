// The hair of a group in one picture of the 3D area: what every question about it needs.
#pragma once

#include "view/picking/block_kernel.h"
#include "view/picking/hair_boxes.h"
#include "view/picking/skin_depths.h"

#include <algorithm>
#include <vector>

namespace hairpaint::view {

/// Immutable, but for its frame's life, which is its owner's.
struct PictureHair
{
    const sim::GroupFrame* hair = nullptr; ///< Not null.
    sim::HeadPose pose;
    Lens lens;
    HairBoxes boxes;
    SkinDepths skin;

    /// The drawn curve of a positioned hair: Wo, root first.
    void drawnCurve(std::uint32_t slot, std::vector<glm::vec3>& points) const;
    /// A block of the boxes' and its strands, and nowhere to look yet.
    [[nodiscard]] BlockQuestion questionOf(std::size_t block) const
    {
        const sim::Groom& groom = *hair->groom;
        const std::size_t first = groom.frameStrand(boxes.blocks[block].firstSlot);
        BlockQuestion question;
        question.nodesWo = hair->positions.data() + groom.blocks().index(first, 0);
        question.nodes = static_cast<std::size_t>(groom.nodes);
        question.straysM = boxes.strays.data() + block * kPickLanes;
        question.lanes = boxes.blocks[block].lanes;
        return question;
    }
    [[nodiscard]] glm::vec3 inHead(glm::vec3 positionWo) const
    {
        return glm::conjugate(pose.rotation) * (positionWo - pose.positionWo);
    }
};

/// Tasks whose number does not depend on that of the threads, and what each found, put together in their order.
template<class T>
[[nodiscard]] std::vector<T> joined(const std::vector<std::vector<T>>& parts)
{
    std::size_t count = 0;
    for (const std::vector<T>& part : parts)
        count += part.size();
    std::vector<T> whole;
    whole.reserve(count);
    for (const std::vector<T>& part : parts)
        whole.insert(whole.end(), part.begin(), part.end());
    return whole;
}

} // namespace hairpaint::view
