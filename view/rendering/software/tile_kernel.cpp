// Lays hair over a tile.
#include "view/rendering/software/tile_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/rendering/software/tile_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/rendering/light/lanes_inl.h"
#include "view/rendering/software/sample_pair_inl.h"
#include "view/rendering/software/tile_canvas_inl.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <hwy/cache_control.h>
#include <hwy/highway.h>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// Colour from 10 bits each, linear; the fourth is -1, so that adding it takes from what is left to see through.
HWY_INLINE Quad colourOf(std::uint32_t bits)
{
    constexpr float kUnit = 1.0F / 1023.0F;
#if HWY_TARGET == HWY_SCALAR
    const auto channel = [bits](unsigned shift) {
        return static_cast<float>(static_cast<std::int32_t>((bits >> shift) & 0x3FFU)) * kUnit;
    };
    const Quad root{{channel(0), channel(10), channel(20), 1.0F}};
#else
    // A power of two brings down what no shift has.
    constexpr float kTen = 1.0F / 1024.0F;
    HWY_ALIGN static constexpr std::int32_t kMasks[4] = {0x3FF, 0x3FF << 10, 0x3FF << 20, 0};
    HWY_ALIGN static constexpr std::int32_t kOnes[4] = {0, 0, 0, 1};
    HWY_ALIGN static constexpr float kUnits[4] = {kUnit, kUnit * kTen, kUnit * kTen * kTen, 1.0F};
    const hn::FixedTag<std::int32_t, 4> di;
    const auto parts =
        hn::Or(hn::And(hn::Set(di, static_cast<std::int32_t>(bits)), hn::Load(di, kMasks)), hn::Load(di, kOnes));
    const Quad root = Quad{hn::ConvertTo(QuadTag(), parts)} * quadOf(kUnits);
#endif
    HWY_ALIGN static constexpr float kSigns[4] = {1.0F, 1.0F, 1.0F, -1.0F};
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
              .width0 = static_cast<float>(segment.width[0]) * kWidthUnit,
              .width1 = static_cast<float>(segment.width[1]) * kWidthUnit,
              .depth0 = static_cast<float>(segment.depth[0]),
              .depth1 = static_cast<float>(segment.depth[1]),
              .bits0 = segment.colour[0],
              .bits1 = segment.colour[1]};
    if (walk.main0 > walk.main1) {
        std::swap(walk.main0, walk.main1);
        std::swap(walk.across0, walk.across1);
        std::swap(walk.width0, walk.width1);
        std::swap(walk.depth0, walk.depth1);
        std::swap(walk.bits0, walk.bits1);
    }
    return walk;
}

/// A walk's values at a position along its main direction, or what they change by from sample to sample.
struct Pace
{
    float middle, width, depth;
    Quad colour;
};

/// Steps of a strand that is thinner than a sample, within a tile: a tent over the two samples that are nearest.
struct ThinSteps
{
    /// Coverage of both samples, step by step; spread() reads beyond the last.
    HWY_ALIGN float covers[2 * kTileSp + 8];
    HWY_ALIGN std::int32_t across[kTileSp]; ///< Position of the first sample; set only where the head is tested.
    HWY_ALIGN std::int32_t index[kTileSp];  ///< Index of the first sample's floats in the tile's light.
};

