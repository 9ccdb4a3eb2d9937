// Drawn curves of several strands of a picture at once.
#pragma once

#include "view/picking/picture_hair.h"
#include "view/rendering/software/strand_block.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::view {

/// Keeps its memory from batch to batch. The same numbers on any machine. One thread.
class CurveBatch
{
public:
    /// `picture` must outlive it.
    explicit CurveBatch(const PictureHair& picture);

    /// Positioned strands, one to kPickLanes, a lane each, from their roots as far as a node.
    void evaluate(std::span<const std::uint32_t> slots, std::size_t lastNode);
    [[nodiscard]] std::size_t pointCount() const { return m_pointCount; }
    /// [3][kPickLanes]: px and depth, as Lens gives them.
    [[nodiscard]] const float* seen(std::size_t point) const { return m_seen.data() + point * 3 * kPickLanes; }

private:
    const PictureHair& m_picture;
    glm::mat3 m_turnWoFromHd;
    rendering::StrandBlock m_block;
    std::vector<float> m_pointsWo, m_seen;
    std::size_t m_pointCount = 0;
};

} // namespace hairpaint::view
