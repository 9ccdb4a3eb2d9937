// Chooses how many hairs are drawn, from the time that frames took.
#include "view/rendering/renderer.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::rendering {
namespace {

constexpr float kLeastDetail = 1.0F / 64.0F;
constexpr double kRefinementMs = 250.0; ///< A still picture is refined in steps that take no longer.

/// Details come in steps, so that lists of strands are not rebuilt for a difference that nobody sees.
float stepped(double detail)
{
    const double steps = std::round(std::log2(std::clamp(detail, static_cast<double>(kLeastDetail), 1.0)) * 4.0);
    return static_cast<float>(std::exp2(steps / 4.0));
}

} // namespace

DetailGovernor::DetailGovernor(double wantedMs) : m_wantedMs(wantedMs) {}

void DetailGovernor::observe(const FrameStatistics& statistics, std::size_t allHairs, bool still)
{
    const double milliseconds = std::max(statistics.milliseconds, 0.1);
    const double limit = still ? kRefinementMs : m_wantedMs;
    if (!still && m_wasStill)
        m_quality = m_moving; // What was right when it last moved.
    m_wasStill = still;

    // Part of a frame does not depend on the hairs, so the answer is damped; it also keeps single slow frames harmless.
    const double ratio = std::clamp(limit / milliseconds, 0.4, 2.0);
    const double detail = static_cast<double>(m_quality.detail);
    const bool fits = ratio > (still ? 1.3 : 0.85) && ratio < 1.3;
    const float next = fits ? m_quality.detail : stepped(detail * (ratio > 1.0 ? std::sqrt(ratio) : ratio));
    if (still) {
        // Only ever finer: more hairs first, then more samples.
        if (ratio > 1.3 && m_quality.detail < 1.0F && allHairs > 0)
            m_quality.detail = std::max(next, stepped(detail * 1.2));
        else if (m_quality.samples < 4)
            m_quality.samples = 4;
        else {
            m_wantsRefinement = false;
            return;
        }
        m_wantsRefinement = true;
        return;
    }
    m_quality.detail = next;
    m_quality.samples = m_quality.samples >= 4 && next > 0.5F ? 4 : (next >= 1.0F && ratio > 1.9 ? 4 : 1);
    m_moving = m_quality;
    m_wantsRefinement = true;
}

} // namespace hairpaint::rendering