template<bool kSteep, bool kHead>
HWY_INLINE void fillSteps(int begin, int end, const Pace& at, const Pace& step, ThinSteps& steps)
{
    const hn::CappedTag<float, kCellSp> d;
    const hn::Rebind<std::int32_t, decltype(d)> di;
    for (std::size_t i = 0; i < static_cast<std::size_t>(end - begin); i += hn::Lanes(d)) {
        const auto number = hn::Add(hn::Iota(d, 0.0F), hn::Set(d, static_cast<float>(i)));
        const auto middle = hn::Add(hn::Set(d, at.middle - 0.5F), hn::Mul(hn::Set(d, step.middle), number));
        const auto low = hn::Floor(middle);
        // Out of the tile it covers nothing.
        const auto within =
            hn::And(hn::Ge(low, hn::Set(d, -1.0F)), hn::Lt(low, hn::Set(d, static_cast<float>(kTileSp))));
        const auto width =
            hn::IfThenElseZero(within, hn::Add(hn::Set(d, at.width), hn::Mul(hn::Set(d, step.width), number)));
        const auto cover1 = hn::Mul(width, hn::Sub(middle, low));
        const auto k =
            hn::ConvertTo(di, hn::Min(hn::Max(low, hn::Set(d, -1.0F)), hn::Set(d, static_cast<float>(kTileSp - 1))));
        // From a beginning that compilers do not know, Iota goes lane by lane through memory.
        const auto along = hn::Add(hn::Iota(di, 0), hn::Set(di, begin + static_cast<int>(i)));
        const auto row = kSteep ? along : k;
        const auto column = kSteep ? k : along;
        const auto sample = hn::Add(hn::Mul(row, hn::Set(di, kTileRow)), hn::Add(column, hn::Set(di, kTileRow + 1)));
        hn::StoreInterleaved2(hn::Sub(width, cover1), cover1, d, steps.covers + 2 * i);
        if constexpr (kHead)
            hn::Store(k, di, steps.across + i);
        hn::Store(hn::ShiftLeft<2>(sample), di, steps.index + i);
    }
}

template<bool kSteep, bool kHead>
HWY_INLINE void layThin(Canvas& canvas, int begin, int end, const Pace& at, const Pace& step)
{
    constexpr std::ptrdiff_t kNext = kSteep ? 1 : kTileRow; // To the second of the two.
    ThinSteps steps;
    fillSteps<kSteep, kHead>(begin, end, at, step, steps);
    if constexpr (kHead)
        for (int i = 0; i < end - begin; ++i) {
            float* covers = steps.covers + 2 * static_cast<std::ptrdiff_t>(i);
            const float depth = at.depth + step.depth * static_cast<float>(i);
            const float* depths = canvas.samples.headDepth.data() + steps.index[i] / 4;
            if (depth > std::min(depths[0], depths[kNext]))
                for (const int n : {0, 1}) {
                    const int across = steps.across[i] + n;
                    covers[n] = coverBeforeHead(canvas, kSteep ? across : begin + i, kSteep ? begin + i : across, depth,
                                                covers[n]);
                }
        }
    const Pair colourStep = pairOf(step.colour, step.colour);
    Pair colour = pairOf(at.colour, at.colour);
    for (int i = 0; i < end - begin; ++i, colour = colour + colourStep) {
        float* first = canvas.samples.light.data() + steps.index[i];
        float* second = first + 4 * kNext;
        const Pair before = loadedPair<kSteep>(first, second);
        const Pair covers = spread(steps.covers + 2 * static_cast<std::ptrdiff_t>(i));
        storedPair<kSteep>(before + colour * (covers * fourths(before)), first, second);
    }
}

/// Steps of any strand: its cover by a filter one sample wide.
template<bool kSteep, bool kHead>
HWY_INLINE void layWide(Canvas& canvas, int begin, int end, Pace at, const Pace& step)
{
    constexpr float kUp = 0.5F; // to the nearest: nothing here is negative
    for (int i = begin; i < end; ++i) {
        const float gain = std::min(at.width, 1.0F);
        const float half = (std::max(at.width, 1.0F) + 1.0F) * 0.5F;
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
            stored(quadOf(sample) + at.colour * quadOf(cover * left), sample);
        }
        at.middle += step.middle;
        at.width += step.width;
        at.depth += step.depth;
        at.colour = at.colour + step.colour;
    }
}

