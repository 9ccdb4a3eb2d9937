// By the kernel that draws them.
#include "view/picking/curve_batch.h"

#include "sim/groom/strand_curve.h"
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
    int wanted = 1; // Segments of the strand that needs most.
    for (const std::uint32_t slot : slots)
        wanted = std::max(wanted, sim::segmentsOf(groom.style(slot), groom.nodes, m_block.coils));
    const int spans = groom.nodes - 1;
    rendering::SpanSegments segments;
    segments.of.fill((wanted + spans - 1) / spans);
    segments.total = segments.of.front() * std::min(static_cast<int>(lastNode), spans);
    m_pointCount = static_cast<std::size_t>(segments.total) + 1;
    m_pointsWo.resize(std::max(m_pointsWo.size(), m_pointCount * 3 * kPickLanes));
    m_seen.resize(m_pointsWo.size());
    rendering::drawnCurves(m_block, segments, m_pointsWo.data());
    for (std::size_t i = 0; i < m_pointCount; ++i)
        m_picture.lens.seen(m_pointsWo.data() + i * 3 * kPickLanes, m_seen.data() + i * 3 * kPickLanes);
}

} // namespace hairpaint::view
