// Lays hair over a tile and resolves it to pixels.
#include "view/rendering/software/tile_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/rendering/software/tile_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/rendering/light/lanes_inl.h"
#include <algorithm>
#include <cmath>
#include <hwy/highway.h>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// Hair that lies flat dips into the skin here and there; it is shown all the same.
constexpr float kSkinDepthM = 0.015F;
constexpr float kOpaque = 0.004F; ///< Less that is left to see through is nothing.

/// Colour from 10 bits each, linear; the fourth is -1, so that adding it takes from what is left to see through.
HWY_INLINE Quad colourOf(std::uint32_t bits)
{
    constexpr std::uint32_t kMask = 0x3FFU;
    constexpr float kUnit = 1.0F / 1023.0F;
    const float r = static_cast<float>(bits & kMask) * kUnit;
    const float g = static_cast<float>((bits >> 10U) & kMask) * kUnit;
    const float b = static_cast<float>((bits >> 20U) & kMask) * kUnit;
    HWY_ALIGN const float values[4] = {r * r, g * g, b * b, -1.0F};
    return quadOf(values);
}

/// Walks a segment along its main direction; a sample gets as much of it as the strand covers, by a filter one sample
/// wide and never narrower than a tent over two. Returns how many samples became opaque.
template<bool kSteep, bool kHead>
HWY_INLINE int layOne(const TileTask& task, const ScreenSegment& segment, const float* headDepth, float* light)
{
    float main0 = (kSteep ? segment.y0 - static_cast<float>(task.y0) : segment.x0 - static_cast<float>(task.x0));
    float main1 = (kSteep ? segment.y1 - static_cast<float>(task.y0) : segment.x1 - static_cast<float>(task.x0));
    float across0 = (kSteep ? segment.x0 - static_cast<float>(task.x0) : segment.y0 - static_cast<float>(task.y0));
    float across1 = (kSteep ? segment.x1 - static_cast<float>(task.x0) : segment.y1 - static_cast<float>(task.y0));
    float width0 = static_cast<float>(segment.width0) * kWidthUnit;
    float width1 = static_cast<float>(segment.width1) * kWidthUnit;
    float depth0 = segment.depth0;
    float depth1 = segment.depth1;
    std::uint32_t bits0 = segment.colour0;
    std::uint32_t bits1 = segment.colour1;
    if (main0 > main1) {
        std::swap(main0, main1);
        std::swap(across0, across1);
        std::swap(width0, width1);
        std::swap(depth0, depth1);
        std::swap(bits0, bits1);
    }
    const int mainEnd = kSteep ? task.height : task.width;
    const int acrossEnd = kSteep ? task.width : task.height;
    // Samples whose middle lies in main0..main1.
    const auto cut = [](float place) { return static_cast<int>(std::clamp(place, -1.0F, 64.0F) + 1.5F) - 1; };
    const int begin = std::max(cut(main0), 0);
    const int end = std::min(cut(main1), mainEnd);
    if (begin >= end)
        return 0;
    const float inverse = 1.0F / std::max(main1 - main0, 1e-6F);
    const float slope = (across1 - across0) * inverse;
    const float wider = (width1 - width0) * inverse;
    const float deeper = (depth1 - depth0) * inverse;
    const Quad colour0 = colourOf(bits0);
    const Quad bluer = colourOf(bits1) - colour0;
    int closed = 0;
    for (int i = begin; i < end; ++i) {
        const float along = static_cast<float>(i) + 0.5F - main0;
        const float middle = across0 + slope * along;
        const float width = width0 + wider * along;
        const float solid = width > 1.0F ? width : 1.0F;
        const float gain = width > 1.0F ? 1.0F : width;
        const float half = (solid + 1.0F) * 0.5F;
        if (!(middle + half > 0.0F && middle - half < static_cast<float>(kTileSp)))
            continue;
        int first = static_cast<int>(middle - half + 64.5F) - 64;
        int last = static_cast<int>(middle + half + 64.5F) - 64;
        first = first > 0 ? first : 0;
        last = last < acrossEnd ? last : acrossEnd;
        for (int k = first; k < last; ++k) {
            const int at = kSteep ? i * kTileSp + k : k * kTileSp + i;
            float* sample = light + 4 * static_cast<std::ptrdiff_t>(at);
            const float left = sample[3];
            if (left < kOpaque)
                continue;
            const float aside = std::abs(static_cast<float>(k) + 0.5F - middle);
            const float reach = half - aside;
            float cover = gain * (reach < 1.0F ? (reach > 0.0F ? reach : 0.0F) : 1.0F);
            if constexpr (kHead) {
                if (depth0 + deeper * along > headDepth[at]) {
                    const std::size_t head = static_cast<std::size_t>(kSteep ? i : k) * task.headStride +
                                             static_cast<std::size_t>(kSteep ? k : i);
                    cover *= 1.0F - static_cast<float>(task.head[head].cover) * (1.0F / 65535.0F);
                }
            }
            const float weight = cover * left;
            const Quad colour = colour0 + bluer * quadOf(along * inverse);
            stored(quadOf(sample) + colour * quadOf(weight), sample);
            closed += left - weight < kOpaque ? 1 : 0;
        }
    }
    return closed;
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

void layAll(const TileTask& task, SegmentLists segments, TileSamples& samples)
{
    HWY_ALIGN const float clear[4] = {0.0F, 0.0F, 0.0F, 1.0F};
    const Quad nothing = quadOf(clear);
    for (std::size_t i = 0; i < samples.light.size(); i += 4)
        stored(nothing, samples.light.data() + i);
    if (samples.entries.empty())
        return;
    sortByDepth(samples);
    float nearestHead = 1e9F;
    if (task.anyHead)
        for (int y = 0; y < task.height; ++y)
            for (int x = 0; x < task.width; ++x) {
                const float distanceM =
                    task.headDistanceM[static_cast<std::size_t>(y) * task.headStride + static_cast<std::size_t>(x)];
                const float depth = (distanceM + kSkinDepthM - task.nearestM) * task.depthsPerM;
                samples.headDepth.at(static_cast<std::size_t>(y * kTileSp + x)) = depth;
                nearestHead = std::min(nearestHead, depth);
            }
    int open = task.width * task.height;
    for (const TileEntry& entry : samples.sorted) {
        const ScreenSegment& segment = segments[entry.batch][entry.segment];
        const bool steep = std::abs(segment.y1 - segment.y0) > std::abs(segment.x1 - segment.x0);
        const bool head = static_cast<float>(std::max(segment.depth0, segment.depth1)) > nearestHead;
        float* light = samples.light.data();
        const float* headDepth = samples.headDepth.data();
        if (head)
            open -= steep ? layOne<true, true>(task, segment, headDepth, light)
                          : layOne<false, true>(task, segment, headDepth, light);
        else
            open -= steep ? layOne<true, false>(task, segment, headDepth, light)
                          : layOne<false, false>(task, segment, headDepth, light);
        if (open <= 0)
            break;
    }
}

/// Of one sample, linear, with what lies behind the hair.
HWY_INLINE Quad sampleOf(const float* light, const HeadSample* head, float shade, Quad background)
{
    Quad behind = background;
    if (head != nullptr && head->cover > 0) {
        constexpr float kUnit = 1.0F / 65535.0F;
        const auto square = [](std::uint16_t v) {
            const float f = static_cast<float>(v) * kUnit;
            return f * f;
        };
        HWY_ALIGN const float skin[4] = {square(head->red) * shade, square(head->green) * shade,
                                         square(head->blue) * shade, 0.0F};
        const float cover = static_cast<float>(head->cover) * kUnit;
        behind = background + (quadOf(skin) - background) * quadOf(cover);
    }
    return quadOf(light) + behind * quadOf(light[3]);
}

/// What is left of the skin's light at a pixel, between the middles of cells.
HWY_INLINE float shadeAt(const ResolveTask& resolve, int x, int y)
{
    if (resolve.shade == nullptr)
        return 1.0F;
    const auto along = [](int pixel, int cell, int count, int& low, int& high) {
        const float at = (static_cast<float>(pixel) + 0.5F) / static_cast<float>(cell) - 0.5F;
        const float bounded = std::clamp(at, 0.0F, static_cast<float>(count - 1));
        low = static_cast<int>(bounded);
        high = std::min(low + 1, count - 1);
        return bounded - static_cast<float>(low);
    };
    int x0 = 0;
    int x1 = 0;
    int y0 = 0;
    int y1 = 0;
    const float fx = along(x, resolve.shadeCell, resolve.shadeAcross, x0, x1);
    const float fy = along(y, resolve.shadeCell, resolve.shadeUp, y0, y1);
    const auto cell = [&](int cx, int cy) {
        return resolve.shade[static_cast<std::size_t>(cy) * static_cast<std::size_t>(resolve.shadeAcross) +
                             static_cast<std::size_t>(cx)];
    };
    const float low = cell(x0, y0) + (cell(x1, y0) - cell(x0, y0)) * fx;
    const float high = cell(x0, y1) + (cell(x1, y1) - cell(x0, y1)) * fx;
    return low + (high - low) * fy;
}

void resolveAll(const TileTask& task, const ResolveTask& resolve, const TileSamples& samples, std::uint8_t* pixels)
{
    const float perPixel = 1.0F / static_cast<float>(resolve.samplesX * resolve.samplesY);
    for (int py = 0; py < task.height / resolve.samplesY; ++py) {
        const int row = resolve.firstPixelY + py;
        const float rise = (static_cast<float>(row) + 0.5F) / static_cast<float>(resolve.pictureHeight) * 2.0F - 1.0F;
        const glm::vec3 srgb = glm::clamp(resolve.background + resolve.backgroundRise * rise, 0.0F, 1.0F);
        HWY_ALIGN const float linear[4] = {linearFromSrgb(srgb.x), linearFromSrgb(srgb.y), linearFromSrgb(srgb.z),
                                           0.0F};
        const Quad background = quadOf(linear);
        std::uint8_t* out = pixels + (static_cast<std::size_t>(resolve.pictureHeight - 1 - row) *
                                          static_cast<std::size_t>(resolve.pictureWidth) +
                                      static_cast<std::size_t>(resolve.firstPixelX)) *
                                         4;
        const auto byte = [](float v) { return static_cast<std::uint8_t>(v * 255.0F + 0.5F); };
        for (int px = 0; px < task.width / resolve.samplesX; ++px, out += 4) {
            float shade = -1.0F;
            bool bare = true;
            Quad sum = quadOf(0.0F);
            for (int sy = py * resolve.samplesY; sy < (py + 1) * resolve.samplesY; ++sy)
                for (int sx = px * resolve.samplesX; sx < (px + 1) * resolve.samplesX; ++sx) {
                    const float* light = samples.light.data() + 4 * static_cast<std::ptrdiff_t>(sy * kTileSp + sx);
                    const HeadSample* head = nullptr;
                    if (task.anyHead) {
                        head =
                            task.head + static_cast<std::size_t>(sy) * task.headStride + static_cast<std::size_t>(sx);
                        if (shade < 0.0F && head->cover > 0)
                            shade = shadeAt(resolve, resolve.firstPixelX + px, row);
                        bare = bare && head->cover == 0;
                    }
                    bare = bare && light[3] == 1.0F;
                    sum = sum + sampleOf(light, head, shade, background);
                }
            if (bare) {
                out[0] = byte(srgb.x);
                out[1] = byte(srgb.y);
                out[2] = byte(srgb.z);
                out[3] = 255;
                continue;
            }
            const Quad c = most(least(sum * quadOf(perPixel), quadOf(1.0F)), quadOf(0.0F));
            // As fastSrgb.
            const Quad s1 = root(c);
            const Quad s2 = root(s1);
            const Quad s3 = root(s2);
            const Quad curve = s1 * quadOf(0.662002687F) + s2 * quadOf(0.684122060F) - s3 * quadOf(0.323583601F) -
                               c * quadOf(0.0225411470F);
            const Quad encoded = least(most(curve, least(c, quadOf(0.0031F)) * quadOf(12.92F)), quadOf(1.0F));
            HWY_ALIGN float result[4];
            stored(encoded, result);
            out[0] = byte(result[0]);
            out[1] = byte(result[1]);
            out[2] = byte(result[2]);
            out[3] = 255;
        }
    }
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::rendering {

HWY_EXPORT(layAll);
HWY_EXPORT(resolveAll);

void layHair(const TileTask& task, SegmentLists segments, TileSamples& samples)
{
    HWY_DYNAMIC_DISPATCH(layAll)(task, segments, samples);
}

void resolveTile(const TileTask& task, const ResolveTask& resolve, const TileSamples& samples, std::uint8_t* pixels)
{
    HWY_DYNAMIC_DISPATCH(resolveAll)(task, resolve, samples, pixels);
}

} // namespace hairpaint::rendering
#endif