/// Walks a piece of a segment; a sample gets as much of it as the strand covers. Cells that are opaque already are
/// stepped over.
template<bool kSteep, bool kHead>
HWY_INLINE void layOne(Canvas& canvas, const ScreenSegment& segment, SegmentPiece piece)
{
    const Walk walk = walkOf<kSteep>(canvas.task, segment);
    const int mainEnd = kSteep ? canvas.task.height : canvas.task.width;
    // Samples whose middle lies in main0..main1.
    const auto cut = [](float position) { return static_cast<int>(std::clamp(position, -1.0F, 64.0F) + 1.5F) - 1; };
    const int begin = std::max(cut(walk.main0), piece.firstCell() * kCellSp);
    const int end = std::min({cut(walk.main1), mainEnd, (piece.lastCell() + 1) * kCellSp});
    if (begin >= end)
        return;
    const float inverse = 1.0F / std::max(walk.main1 - walk.main0, 1e-6F);
    const float slope = (walk.across1 - walk.across0) * inverse;
    const float widest = std::max(walk.width0, walk.width1);
    const float reach = (std::max(widest, 1.0F) + 1.0F) * 0.5F;
    const auto along = [&](int sample) { return static_cast<float>(sample) + 0.5F - walk.main0; };
    const auto lay = [&](int from, int to) {
        const Quad colour0 = colourOf(walk.bits0);
        const Pace step{.middle = slope,
                        .width = (walk.width1 - walk.width0) * inverse,
                        .depth = (walk.depth1 - walk.depth0) * inverse,
                        .colour = (colourOf(walk.bits1) - colour0) * quadOf(inverse)};
        const Pace at{.middle = walk.across0 + step.middle * along(from),
                      .width = walk.width0 + step.width * along(from),
                      .depth = walk.depth0 + step.depth * along(from),
                      .colour = colour0 + step.colour * quadOf(along(from))};
        if (widest <= 1.0F)
            layThin<kSteep, kHead>(canvas, from, to, at, step);
        else
            layWide<kSteep, kHead>(canvas, from, to, at, step);
    };
    constexpr float kSureDepths = 2.0F; // Steps round.
    const float nearest = std::min(walk.depth0, walk.depth1) - kSureDepths;
    const auto cellOf = [](int sample) { return static_cast<unsigned>(sample) / kCellSp; };
    const auto endOfCell = [&](int sample) { return std::min(static_cast<int>(cellOf(sample) + 1) * kCellSp, end); };
    const auto closedAt = [&](int sample) {
        const float first = walk.across0 + slope * along(sample);
        const float last = first + slope * static_cast<float>(endOfCell(sample) - 1 - sample);
        return isClosed<kSteep, kHead>(canvas, cellOf(sample), first, last, reach, nearest);
    };
    for (int from = begin; from < end;) {
        int to = from;
        while (to < end && !closedAt(to))
            to = endOfCell(to);
        if (from < to)
            lay(from, to);
        from = to < end ? endOfCell(to) : end;
    }
}

/// Appends `from` to `to` in the order of bits of their depths over `nearest`, equals in the order in which they came.
/// `counts`: how many have each value of these bits; becomes garbage.
void sortByBits(std::span<const TileEntry> from, std::uint32_t nearest, unsigned shift, std::span<std::uint32_t> counts,
                std::vector<TileEntry>& to)
{
    std::uint32_t sum = 0;
    for (std::uint32_t& count : counts)
        sum += std::exchange(count, sum);
    to.resize(from.size());
    const std::uint32_t mask = static_cast<std::uint32_t>(counts.size()) - 1;
    for (const TileEntry& entry : from)
        to[counts[((entry.depth - nearest) >> shift) & mask]++] = entry;
}

/// Sorts by depth, equals in the order in which they came. What lies far behind makes no difference to the order in
/// front, so that it may be left out.
void sortByDepth(TileSamples& samples)
{
    std::vector<TileEntry>& entries = samples.entries;
    std::uint32_t nearest = 0xFFFFU;
    std::uint32_t farthest = 0;
    for (const TileEntry& entry : entries) {
        nearest = std::min<std::uint32_t>(nearest, entry.depth);
        farthest = std::max<std::uint32_t>(farthest, entry.depth);
    }
    const auto bits = static_cast<unsigned>(std::bit_width(farthest - nearest));
    const unsigned low = bits - std::min(bits, TileSamples::kBucketBits);
    const std::span<std::uint32_t> lowCounts = std::span(samples.lowBuckets).first(std::size_t{1} << low);
    const std::span<std::uint32_t> counts = std::span(samples.buckets).first(std::size_t{1} << (bits - low));
    std::fill(lowCounts.begin(), lowCounts.end(), 0U);
    std::fill(counts.begin(), counts.end(), 0U);
    const std::uint32_t lowMask = static_cast<std::uint32_t>(lowCounts.size()) - 1;
    for (const TileEntry& entry : entries) {
        const std::uint32_t depth = entry.depth - nearest;
        ++lowCounts[depth & lowMask];
        ++counts[depth >> low];
    }
    if (low > 0) {
        sortByBits(entries, nearest, 0, lowCounts, samples.sorted);
        std::swap(entries, samples.sorted);
    }
    sortByBits(entries, nearest, low, counts, samples.sorted);
}

