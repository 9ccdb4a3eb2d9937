// By the kernel that draws them.
#include "view/picking/curve_batch.h"

#include "sim/groom/strand_curve.h"
#include "view/picking/block_kernel.h"
#include "view/rendering/software/strand_kernel.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>

namespace hairpaint::view {

static_assert(kPickLanes == rendering::kBlockLanes);

CurveBatch::CurveBatch(const PictureHair& picture)
    : m_picture(picture), m_turnWoFromHd(glm::mat3_cast(picture.pose.rotation))
{}

void CurveBatch::evaluate(std::span<const std::uint32_t> slots, std::size_t lastNode)
{
    const sim::Groom& groom = *m_picture.hair->groom;
    rendering::fillBlock(m_block, *m_picture.hair, slots, m_turnWoFromHd);
    int wanted = 1; // By the strand that needs most.
    for (const std::uint32_t slot : slots)
        wanted = std::max(wanted, segmentsASpan(groom, slot));
    const int spans = groom.nodes - 1;
    rendering::SpanSegments segments;
    segments.of.fill(wanted);
    segments.total = segments.of.front() * std::min(static_cast<int>(lastNode), spans);
    m_pointCount = static_cast<std::size_t>(segments.total) + 1;
    m_pointsWo.resize(std::max(m_pointsWo.size(), m_pointCount * 3 * kPickLanes));
    m_seen.resize(m_pointsWo.size());
    rendering::drawnCurves(m_block, segments, m_pointsWo.data());
    seeRows(m_picture.lens, m_pointsWo.data(), m_pointCount, m_seen.data());
}

std::span<const std::uint32_t> CurveBatch::near(const PictureBox& box)
{
    m_near.resize(std::max(m_near.size(), m_pointCount));
    findCurvesNear(m_seen.data(), m_pointCount, box, m_near.data());
    return std::span(m_near).first(m_pointCount);
}

std::span<const float> CurveBatch::alongM()
{
    m_alongM.resize(std::max(m_alongM.size(), m_pointCount * kPickLanes));
    measureCurves(m_pointsWo.data(), m_pointCount, m_alongM.data());
    return std::span(m_alongM).first(m_pointCount * kPickLanes);
}

int CurveBatch::segmentsASpan(const sim::Groom& groom, std::uint32_t slot)
{
    const int spans = groom.nodes - 1;
    return (sim::segmentsOf(groom.style(slot), groom.nodes, sim::coilsOf(groom.settings)) + spans - 1) / spans;
}

} // namespace hairpaint::view
