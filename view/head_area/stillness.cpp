// The comparison of two frames.
#include "view/head_area/stillness.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr double kMostPx = 1.0;
constexpr std::size_t kRows = 1024; ///< Rows of 16 nodes that are compared in each group, about.

bool sameHair(const sim::StrandFrame& a, const sim::StrandFrame& b)
{
    return a.pose == b.pose &&
           std::ranges::equal(a.groups, b.groups, [](const sim::GroupFrame& one, const sim::GroupFrame& other) {
               return one.groom == other.groom && one.positions.size() == other.positions.size();
           });
}

/// The farthest that a sampled node, of those that both frames hold, lies from where it was, m.
float farthest(const sim::GroupFrame& now, const sim::GroupFrame& before)
{
    constexpr std::size_t kRow = sim::StrandBlocks::kNodeStride;
    const sim::GroupFrame& coarser = now.detail < before.detail ? now : before;
    const auto nodes = static_cast<std::size_t>(now.groom->nodes);
    std::size_t blocks = 0;
    coarser.forEachPositionedBlock([&](std::size_t) { ++blocks; });
    const std::size_t step =
        std::max<std::size_t>(1, blocks * nodes / kRows) | 1U; // Odd: every node's turn comes, tips too.
    float greatest = 0.0F;
    std::size_t number = 0;
    coarser.forEachPositionedBlock([&](std::size_t block) {
        for (std::size_t node = 0; node < nodes; ++node) {
            if (number++ % step != 0)
                continue;
            const std::size_t row = (block * nodes + node) * kRow;
            for (std::size_t lane = row; lane < row + sim::kLanes; ++lane) {
                const glm::vec3 step3 = sim::StrandBlocks::load(now.positions.data() + lane) -
                                        sim::StrandBlocks::load(before.positions.data() + lane);
                greatest = std::max(greatest, glm::dot(step3, step3));
            }
        }
    });
    return std::sqrt(greatest);
}

} // namespace

bool Stillness::moved(const std::shared_ptr<const sim::StrandFrame>& frame, const rendering::Camera& camera,
                      QSize areaPx)
{
    const std::shared_ptr<const sim::StrandFrame> before = m_shown;
    if (frame == before)
        return false;
    bool moves = !frame || !before || !sameHair(*frame, *before);
    const double pxPerM =
        areaPx.height() / (2.0 * static_cast<double>(camera.distanceM * std::tan(camera.fieldOfViewRad / 2.0F)));
    for (std::size_t i = 0; !moves && i < frame->groups.size(); ++i)
        moves = frame->groups[i].groom && frame->groups[i].groom->visible &&
                static_cast<double>(farthest(frame->groups[i], before->groups[i])) * pxPerM > kMostPx;
    if (moves)
        m_shown = frame;
    return moves;
}

} // namespace hairpaint::view
