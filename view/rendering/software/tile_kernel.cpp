// Lays hair over a tile.
#include "view/rendering/software/tile_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/rendering/software/tile_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/rendering/light/lanes_inl.h"
#include <algorithm>
#include <cmath>
#include <hwy/cache_control.h>
#include <hwy/highway.h>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// Hair that lies flat dips into the skin here and there; it is shown all the same.
constexpr float kSkinDepthM = 0.015F;

/// Colour from 10 bits each, linear; the fourth is -1, so that adding it takes from what is left to see through.
HWY_INLINE Quad colourOf(std::uint32_t bits)
{
    constexpr std::uint32_t kMask = 0x3FFU;
    constexpr float kUnit = 1.0F / 1023.0F;
    HWY_ALIGN const float values[4] = {static_cast<float>(static_cast<std::int32_t>(bits & kMask)) * kUnit,
                                       static_cast<float>(static_cast<std::int32_t>((bits >> 10U) & kMask)) * kUnit,
                                       static_cast<float>(static_cast<std::int32_t>((bits >> 20U) & kMask)) * kUnit,
                                       1.0F};
    HWY_ALIGN static constexpr float kSigns[4] = {1.0F, 1.0F, 1.0F, -1.0F};
    const Quad root = quadOf(values);
    return root * root * quadOf(kSigns);
}

/// A segment as it lies in the tile, along its main direction from the lower end on.
struct Walk
{
    float main0, main1, across0, across1, width0, width1, depth0, depth1;
    std::uint32_t bits0, bits1;
};

template<bool kSteep>
HWY_INLINE Walk walkOf(const TileTask& task, const ScreenSegment& segment)
{
    const auto x = static_cast<float>(task.x0);
    const auto y = static_cast<float>(task.y0);
    Walk walk{.main0 = kSteep ? segment.y0 - y : segment.x0 - x,
              .main1 = kSteep ? segment.y1 - y : segment.x1 - x,
              .across0 = kSteep ? segment.x0 - x : segment.y0 - y,
              .across1 = kSteep ? segment.x1 - x : segment.y1 - y,
              .width0 = static_cast<float>(segment.width0) * kWidthUnit,
              .width1 = static_cast<float>(segment.width1) * kWidthUnit,
              .depth0 = static_cast<float>(segment.depth0),
              .depth1 = static_cast<float>(segment.depth1),
              .bits0 = segment.colour0,
              .bits1 = segment.colour1};
    if (walk.main0 > walk.main1) {
        std::swap(walk.main0, walk.main1);
        std::swap(walk.across0, walk.across1);
        std::swap(walk.width0, walk.width1);
        std::swap(walk.depth0, walk.depth1);
        std::swap(walk.bits0, walk.bits1);
    }
    return walk;
}

/// What layOne() works on.
struct Canvas
{
    const TileTask& task;
    TileSamples& samples;
    int open; ///< Samples of the tile that are not opaque yet.
};

/// A sample has just become opaque.
HWY_INLINE void close(Canvas& canvas, int x, int y)
{
    --canvas.open;
    --canvas.samples.open[static_cast<std::size_t>(y / kCellSp)][static_cast<std::size_t>(x / kCellSp)];
}

/// Part of a strand's cover that counts where the head may lie in front.
HWY_INLINE float coverBeforeHead(const Canvas& canvas, int x, int y, float depth, float cover)
{
    if (depth <= canvas.samples.headDepth[static_cast<std::size_t>(inTile(x, y))])
        return cover;
    if (x < 0 || y < 0 || x >= canvas.task.width || y >= canvas.task.height)
        return 0.0F;
    const std::size_t at = static_cast<std::size_t>(y) * canvas.task.headStride + static_cast<std::size_t>(x);
    return cover * (1.0F - static_cast<float>(canvas.task.head[at].cover) * (1.0F / 65535.0F));
}

/// What a walk's values are at a place along its main direction, and how they go on from sample to sample.
struct Pace
{
    float middle, width, depth;
    Quad colour;
};

/// Whether all cells that the walk may touch between two places along its main direction are opaque.
template<bool kSteep>
HWY_INLINE bool isClosed(const Canvas& canvas, int cell, float from, float to, float reach)
{
    const float low = std::min(from, to) - reach;
    const float high = std::max(from, to) + reach;
    if (!(high > 0.0F && low < static_cast<float>(kTileSp)))
        return true;
    const int first = std::max(static_cast<int>(low), 0) / kCellSp;
    const int last = std::min(static_cast<int>(high), kTileSp - 1) / kCellSp;
    for (int c = first; c <= last; ++c)
        if (canvas.samples
                .open[static_cast<std::size_t>(kSteep ? cell : c)][static_cast<std::size_t>(kSteep ? c : cell)] != 0)
            return false;
    return true;
}

