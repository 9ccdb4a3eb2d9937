// Chooses the level of detail of the next frame.
#pragma once

#include "view/rendering/backend.h"

#include <cstddef>

namespace hairpaint::rendering {

/// While something moves it picks `detail` from the measured time of frames, so that drawing stays near the wanted
/// time. A still picture is refined step by step to pictureQuality(), however long that takes: whoever draws stops when
/// something moves. Where OpenGL gave up on a part of a frame, the next one is coarser.
class DetailGovernor
{
public:
    /// `wantedMs`: time a frame may take while something moves. `firstDetail`: what the first ones are drawn with.
    explicit DetailGovernor(double wantedMs = 33.0, float firstDetail = 0.25F);
    /// Before each frame: whether the picture is still (no motion, no input). Returns the quality to draw with.
    const Quality& begin(bool still);
    /// After each frame that was finished.
    void observe(const FrameStatistics& statistics, std::size_t allHairs);
    [[nodiscard]] const Quality& quality() const { return m_quality; }
    /// Whether a still picture would gain from another frame.
    [[nodiscard]] bool wantsRefinement() const { return m_wantsRefinement; }

private:
    void retreat();
    void refine();
    void follow(double milliseconds, std::size_t drawnHairs, std::size_t allHairs);

    double m_wantedMs;
    Quality m_quality;
    Quality m_moving = m_quality;
    Quality m_whole = m_quality; ///< Quality of the last still frame that was complete.
    int m_slow = 0;              ///< Number of frames in a row that took too long.
    int m_fast = 0;              ///< Number of frames in a row that left time.
    bool m_still = false;
    bool m_retreated = false; ///< A still frame was not complete, and m_quality went back to m_whole.
    bool m_wantsRefinement = true;
};

} // namespace hairpaint::rendering
