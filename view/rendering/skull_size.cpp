// Measures the upper head.
#include "view/rendering/skull_size.h"

#include <algorithm>
#include <cstddef>

namespace hairpaint::rendering {
namespace {

float measuredM(const sim::HeadMesh& head)
{
    const std::size_t step = std::max<std::size_t>(1, head.positionsHd.size() / 1024);
    float top = 0.0F;
    for (std::size_t i = 0; i < head.positionsHd.size(); i += step)
        top = std::max(top, head.positionsHd[i].y);
    float sum = 0.0F;
    int count = 0;
    for (std::size_t i = 0; i < head.positionsHd.size(); i += step)
        if (head.positionsHd[i].y > 0.3F * top) {
            sum += glm::length(head.positionsHd[i]);
            ++count;
        }
    return count > 0 ? sum / static_cast<float>(count) : 0.0F;
}

} // namespace

float SkullSize::radiusM(const std::shared_ptr<const sim::HeadMesh>& head)
{
    if (head != m_head) {
        m_head = head;
        m_radiusM = head ? measuredM(*head) : 0.0F;
    }
    return m_radiusM;
}

} // namespace hairpaint::rendering
