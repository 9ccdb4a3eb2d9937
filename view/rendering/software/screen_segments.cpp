// Finds the tiles that segments touch.
#include "view/rendering/software/screen_segments.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::rendering {

void SegmentBatch::clear()
{
    m_segments.clear();
    m_found.clear();
}

void SegmentBatch::add(const TileGrid& tiles, const StrandPoints& points, int segments, std::size_t lanes)
{
    constexpr float kLeastUnits = 1.0F;
    constexpr float kMostUnits = 65535.0F;
    const auto width = static_cast<float>(tiles.width);
    const auto height = static_cast<float>(tiles.height);
    for (int j = 0; j < segments; ++j) {
        const std::size_t row = static_cast<std::size_t>(j) * kBlockLanes;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::size_t a = row + lane;
            const std::size_t b = a + kBlockLanes;
            const float w0 = points.width[a] * (1.0F / kWidthUnit);
            const float w1 = points.width[b] * (1.0F / kWidthUnit);
            if (std::max(w0, w1) < kLeastUnits)
                continue;
            const float x0 = points.x[a];
            const float y0 = points.y[a];
            const float x1 = points.x[b];
            const float y1 = points.y[b];
            const float reach = 1.0F + 0.5F * kWidthUnit * std::max(w0, w1);
            // False for what is not a number.
            const bool inside = std::max(x0, x1) > -reach && std::min(x0, x1) < width + reach &&
                                std::max(y0, y1) > -reach && std::min(y0, y1) < height + reach;
            if (!inside)
                continue;
            // What hair hides at one end was not lit there.
            const std::uint32_t colour0 = w0 > 0.0F ? points.colour[a] : points.colour[b];
            const std::uint32_t colour1 = w1 > 0.0F ? points.colour[b] : points.colour[a];
            addToTiles(tiles, {.x0 = x0,
                               .y0 = y0,
                               .x1 = x1,
                               .y1 = y1,
                               .depth0 = static_cast<std::uint16_t>(points.depth[a]),
                               .depth1 = static_cast<std::uint16_t>(points.depth[b]),
                               .width0 = static_cast<std::uint16_t>(std::min(w0 + 0.5F, kMostUnits)),
                               .width1 = static_cast<std::uint16_t>(std::min(w1 + 0.5F, kMostUnits)),
                               .colour0 = colour0,
                               .colour1 = colour1});
        }
    }
}

void SegmentBatch::addToTiles(const TileGrid& tiles, const ScreenSegment& segment)
{
    const auto number = static_cast<std::uint32_t>(m_segments.size());
    m_segments.push_back(segment);
    const float reach = 1.0F + 0.5F * kWidthUnit * static_cast<float>(std::max(segment.width0, segment.width1));
    const auto tileOf = [](float place, int most) {
        return std::clamp(static_cast<int>(std::clamp(place, -1.0F, 65536.0F) * (1.0F / kTileSp)), 0, most);
    };
    const int left = tileOf(std::min(segment.x0, segment.x1) - reach, tiles.across - 1);
    const int right = tileOf(std::max(segment.x0, segment.x1) + reach, tiles.across - 1);
    const int low = tileOf(std::min(segment.y0, segment.y1) - reach, tiles.up - 1);
    const int high = tileOf(std::max(segment.y0, segment.y1) + reach, tiles.up - 1);
    const float dx = segment.x1 - segment.x0;
    const float dy = segment.y1 - segment.y0;
    const float perLength2 = 1.0F / std::max(dx * dx + dy * dy, 1e-6F);
    const float depth0 = segment.depth0;
    const float deeper = static_cast<float>(segment.depth1) - depth0;
    // Half a tile's diagonal along each axis, as far as the segment's side reaches.
    const float side = (std::abs(dx) + std::abs(dy)) * (0.5F * kTileSp + reach);
    for (int ty = low; ty <= high; ++ty)
        for (int tx = left; tx <= right; ++tx) {
            const float cx = (static_cast<float>(tx) + 0.5F) * kTileSp - segment.x0;
            const float cy = (static_cast<float>(ty) + 0.5F) * kTileSp - segment.y0;
            if (left != right && low != high && std::abs(cx * dy - cy * dx) > side)
                continue;
            const float t = std::clamp((cx * dx + cy * dy) * perLength2, 0.0F, 1.0F);
            m_found.push_back({.segment = number,
                               .tile = static_cast<std::uint32_t>(ty * tiles.across + tx),
                               .depth = static_cast<std::uint16_t>(depth0 + deeper * t)});
        }
}

void SegmentBatch::sort(const TileGrid& tiles)
{
    m_tileBegin.assign(tiles.count() + 1, 0);
    for (const Found& found : m_found)
        ++m_tileBegin[found.tile + 1];
    for (std::size_t tile = 0; tile < tiles.count(); ++tile)
        m_tileBegin[tile + 1] += m_tileBegin[tile];
    m_sorted.resize(m_found.size());
    for (const Found& found : m_found)
        m_sorted[m_tileBegin[found.tile]++] = {.segment = found.segment, .depth = found.depth, .batch = 0};
    // Each now holds its end, which is the next one's beginning.
    for (std::size_t tile = tiles.count(); tile > 0; --tile)
        m_tileBegin[tile] = m_tileBegin[tile - 1];
    m_tileBegin[0] = 0;
}

} // namespace hairpaint::rendering
