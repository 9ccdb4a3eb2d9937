// The comparison of two frames.
#include "view/head/stillness.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr double kMostPx = 1.0;
constexpr std::size_t kRows = 1024; ///< Of 16 nodes each, in every group.

bool sameHair(const sim::StrandFrame& a, const sim::StrandFrame& b)
{
    return a.pose == b.pose &&
           std::ranges::equal(a.groups, b.groups, [](const sim::GroupFrame& one, const sim::GroupFrame& other) {
               return one.groom == other.groom && one.positions.size() == other.positions.size();
           });
}

/// The farthest that a sampled node lies from where it was, m.
float farthest(const std::vector<float>& now, const std::vector<float>& before)
{
    constexpr std::size_t kRow = 3 * sim::kLanes;
    const std::size_t rows = now.size() / kRow;
    const std::size_t step = std::max<std::size_t>(1, rows / kRows) | 1U; // Odd: every node's turn comes, tips too.
    float greatest = 0.0F;
    for (std::size_t row = 0; row < rows; row += step)
        for (std::size_t lane = row * kRow; lane < row * kRow + sim::kLanes; ++lane) {
            const float x = now[lane] - before[lane];
            const float y = now[lane + sim::kLanes] - before[lane + sim::kLanes];
            const float z = now[lane + 2 * sim::kLanes] - before[lane + 2 * sim::kLanes];
            greatest = std::max(greatest, x * x + y * y + z * z);
        }
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
        moves =
            frame->groups[i].groom && frame->groups[i].groom->visible &&
            static_cast<double>(farthest(frame->groups[i].positions, before->groups[i].positions)) * pxPerM > kMostPx;
    if (moves)
        m_shown = frame;
    return moves;
}

} // namespace hairpaint::view
