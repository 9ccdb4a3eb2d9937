// Chooses how many hairs are drawn, from the time that frames took.
#include "view/rendering/detail_governor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hairpaint::rendering {
namespace {

/// Below so many hairs the widened strands look like straw, and a frame is hardly faster: most of it is the same
/// whatever is drawn.
constexpr double kLeastHairs = 16'000.0;
constexpr double kLeastDetail = 1.0 / 64.0;

/// Details come in steps, so that lists of strands are not rebuilt for a difference that nobody sees.
float stepped(double detail)
{
    const double steps = std::round(std::log2(std::clamp(detail, kLeastDetail, 1.0)) * 4.0);
    return static_cast<float>(std::exp2(steps / 4.0));
}

} // namespace

DetailGovernor::DetailGovernor(double wantedMs, float firstDetail)
    : m_wantedMs(wantedMs), m_quality{.detail = firstDetail, .samples = 1, .coarseHead = true}
{}

const Quality& DetailGovernor::begin(bool still)
{
    if (std::exchange(m_still, still) != still) {
        // What was right when it last moved; a still picture starts from there.
        m_quality = m_moving;
        m_whole = m_moving;
        m_retreated = false;
        m_wantsRefinement = true;
    }
    return m_quality;
}

void DetailGovernor::observe(const FrameStatistics& statistics, std::size_t allHairs)
{
    if (!statistics.complete)
        retreat();
    else if (m_still)
        refine();
    else
        follow(std::max(statistics.milliseconds, 0.1), statistics.drawnHairs, allHairs);
}

/// Memory is short. A moving picture becomes coarser as if it had been far too slow; a still one goes back to what was
/// drawn whole, once, and stays there: trying again and again would only keep the machine busy.
void DetailGovernor::retreat()
{
    if (!m_still) {
        follow(std::numeric_limits<double>::infinity(), 0, std::numeric_limits<std::size_t>::max());
        return;
    }
    m_wantsRefinement = !std::exchange(m_retreated, true);
    m_quality = m_whole;
}

/// Only ever finer: samples first, then twice as many hairs at a time.
void DetailGovernor::refine()
{
    m_whole = m_quality;
    if (m_retreated) {
        m_wantsRefinement = false;
        return;
    }
    const Quality finest = pictureQuality();
    const bool smooth = m_quality.samples >= finest.samples;
    m_wantsRefinement = m_quality.coarseHead || !smooth || m_quality.detail < finest.detail;
    m_quality.coarseHead = false;
    if (!smooth)
        m_quality.samples = finest.samples;
    else
        m_quality.detail = std::min(m_quality.detail * 2.0F, finest.detail);
}

/// Damped, since a part of each frame does not depend on the hairs and single frames may be slow for other reasons.
void DetailGovernor::follow(double milliseconds, std::size_t drawnHairs, std::size_t allHairs)
{
    const double least = std::min(1.0, kLeastHairs / static_cast<double>(std::max<std::size_t>(allHairs, 1)));
    m_slow = milliseconds > m_wantedMs * 1.15 ? m_slow + 1 : 0;
    m_fast = milliseconds < m_wantedMs * 0.93 ? m_fast + 1 : 0;
    const auto detail = static_cast<double>(m_quality.detail);
    // A renderer that draws fewer than it is asked for, since more could not be told apart, feels only what is below.
    const double felt =
        drawnHairs > 0
            ? std::min(detail, static_cast<double>(drawnHairs) / static_cast<double>(std::max(allHairs, drawnHairs)))
            : detail;
    if (m_slow >= 2 || milliseconds > 3.0 * m_wantedMs) {
        m_slow = 0;
        if (m_quality.samples > 1)
            m_quality.samples = 1;
        else
            m_quality.detail = stepped(std::max(least, felt * std::clamp(m_wantedMs / milliseconds, 0.4, 0.84)));
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
