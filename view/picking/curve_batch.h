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
    [[nodiscard]] glm::vec3 seen(std::size_t point, std::size_t lane) const { return at(m_seen, point, lane); }
    [[nodiscard]] glm::vec3 pointWo(std::size_t point, std::size_t lane) const { return at(m_pointsWo, point, lane); }
    /// See findCurvesNear(): [points]. Until the next evaluate().
    [[nodiscard]] std::span<const std::uint32_t> near(const PictureBox& box);
    /// See measureCurves(): [points][kPickLanes]. Until the next evaluate().
    [[nodiscard]] std::span<const float> alongM();

    /// Segments a span of the skeleton that a strand asks for: those of a batch should ask for the same.
    [[nodiscard]] static int segmentsASpan(const sim::Groom& groom, std::uint32_t slot);

private:
    [[nodiscard]] static glm::vec3 at(const std::vector<float>& rows, std::size_t point, std::size_t lane)
    {
        const float* row = rows.data() + point * 3 * kPickLanes + lane;
        return {row[0], row[kPickLanes], row[2 * kPickLanes]};
    }

    const PictureHair& m_picture;
    glm::mat3 m_turnWoFromHd;
    rendering::StrandBlock m_block;
    std::vector<float> m_pointsWo, m_seen, m_alongM;
    std::vector<std::uint32_t> m_near;
    std::size_t m_pointCount = 0;
};

} // namespace hairpaint::view
