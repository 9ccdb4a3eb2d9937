// Puts what lies behind the hair into a tile and encodes its pixels.
#include "view/rendering/software/tile_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/rendering/software/resolve_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/rendering/light/lanes_inl.h"
#include "view/rendering/light/tone_inl.h"
#include <algorithm>
#include <cmath>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// Of one sample: light / kMostLight of hair and head, and the part through which the background is seen.
HWY_INLINE Quad sampleOf(const float* light, const HeadSample* head, float shade, float opaque)
{
    HWY_ALIGN constexpr float kNothing[4] = {0.0F, 0.0F, 0.0F, 1.0F};
    HWY_ALIGN constexpr float kLightAlone[4] = {1.0F, 1.0F, 1.0F, 0.0F};
    Quad behind = quadOf(kNothing);
    if (head != nullptr && head->cover > 0) {
        constexpr float kUnit = 1.0F / 65535.0F;
        const auto square = [](std::uint16_t v) {
            const float f = static_cast<float>(v) * kUnit;
            return f * f;
        };
        const float cover = static_cast<float>(head->cover) * kUnit;
        const float lit = shade * cover;
        HWY_ALIGN const float skin[4] = {square(head->red) * lit, square(head->green) * lit, square(head->blue) * lit,
                                         1.0F - cover};
        behind = quadOf(skin);
    }
    // What is opaque shows nothing behind; what it lacks is the hair's own.
    if (light[3] < opaque)
        return quadOf(light) * quadOf(kLightAlone) * quadOf(1.0F / (1.0F - light[3]));
    return quadOf(light) * quadOf(kLightAlone) + behind * quadOf(light[3]);
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

/// Encoded sRGB of the square root of light / kMostLight, and of the screen's linear colour. The square root spreads
/// dark tones, so that a table tells neighbouring bytes apart.
struct SrgbTables
{
    static constexpr int kSteps = 4095;
    using Bytes = std::array<std::uint8_t, kSteps + 1>;
    Bytes ofLight;
    Bytes ofScreen;
    SrgbTables()
    {
        const auto byte = [](float linear) {
            return static_cast<std::uint8_t>(std::floor(least(fastSrgb(linear), 1.0F) * 255.0F + 0.5F));
        };
        for (std::size_t i = 0; i <= kSteps; ++i) {
            const float root = static_cast<float>(i) * (1.0F / kSteps);
            ofLight.at(i) = byte(toneOf(root * root * kMostLight));
            ofScreen.at(i) = byte(root * root);
        }
    }
};

/// Light of the scene over the background, on the screen: `lit` as sampleOf has it. Only the scene's light is toned;
/// the background is the screen's own colour.
HWY_INLINE Quad overBackground(const float* lit, Quad background)
{
    const float cover = most(1.0F - lit[3], 1e-6F);
    if (most(lit[0], most(lit[1], lit[2])) * kMostLight <= kToneKnee * cover)
        return quadOf(lit) * quadOf(kMostLight) + background * quadOf(lit[3]);
    HWY_ALIGN float toned[4] = {};
    for (int c = 0; c < 3; ++c)
        toned[c] = toneOf(lit[c] * kMostLight / cover) * cover;
    return quadOf(toned) + background * quadOf(lit[3]);
}

void resolveAll(const TileTask& task, const ResolveTask& resolve, const TileSamples& samples, std::uint8_t* pixels)
{
    static const SrgbTables tables;
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
        const auto byte = [](float v) { return static_cast<std::uint8_t>(std::floor(v * 255.0F + 0.5F)); };
        for (int px = 0; px < task.width / resolve.samplesX; ++px, out += 4) {
            float shade = -1.0F;
            bool bare = true;
            Quad sum = quadOf(0.0F);
            for (int sy = py * resolve.samplesY; sy < (py + 1) * resolve.samplesY; ++sy)
                for (int sx = px * resolve.samplesX; sx < (px + 1) * resolve.samplesX; ++sx) {
                    const float* light = samples.light.data() + 4 * static_cast<std::ptrdiff_t>(inTile(sx, sy));
                    const HeadSample* head = nullptr;
                    if (task.anyHead) {
                        head =
                            task.head + static_cast<std::size_t>(sy) * task.headStride + static_cast<std::size_t>(sx);
                        if (shade < 0.0F && head->cover > 0)
                            shade = shadeAt(resolve, resolve.firstPixelX + px, row);
                        bare = bare && head->cover == 0;
                    }
                    bare = bare && light[3] == 1.0F;
                    sum = sum + sampleOf(light, head, shade, task.opaque);
                }
            if (bare) {
                out[0] = byte(srgb.x);
                out[1] = byte(srgb.y);
                out[2] = byte(srgb.z);
                out[3] = 255;
                continue;
            }
            HWY_ALIGN float lit[4];
            stored(sum * quadOf(perPixel), lit);
            const bool edge = lit[3] > 0.0F;
            const Quad screen = edge ? overBackground(lit, background) : quadOf(lit);
            const SrgbTables::Bytes& bytes = edge ? tables.ofScreen : tables.ofLight;
            const Quad shown = root(most(least(screen, quadOf(1.0F)), quadOf(0.0F)));
            HWY_ALIGN float result[4];
            stored(shown * quadOf(static_cast<float>(SrgbTables::kSteps)) + quadOf(0.5F), result);
            for (int c = 0; c < 3; ++c)
                out[c] = bytes[static_cast<std::size_t>(static_cast<std::int32_t>(result[c]))];
            out[3] = 255;
        }
    }
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::rendering {

HWY_EXPORT(resolveAll);

void resolveTile(const TileTask& task, const ResolveTask& resolve, const TileSamples& samples, std::uint8_t* pixels)
{
    HWY_DYNAMIC_DISPATCH(resolveAll)(task, resolve, samples, pixels);
}

} // namespace hairpaint::rendering
#endif
