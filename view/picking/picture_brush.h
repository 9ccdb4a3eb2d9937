// A brush over the picture of the 3D area, and what is near to it.
#pragma once

#include "view/picking/hair_boxes.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace hairpaint::view {

inline constexpr float kNoLimitM = 1e9F; ///< Further than any hair is away.

/// A disc that is swept along a line, px of the view.
struct PictureBrush
{
    glm::vec2 from{0.0F}, to{0.0F};
    float radiusPx = 0.0F;
    PictureBox box; ///< All of it.

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
    float fraction = 0.0F; ///< Of the first segment.
    float apart = 0.0F;
};

/// Of a segment, where it is nearest to a point: 0..1.
[[nodiscard]] inline float fractionNear(glm::vec2 point, glm::vec2 from, glm::vec2 to)
{
    const glm::vec2 way = to - from;
    const float square = glm::dot(way, way);
    return square > 0.0F ? std::clamp(glm::dot(point - from, way) / square, 0.0F, 1.0F) : 0.0F;
}

/// Of a segment a-b the point nearest to the segment c-d.
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
    const glm::vec2 way = b - a;
    const glm::vec2 other = d - c;
    const float area = way.x * other.y - way.y * other.x;
    if (std::abs(area) > 1e-9F) {
        const glm::vec2 apart = c - a;
        const float along = (apart.x * other.y - apart.y * other.x) / area;
        const float alongOther = (apart.x * way.y - apart.y * way.x) / area;
        if (along >= 0.0F && along <= 1.0F && alongOther >= 0.0F && alongOther <= 1.0F)
            return {.fraction = along, .apart = 0.0F};
    }
    Nearest best{.fraction = 0.0F, .apart = apartAt(0.0F)};
    for (const float fraction : {1.0F, fractionNear(c, a, b), fractionNear(d, a, b)})
        if (const float apart = apartAt(fraction); apart < best.apart)
            best = {.fraction = fraction, .apart = apart};
    return best;
}

/// Of a block's segments between two nodes, those whose boxes meet a box, before the eye and no deeper than `deepestM`:
/// a bit a lane.
[[nodiscard]] inline std::uint32_t lanesMeeting(const float* from, const float* to, const PictureBox& box,
                                                float deepestM)
{
    std::array<std::uint32_t, kPickLanes> flags{};
    for (std::size_t x = 0; x < kPickLanes; ++x) {
        const std::size_t y = kPickLanes + x;
        const std::size_t z = 2 * kPickLanes + x;
        const float left = from[x] < to[x] ? from[x] : to[x];
        const float right = from[x] < to[x] ? to[x] : from[x];
        const float top = from[y] < to[y] ? from[y] : to[y];
        const float bottom = from[y] < to[y] ? to[y] : from[y];
        const float nearest = from[z] < to[z] ? from[z] : to[z];
        flags[x] = static_cast<std::uint32_t>(left <= box.right) & static_cast<std::uint32_t>(right >= box.left) &
                   static_cast<std::uint32_t>(top <= box.bottom) & static_cast<std::uint32_t>(bottom >= box.top) &
                   static_cast<std::uint32_t>(nearest > 0.0F) & static_cast<std::uint32_t>(nearest <= deepestM);
    }
    std::uint32_t lanes = 0;
    for (std::size_t lane = 0; lane < kPickLanes; ++lane)
        lanes |= flags[lane] << lane;
    return lanes;
}

} // namespace hairpaint::view
