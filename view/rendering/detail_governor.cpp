// Chooses how many hairs are drawn, from the time that frames took.
#include "view/rendering/renderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::rendering {
namespace {

/// Below so many hairs the widened strands look like straw, and a frame is hardly faster: most of it is the same
/// whatever is drawn.
constexpr double kLeastHairs = 16'000.0;
constexpr double kLeastDetail = 1.0 / 64.0;
constexpr int kStillSegments = 16;
constexpr double kRefinementMs = 500.0; ///< A still picture is refined in steps that take no longer.

/// Details come in steps, so that lists of strands are not rebuilt for a difference that nobody sees.
float stepped(double detail)
{
    const double steps = std::round(std::log2(std::clamp(detail, kLeastDetail, 1.0)) * 4.0);
    return static_cast<float>(std::exp2(steps / 4.0));
}

} // namespace

DetailGovernor::DetailGovernor(double wantedMs) : m_wantedMs(wantedMs) {}

void DetailGovernor::observe(const FrameStatistics& statistics, std::size_t allHairs, bool still)
{
    // What was right when it last moved; a still picture starts from there.
    const bool begins = still != m_wasStill;
    m_wasStill = still;
    if (!still && begins) {
        m_quality = m_moving;
        m_wantsRefinement = true;
        return; // These statistics are those of the fine picture.
    }
    const double milliseconds = std::max(statistics.milliseconds, 0.1);
    if (still)
        refine(milliseconds, allHairs);
    else
        follow(milliseconds, allHairs);
}

/// Only ever finer: smooth curves and samples first, then more hairs, as long as a frame stays within the limit.
void DetailGovernor::refine(double milliseconds, std::size_t allHairs)
{
    m_wantsRefinement = true;
    const bool wasCoarse = std::exchange(m_quality.coarseHead, false);
    if (m_quality.samples < 4 || m_quality.smoothSegments < kStillSegments) {
        // Four samples cost up to three times as much as one.
        if (milliseconds * 2.0 < kRefinementMs) {
            m_quality.samples = 4;
            m_quality.smoothSegments = kStillSegments;
            return;
        }
    } else if (m_quality.detail < 1.0F && allHairs > 0) {
        const double finer = std::clamp(kRefinementMs / milliseconds, 1.0, 2.0);
        const float next = stepped(static_cast<double>(m_quality.detail) * finer);
        if (next > m_quality.detail) {
            m_quality.detail = next;
            return;
        }
    }
    m_wantsRefinement = wasCoarse;
}

/// Damped, since a part of each frame does not depend on the hairs and single frames may be slow for other reasons.
void DetailGovernor::follow(double milliseconds, std::size_t allHairs)
{
    const double least = std::min(1.0, kLeastHairs / static_cast<double>(std::max<std::size_t>(allHairs, 1)));
    m_slow = milliseconds > m_wantedMs * 1.15 ? m_slow + 1 : 0;
    m_fast = milliseconds < m_wantedMs * 0.70 ? m_fast + 1 : 0;
    const auto detail = static_cast<double>(m_quality.detail);
    if (m_slow >= 2 || milliseconds > 3.0 * m_wantedMs) {
        m_slow = 0;
        if (m_quality.samples > 1)
            m_quality.samples = 1;
        else
            m_quality.detail = stepped(std::max(least, detail * std::clamp(m_wantedMs / milliseconds, 0.4, 0.84)));
    } else if (m_fast >= 4) {
        m_fast = 0;
        if (m_quality.detail < 1.0F)
            m_quality.detail = stepped(detail * 1.19);
        else if (m_quality.samples < 4 && milliseconds * 3.0 < m_wantedMs)
            m_quality.samples = 4;
    }
    m_moving = m_quality;
    m_wantsRefinement = true;
}

} // namespace hairpaint::rendering