void clearTile(const TileTask& task, TileSamples& samples)
{
    HWY_ALIGN const float clear[4] = {0.0F, 0.0F, 0.0F, 1.0F};
    // Around the tile nothing can be seen through.
    std::fill_n(samples.light.begin(), 4 * kTileRow, 0.0F);
    for (int y = 0; y < kTileSp; ++y) {
        float* row = samples.light.data() + 4 * static_cast<std::ptrdiff_t>(inTile(0, y));
        std::fill_n(row - 4, 4, 0.0F);
        const int width = y < task.height ? task.width : 0;
        std::fill_n(row + 4 * static_cast<std::ptrdiff_t>(width), 4 * (kTileSp + 1 - width), 0.0F);
    }
    std::fill_n(samples.light.end() - 4 * kTileRow, 4 * kTileRow, 0.0F);
    for (int y = 0; y < kCells; ++y)
        for (int x = 0; x < kCells; ++x) {
            const bool inPicture = x * kCellSp < task.width && y * kCellSp < task.height;
            samples.firstOpen[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
                inPicture ? std::uint8_t{0} : std::uint8_t{kCellSamples};
        }
    for (int y = 0; y < task.height; ++y)
        for (int x = 0; x < task.width; ++x)
            stored(quadOf(clear), samples.light.data() + 4 * static_cast<std::ptrdiff_t>(inTile(x, y)));
}

void layAll(const TileTask& task, TileSamples& samples)
{
    clearTile(task, samples);
    if (samples.entries.empty())
        return;
    sortByDepth(samples);
    float nearestHead = 1e9F;
    if (task.anyHead) {
        constexpr float kNowhere = 1e9F;
        constexpr std::uint16_t kWhole = 0xFFFF;
        samples.headDepth.fill(kNowhere);
        samples.hiddenBeyond.fill({});
        for (int y = 0; y < task.height; ++y)
            for (int x = 0; x < task.width; ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * task.headStride + static_cast<std::size_t>(x);
                const float behindM = hairShownBehindM(task.worn != nullptr && task.worn[at] != 0);
                const float depth = (task.headDistanceM[at] + behindM - task.nearestM) * task.depthsPerM;
                samples.headDepth.at(static_cast<std::size_t>(inTile(x, y))) = depth;
                nearestHead = std::min(nearestHead, depth);
                float& beyond =
                    samples.hiddenBeyond[static_cast<std::size_t>(y / kCellSp)][static_cast<std::size_t>(x / kCellSp)];
                beyond = std::max(beyond, task.head[at].cover == kWhole ? depth : kNowhere);
            }
    }
    const int cellsAcross = (task.width + kCellSp - 1) / kCellSp; // The rest lies beside the picture.
    const int cellsUp = (task.height + kCellSp - 1) / kCellSp;
    Canvas canvas{.task = task, .samples = samples, .openCells = cellsAcross * cellsUp};
    constexpr std::size_t kAhead = 8;
    for (std::size_t i = 0; i < samples.sorted.size() && canvas.openCells > 0; ++i) {
        const TileEntry& ahead = samples.sorted[std::min(i + kAhead, samples.sorted.size() - 1)];
        hwy::Prefetch(&samples.segments[ahead.piece.segment()]);
        const TileEntry& entry = samples.sorted[i];
        const ScreenSegment& segment = samples.segments[entry.piece.segment()];
        const bool steep = std::abs(segment.y1 - segment.y0) > std::abs(segment.x1 - segment.x0);
        const bool head = static_cast<float>(std::max(segment.depth[0], segment.depth[1])) > nearestHead;
        if (head)
            steep ? layOne<true, true>(canvas, segment, entry.piece)
                  : layOne<false, true>(canvas, segment, entry.piece);
        else
            steep ? layOne<true, false>(canvas, segment, entry.piece)
                  : layOne<false, false>(canvas, segment, entry.piece);
    }
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::rendering {

HWY_EXPORT(layAll);

void layHair(const TileTask& task, TileSamples& samples)
{
    HWY_DYNAMIC_DISPATCH(layAll)(task, samples);
}

} // namespace hairpaint::rendering
#endif