/// One step of a strand that is thinner than a sample: a tent over the two that are nearest.
template<bool kSteep, bool kHead>
HWY_INLINE void layThin(Canvas& canvas, int i, const Pace& at)
{
    constexpr int kNext = kSteep ? 1 : kTileRow; // To the second of the two.
    const int k = static_cast<int>(at.middle + 64.5F) - 65;
    if (static_cast<unsigned>(k + 1) > static_cast<unsigned>(kTileSp))
        return;
    const int index = kSteep ? inTile(k, i) : inTile(i, k);
    float* first = canvas.samples.light.data() + 4 * static_cast<std::ptrdiff_t>(index);
    float* second = first + 4 * static_cast<std::ptrdiff_t>(kNext);
    const float left0 = first[3];
    const float left1 = second[3];
    if (std::max(left0, left1) < canvas.task.opaque)
        return;
    float cover1 = at.width * (at.middle - 0.5F - static_cast<float>(k));
    float cover0 = at.width - cover1;
    if constexpr (kHead) {
        const float* depths = canvas.samples.headDepth.data() + index;
        if (at.depth > std::min(depths[0], depths[kNext])) {
            const int x = kSteep ? k : i;
            const int y = kSteep ? i : k;
            cover0 = coverBeforeHead(canvas, x, y, at.depth, cover0);
            cover1 = coverBeforeHead(canvas, x + (kSteep ? 1 : 0), y + (kSteep ? 0 : 1), at.depth, cover1);
        }
    }
    const float weight0 = cover0 * left0;
    const float weight1 = cover1 * left1;
    stored(quadOf(first) + at.colour * quadOf(weight0), first);
    stored(quadOf(second) + at.colour * quadOf(weight1), second);
    if (HWY_UNLIKELY(std::min(left0 - weight0, left1 - weight1) < canvas.task.opaque)) {
        const int x = kSteep ? k : i;
        const int y = kSteep ? i : k;
        if (left0 >= canvas.task.opaque && left0 - weight0 < canvas.task.opaque)
            close(canvas, x, y);
        if (left1 >= canvas.task.opaque && left1 - weight1 < canvas.task.opaque)
            close(canvas, x + (kSteep ? 1 : 0), y + (kSteep ? 0 : 1));
    }
}

/// One step of any strand: its cover by a filter one sample wide.
template<bool kSteep, bool kHead>
HWY_INLINE void layWide(Canvas& canvas, int i, const Pace& at)
{
    const float gain = std::min(at.width, 1.0F);
    const float half = (std::max(at.width, 1.0F) + 1.0F) * 0.5F;
    constexpr float kUp = 0.5F; // to the nearest: nothing here is negative
    const int first = static_cast<int>(std::clamp(at.middle - half, 0.0F, 64.0F) + kUp);
    const int last = static_cast<int>(std::clamp(at.middle + half, 0.0F, static_cast<float>(kTileSp)) + kUp);
    for (int k = first; k < std::min(last, kTileSp); ++k) {
        const int x = kSteep ? k : i;
        const int y = kSteep ? i : k;
        float* sample = canvas.samples.light.data() + 4 * static_cast<std::ptrdiff_t>(inTile(x, y));
        const float left = sample[3];
        if (left < canvas.task.opaque)
            continue;
        float cover = gain * std::clamp(half - std::abs(static_cast<float>(k) + 0.5F - at.middle), 0.0F, 1.0F);
        if constexpr (kHead)
            cover = coverBeforeHead(canvas, x, y, at.depth, cover);
        const float weight = cover * left;
        stored(quadOf(sample) + at.colour * quadOf(weight), sample);
        if (left - weight < canvas.task.opaque)
            close(canvas, x, y);
    }
}

/// Walks a segment; a sample gets as much of it as the strand covers. Cells that are opaque already are stepped over.
template<bool kSteep, bool kHead>
HWY_INLINE void layOne(Canvas& canvas, const ScreenSegment& segment)
{
    const Walk walk = walkOf<kSteep>(canvas.task, segment);
    const int mainEnd = kSteep ? canvas.task.height : canvas.task.width;
    // Samples whose middle lies in main0..main1.
    const auto cut = [](float place) { return static_cast<int>(std::clamp(place, -1.0F, 64.0F) + 1.5F) - 1; };
    const int begin = std::max(cut(walk.main0), 0);
    const int end = std::min(cut(walk.main1), mainEnd);
    if (begin >= end)
        return;
    const float inverse = 1.0F / std::max(walk.main1 - walk.main0, 1e-6F);
    const Quad colour0 = colourOf(walk.bits0);
    const Pace step{.middle = (walk.across1 - walk.across0) * inverse,
                    .width = (walk.width1 - walk.width0) * inverse,
                    .depth = (walk.depth1 - walk.depth0) * inverse,
                    .colour = (colourOf(walk.bits1) - colour0) * quadOf(inverse)};
    const float widest = std::max(walk.width0, walk.width1);
    const bool thin = widest <= 1.0F;
    const float reach = (std::max(widest, 1.0F) + 1.0F) * 0.5F;
    for (int chunk = begin; chunk < end;) {
        const int cell = chunk / kCellSp;
        const int chunkEnd = std::min((cell + 1) * kCellSp, end);
        const float along = static_cast<float>(chunk) + 0.5F - walk.main0;
        Pace at{.middle = walk.across0 + step.middle * along,
                .width = walk.width0 + step.width * along,
                .depth = walk.depth0 + step.depth * along,
                .colour = colour0 + step.colour * quadOf(along)};
        const float last = at.middle + step.middle * static_cast<float>(chunkEnd - 1 - chunk);
        if (!isClosed<kSteep>(canvas, cell, at.middle, last, reach))
            for (int i = chunk; i < chunkEnd; ++i) {
                if (thin)
                    layThin<kSteep, kHead>(canvas, i, at);
                else
                    layWide<kSteep, kHead>(canvas, i, at);
                at.middle += step.middle;
                at.width += step.width;
                at.depth += step.depth;
                at.colour = at.colour + step.colour;
            }
        chunk = chunkEnd;
    }
}

