// Finds the tiles that segments touch.
#include "view/rendering/software/screen_segments.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hairpaint::rendering {
namespace {

/// Room for `more` behind the first `count`; elements that count are never made anew.
template<class T>
void reserveMore(std::vector<T>& elements, std::size_t count, std::size_t more)
{
    if (elements.size() < count + more)
        elements.resize(std::max(count + more, elements.size() + elements.size() / 2));
}

constexpr std::uint32_t kLowHalf = 0xFFFFU;

} // namespace

void SegmentBatch::clear()
{
    m_segmentCount = 0;
    m_foundCount = 0;
}

void SegmentBatch::add(const TileGrid& tiles, const StrandPoints& points, int segments)
{
    findBounds(tiles, points, segments, m_bounds);
    const std::size_t most = static_cast<std::size_t>(segments) * kBlockLanes;
    reserveMore(m_segments, m_segmentCount, most);
    for (std::size_t j = 0; j < static_cast<std::size_t>(segments); ++j)
        for (std::uint32_t lanes = m_bounds.lanes[j]; lanes != 0; lanes &= lanes - 1) {
            const std::size_t a = j * kBlockLanes + static_cast<std::size_t>(std::countr_zero(lanes));
            const std::size_t b = a + kBlockLanes;
            const auto width = std::bit_cast<std::array<std::uint16_t, 2>>(m_bounds.widths[a]);
            // What hair hides at one end was not lit there.
            const bool lit0 = points.width[a] > 0.0F;
            const bool lit1 = points.width[b] > 0.0F;
            ScreenSegment& segment = m_segments[m_segmentCount];
            segment = {.x0 = points.x[a],
                       .y0 = points.y[a],
                       .x1 = points.x[b],
                       .y1 = points.y[b],
                       .depth = std::bit_cast<std::array<std::uint16_t, 2>>(m_bounds.depths[a]),
                       .width = width,
                       .colour = {points.colour[lit0 ? a : b], points.colour[lit1 ? b : a]}};
            addToTiles(tiles, segment, m_bounds.tilesX[a], m_bounds.tilesY[a]);
            ++m_segmentCount;
        }
}

void SegmentBatch::addToTiles(const TileGrid& tiles, const ScreenSegment& segment, std::uint32_t tilesX,
                              std::uint32_t tilesY)
{
    const auto left = static_cast<int>(tilesX & kLowHalf);
    const auto right = static_cast<int>(tilesX >> 16U);
    const auto low = static_cast<int>(tilesY & kLowHalf);
    const auto high = static_cast<int>(tilesY >> 16U);
    const auto number = static_cast<std::uint32_t>(m_segmentCount);
    reserveMore(m_found, m_foundCount,
                static_cast<std::size_t>(right - left + 1) * static_cast<std::size_t>(high - low + 1));
    const auto tileAt = [&](int tx, int ty) { return static_cast<std::uint32_t>(ty * tiles.across + tx); };
    if (left == right && low == high) {
        const std::uint32_t sum = std::uint32_t{segment.depth[0]} + segment.depth[1];
        m_found[m_foundCount++] = {
            .segment = number, .tile = tileAt(left, low), .depth = static_cast<std::uint16_t>(sum / 2)};
        return;
    }
    const float reach = 1.0F + 0.5F * kWidthUnit * static_cast<float>(std::max(segment.width[0], segment.width[1]));
    const float dx = segment.x1 - segment.x0;
    const float dy = segment.y1 - segment.y0;
    const float perLength2 = 1.0F / std::max(dx * dx + dy * dy, 1e-6F);
    const float depth0 = segment.depth[0];
    const float deeper = static_cast<float>(segment.depth[1]) - depth0;
    // Half a tile's diagonal along each axis, as far as the segment's side reaches.
    const float side = (std::abs(dx) + std::abs(dy)) * (0.5F * kTileSp + reach);
    for (int ty = low; ty <= high; ++ty)
        for (int tx = left; tx <= right; ++tx) {
            const float cx = (static_cast<float>(tx) + 0.5F) * kTileSp - segment.x0;
            const float cy = (static_cast<float>(ty) + 0.5F) * kTileSp - segment.y0;
            if (left != right && low != high && std::abs(cx * dy - cy * dx) > side)
                continue;
            const float t = std::clamp((cx * dx + cy * dy) * perLength2, 0.0F, 1.0F);
            m_found[m_foundCount++] = {
                .segment = number, .tile = tileAt(tx, ty), .depth = static_cast<std::uint16_t>(depth0 + deeper * t)};
        }
}

void SegmentBatch::sort(const TileGrid& tiles)
{
    const auto end = m_found.begin() + static_cast<std::ptrdiff_t>(m_foundCount);
    m_tileBegin.assign(tiles.count() + 1, 0);
    for (auto found = m_found.begin(); found != end; ++found)
        ++m_tileBegin[found->tile + 1];
    for (std::size_t tile = 0; tile < tiles.count(); ++tile)
        m_tileBegin[tile + 1] += m_tileBegin[tile];
    if (m_sorted.size() < m_foundCount)
        m_sorted.resize(m_found.size());
    for (auto found = m_found.begin(); found != end; ++found)
        m_sorted[m_tileBegin[found->tile]++] = {.segment = found->segment, .depth = found->depth, .batch = 0};
    // Each now holds its end, which is the next one's beginning.
    for (std::size_t tile = tiles.count(); tile > 0; --tile)
        m_tileBegin[tile] = m_tileBegin[tile - 1];
    m_tileBegin[0] = 0;
}

} // namespace hairpaint::rendering
