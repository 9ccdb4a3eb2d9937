// Where a stroke goes, smoothed.
#pragma once

#include "sim/base/rounded.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <optional>

namespace hairpaint::model {

/// Follows the pointer's motion in Hd over a quarter of the brush's diameter.
class StrokeHeading
{
public:
    /// False where there is no motion.
    bool turn(glm::vec3 motionHd, float sizeM)
    {
        constexpr float kSmoothing = 0.25F;
        constexpr float kLeastSmoothingM = 0.002F;
        const float moved = glm::length(motionHd);
        if (moved < 1e-6F)
            return false;
        const float smoothingM = std::max(kSmoothing * sizeM, kLeastSmoothingM);
        const glm::vec3 now = motionHd / moved;
        const glm::vec3 direction =
            m_unitHd ? *m_unitHd + (now - *m_unitHd) * (1.0F - sim::expRounded(-moved / smoothingM)) : now;
        const float length = glm::length(direction);
        m_unitHd = length > 0.1F ? direction / length : now; // Turned right back: none in between.
        return true;
    }
    void reset() { m_unitHd.reset(); }
    /// Unit; zero before there was a motion.
    [[nodiscard]] glm::vec3 orNone() const { return m_unitHd.value_or(glm::vec3(0.0F)); }

private:
    std::optional<glm::vec3> m_unitHd;
};

} // namespace hairpaint::model
