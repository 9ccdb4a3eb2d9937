// Finds the tiles that segments touch.
#include "view/rendering/software/screen_segments.h"

#include "view/rendering/software/segment_kernel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace hairpaint::rendering {
namespace {

/// Room for `more` behind the first `count`; elements that count are never made anew.
template<class T>
void reserveMore(std::vector<T>& elements, std::size_t count, std::size_t more)
{
    if (elements.size() < count + more)
        elements.resize(std::max(count + more, elements.size() + elements.size() / 4));
}

/// Frees what is more than twice what is needed.
template<class T>
void freeBeyond(std::vector<T>& elements, std::size_t needed)
{
    if (elements.size() / 2 > needed)
        elements = std::vector<T>(needed);
}

constexpr std::uint32_t kLowHalf = 0xFFFFU;

} // namespace

void SegmentBatch::clear()
{
    m_mostSegments = std::max(m_mostSegments, std::exchange(m_segmentCount, 0));
    m_mostSorted = std::max(m_mostSorted, std::exchange(m_sortedCount, 0));
    if (++m_pictures < kPicturesKept)
        return;
    freeBeyond(m_segments, std::exchange(m_mostSegments, 0));
    freeBeyond(m_sorted, std::exchange(m_mostSorted, 0));
    m_pictures = 0;
}

std::size_t SegmentBatch::heldBytes() const
{
    return m_segments.size() * sizeof(ScreenSegment) + m_sorted.size() * sizeof(TileEntry);
}

std::size_t SegmentBatch::usedBytes() const
{
    return m_segmentCount * sizeof(ScreenSegment) + m_sortedCount * sizeof(TileEntry);
}

void SegmentBatch::add(const TileGrid& tiles, const StrandPoints& points, int segments, SegmentScratch& scratch)
{
    SegmentBounds& bounds = scratch.bounds;
    findBounds(tiles, points, segments, bounds);
    const std::size_t most = static_cast<std::size_t>(segments) * kBlockLanes;
    reserveMore(m_segments, m_segmentCount, most);
    for (std::size_t j = 0; j < static_cast<std::size_t>(segments); ++j)
        for (std::uint32_t lanes = bounds.lanes[j]; lanes != 0; lanes &= lanes - 1) {
            const std::size_t a = j * kBlockLanes + static_cast<std::size_t>(std::countr_zero(lanes));
            const std::size_t b = a + kBlockLanes;
            const auto width = std::bit_cast<std::array<std::uint16_t, 2>>(bounds.widths[a]);
            // What hair hides at one end was not lit there.
            const bool lit0 = points.width[a] > 0.0F;
            const bool lit1 = points.width[b] > 0.0F;
            ScreenSegment& segment = m_segments[m_segmentCount];
            segment = {.x0 = points.x[a],
                       .y0 = points.y[a],
                       .x1 = points.x[b],
                       .y1 = points.y[b],
                       .depth = std::bit_cast<std::array<std::uint16_t, 2>>(bounds.depths[a]),
                       .width = width,
                       .colour = {points.colour[lit0 ? a : b], points.colour[lit1 ? b : a]}};
            addToTiles(tiles, segment, bounds.tilesX[a], bounds.tilesY[a], scratch);
            ++m_segmentCount;
        }
}