/// Sorts by depth, equals in the order in which they came.
void sortByDepth(TileSamples& samples)
{
    std::vector<TileEntry>& entries = samples.entries;
    std::uint32_t nearest = 0xFFFFU;
    std::uint32_t farthest = 0;
    for (const TileEntry& entry : entries) {
        nearest = std::min<std::uint32_t>(nearest, entry.depth);
        farthest = std::max<std::uint32_t>(farthest, entry.depth);
    }
    unsigned shift = 0;
    while (((farthest - nearest) >> shift) >= samples.buckets.size())
        ++shift;
    const std::size_t used = ((farthest - nearest) >> shift) + 1;
    std::fill_n(samples.buckets.begin(), used, 0U);
    for (const TileEntry& entry : entries)
        ++samples.buckets[(entry.depth - nearest) >> shift];
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < used; ++i)
        sum += std::exchange(samples.buckets[i], sum);
    samples.sorted.resize(entries.size());
    for (const TileEntry& entry : entries)
        samples.sorted[samples.buckets[(entry.depth - nearest) >> shift]++] = entry;
}

void clearTile(const TileTask& task, TileSamples& samples)
{
    HWY_ALIGN const float clear[4] = {0.0F, 0.0F, 0.0F, 1.0F};
    std::ranges::fill(samples.light, 0.0F); // Around the tile nothing can be seen through.
    for (auto& row : samples.open)
        row.fill(0);
    for (int y = 0; y < task.height; ++y) {
        for (int x = 0; x < task.width; ++x)
            stored(quadOf(clear), samples.light.data() + 4 * static_cast<std::ptrdiff_t>(inTile(x, y)));
        for (int x = 0; x < task.width; x += kCellSp)
            samples.open[static_cast<std::size_t>(y / kCellSp)][static_cast<std::size_t>(x / kCellSp)] +=
                std::min(kCellSp, task.width - x);
    }
}

void layAll(const TileTask& task, SegmentLists segments, TileSamples& samples)
{
    clearTile(task, samples);
    if (samples.entries.empty())
        return;
    sortByDepth(samples);
    float nearestHead = 1e9F;
    if (task.anyHead) {
        samples.headDepth.fill(1e9F);
        for (int y = 0; y < task.height; ++y)
            for (int x = 0; x < task.width; ++x) {
                const float distanceM =
                    task.headDistanceM[static_cast<std::size_t>(y) * task.headStride + static_cast<std::size_t>(x)];
                const float depth = (distanceM + kSkinDepthM - task.nearestM) * task.depthsPerM;
                samples.headDepth.at(static_cast<std::size_t>(inTile(x, y))) = depth;
                nearestHead = std::min(nearestHead, depth);
            }
    }
    Canvas canvas{.task = task, .samples = samples, .open = task.width * task.height};
    constexpr std::size_t kAhead = 8;
    for (std::size_t i = 0; i < samples.sorted.size() && canvas.open > 0; ++i) {
        const TileEntry& ahead = samples.sorted[std::min(i + kAhead, samples.sorted.size() - 1)];
        hwy::Prefetch(&segments[ahead.batch][ahead.segment]);
        const TileEntry& entry = samples.sorted[i];
        const ScreenSegment& segment = segments[entry.batch][entry.segment];
        const bool steep = std::abs(segment.y1 - segment.y0) > std::abs(segment.x1 - segment.x0);
        const bool head = static_cast<float>(std::max(segment.depth0, segment.depth1)) > nearestHead;
        if (head)
            steep ? layOne<true, true>(canvas, segment) : layOne<false, true>(canvas, segment);
        else
            steep ? layOne<true, false>(canvas, segment) : layOne<false, false>(canvas, segment);
    }
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::rendering {

HWY_EXPORT(layAll);

void layHair(const TileTask& task, SegmentLists segments, TileSamples& samples)
{
    HWY_DYNAMIC_DISPATCH(layAll)(task, segments, samples);
}

} // namespace hairpaint::rendering
#endif
