// A brush over the picture of the 3D area, and what is near to it.
#pragma once

#include "view/picking/hair_boxes.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

inline constexpr float kNoLimitM = 1e9F; ///< Further than any hair is away.

/// A disc that is swept along a line, px of the view.
struct PictureBrush
{
    glm::vec2 from{0.0F}, to{0.0F};
    float radiusPx = 0.0F;
    PictureBox box; ///< Box around the swept disc.

    PictureBrush(glm::vec2 begin, glm::vec2 end, float px) : from(begin), to(end), radiusPx(px)
    {
        box.add(from);
        box.add(to);
        box = box.widened(radiusPx);
    }
};

/// A point of a segment, and how far it is from another.
struct Nearest
{
    float fraction = 0.0F; ///< 0..1 along the first segment.
    float apart = 0.0F;
};

/// Fraction of a segment, 0..1, at which it is nearest to a point.
[[nodiscard]] inline float fractionNear(glm::vec2 point, glm::vec2 from, glm::vec2 to)
{
    const glm::vec2 segment = to - from;
    const float square = glm::dot(segment, segment);
    return square > 0.0F ? std::clamp(glm::dot(point - from, segment) / square, 0.0F, 1.0F) : 0.0F;
}

/// The point of a segment a-b that is nearest to the segment c-d.
[[nodiscard]] inline Nearest nearestOf(glm::vec2 a, glm::vec2 b, glm::vec2 c, glm::vec2 d)
{
    const auto apartAt = [&](float fraction) {
        const glm::vec2 point = a + (b - a) * fraction;
        return glm::distance(point, c + (d - c) * fractionNear(point, c, d));
    };
    if (c == d) {
        const float fraction = fractionNear(c, a, b);
        return {.fraction = fraction, .apart = apartAt(fraction)};
    }
    const glm::vec2 segment = b - a;
    const glm::vec2 other = d - c;
    const float area = segment.x * other.y - segment.y * other.x;
    if (std::abs(area) > 1e-9F) {
        const glm::vec2 apart = c - a;
        const float along = (apart.x * other.y - apart.y * other.x) / area;
        const float alongOther = (apart.x * segment.y - apart.y * segment.x) / area;
        if (along >= 0.0F && along <= 1.0F && alongOther >= 0.0F && alongOther <= 1.0F)
            return {.fraction = along, .apart = 0.0F};
    }
    Nearest best{.fraction = 0.0F, .apart = apartAt(0.0F)};
    for (const float fraction : {1.0F, fractionNear(c, a, b), fractionNear(d, a, b)})
        if (const float apart = apartAt(fraction); apart < best.apart)
            best = {.fraction = fraction, .apart = apart};
    return best;
}

} // namespace hairpaint::view