/// Hair that crosses other hair within a tile has to be sorted where it crosses: a segment that goes far in depth is
/// sorted cell by cell.
void SegmentBatch::addToTile(const TileGrid& tiles, const ScreenSegment& segment, int tileX, int tileY,
                             SegmentScratch& scratch)
{
    const bool steep = std::abs(segment.y1 - segment.y0) > std::abs(segment.x1 - segment.x0);
    const auto corner = static_cast<float>((steep ? tileY : tileX) * kTileSp);
    const float main0 = (steep ? segment.y0 : segment.x0) - corner;
    const float main1 = (steep ? segment.y1 : segment.x1) - corner;
    const float low = std::clamp(std::min(main0, main1), 0.0F, static_cast<float>(kTileSp));
    const float high = std::clamp(std::max(main0, main1), low, static_cast<float>(kTileSp));
    const float depth0 = segment.depth[0];
    const float length = main1 - main0;
    const float perSample = std::abs(length) > 1e-3F ? (static_cast<float>(segment.depth[1]) - depth0) / length : 0.0F;
    const auto number = static_cast<std::uint32_t>(m_segmentCount);
    const auto tile = static_cast<std::uint32_t>(tiles.number(tileX, tileY));
    const auto found = [&](int firstCell, int lastCell, float from, float to) {
        const float depth = depth0 + perSample * (0.5F * (from + to) - main0);
        scratch.found[scratch.foundCount++] = {.piece = SegmentPiece::of(number, firstCell, lastCell),
                                               .tile = tile,
                                               .depth = static_cast<std::uint16_t>(std::clamp(depth, 0.0F, 65535.0F))};
    };
    if (std::abs(perSample) * (high - low) <= tiles.evenDepths) {
        found(0, kCells - 1, low, high);
        return;
    }
    constexpr auto kCell = static_cast<float>(kCellSp);
    const int last = std::min(static_cast<int>(high) / kCellSp, kCells - 1);
    for (int cell = std::min(static_cast<int>(low) / kCellSp, kCells - 1); cell <= last; ++cell) {
        const float begin = static_cast<float>(cell) * kCell;
        found(cell, cell, std::max(low, begin), std::min(high, begin + kCell));
    }
}

void SegmentBatch::addToTiles(const TileGrid& tiles, const ScreenSegment& segment, std::uint32_t tilesX,
                              std::uint32_t tilesY, SegmentScratch& scratch)
{
    const auto left = static_cast<int>(tilesX & kLowHalf);
    const auto right = static_cast<int>(tilesX >> 16U);
    const auto low = static_cast<int>(tilesY & kLowHalf);
    const auto high = static_cast<int>(tilesY >> 16U);
    const int first = std::max(low, tiles.firstUp);
    const int last = std::min(high, tiles.endUp - 1);
    if (first > last)
        return;
    reserveMore(scratch.found, scratch.foundCount,
                static_cast<std::size_t>(right - left + 1) * static_cast<std::size_t>(last - first + 1) * kCells);
    if (left == right && low == high) {
        addToTile(tiles, segment, left, low, scratch);
        return;
    }
    const float reach = 1.0F + 0.5F * kWidthUnit * static_cast<float>(std::max(segment.width[0], segment.width[1]));
    const float dx = segment.x1 - segment.x0;
    const float dy = segment.y1 - segment.y0;
    // Half a tile's diagonal along each axis, as far as the segment's side reaches.
    const float side = (std::abs(dx) + std::abs(dy)) * (0.5F * kTileSp + reach);
    for (int ty = first; ty <= last; ++ty)
        for (int tx = left; tx <= right; ++tx) {
            const float cx = (static_cast<float>(tx) + 0.5F) * kTileSp - segment.x0;
            const float cy = (static_cast<float>(ty) + 0.5F) * kTileSp - segment.y0;
            if (left != right && low != high && std::abs(cx * dy - cy * dx) > side)
                continue;
            addToTile(tiles, segment, tx, ty, scratch);
        }
}

void SegmentBatch::sort(const TileGrid& tiles, SegmentScratch& scratch)
{
    m_sortedCount = std::exchange(scratch.foundCount, 0);
    const auto end = scratch.found.begin() + static_cast<std::ptrdiff_t>(m_sortedCount);
    m_tileBegin.assign(tiles.count() + 1, 0);
    for (auto found = scratch.found.begin(); found != end; ++found)
        ++m_tileBegin[found->tile + 1];
    for (std::size_t tile = 0; tile < tiles.count(); ++tile)
        m_tileBegin[tile + 1] += m_tileBegin[tile];
    reserveMore(m_sorted, 0, m_sortedCount);
    for (auto found = scratch.found.begin(); found != end; ++found)
        m_sorted[m_tileBegin[found->tile]++] = {.piece = found->piece, .depth = found->depth};
    // Each now holds its end, which is the next one's beginning.
    for (std::size_t tile = tiles.count(); tile > 0; --tile)
        m_tileBegin[tile] = m_tileBegin[tile - 1];
    m_tileBegin[0] = 0;
}

void SegmentBounds::resize(std::size_t segments)
{
    if (lanes.size() >= segments)
        return;
    lanes.resize(segments);
    for (std::vector<std::uint32_t>* rows : {&tilesX, &tilesY, &depths, &widths})
        rows->resize(segments * kBlockLanes);
}

} // namespace hairpaint::rendering
