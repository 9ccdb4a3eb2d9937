// Puts what lies behind the hair into a tile and encodes its pixels.
#include "view/rendering/software/resolve_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/rendering/software/resolve_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/rendering/light/lanes_inl.h"
#include "view/rendering/light/tone_inl.h"
#include <algorithm>
#include <array>
#include <cstring>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// Light / kMostLight of hair and head in a row of samples, and the part through which the background is seen; then of
/// pixels.
struct RowOfLight
{
    HWY_ALIGN std::array<float, kTileSp> red;
    HWY_ALIGN std::array<float, kTileSp> green;
    HWY_ALIGN std::array<float, kTileSp> blue;
    HWY_ALIGN std::array<float, kTileSp> through;

    void clear()
    {
        for (auto* row : {&red, &green, &blue, &through})
            row->fill(0.0F);
    }

    /// Sums `across` samples each.
    void shrink(int across)
    {
        for (; across > 1; across /= 2)
            for (auto* row : {&red, &green, &blue, &through})
                for (std::size_t i = 0; i < kTileSp / 2; ++i)
                    (*row)[i] = (*row)[2 * i] + (*row)[2 * i + 1];
    }
};

/// Where more is left to see through, it is the edge of the coat, not a gap in it.
constexpr float kLeftOfHair = 0.75F;

HWY_INLINE void addTo(float* row, Lanes more)
{
    stored(loaded(row) + more, row);
}

/// Values of cells along a row of the tile's pixels, interpolated between two rows of cells; for the cells that the
/// tile lies over, and one more on either side.
struct RowOfCells
{
    static constexpr int kMost = kTileSp + 2;
    HWY_ALIGN std::array<float, kMost + kMostLanes> values;
    int first = 0; ///< Number of the first cell.
    int last = 0;

    HWY_INLINE void take(const ResolveTask& resolve, const float* cells, int pixels, int y)
    {
        const float up = std::clamp((static_cast<float>(y) + 0.5F) / static_cast<float>(resolve.shadeCell) - 0.5F, 0.0F,
                                    static_cast<float>(resolve.shadeUp - 1));
        const int y0 = static_cast<int>(up);
        const int y1 = std::min(y0 + 1, resolve.shadeUp - 1);
        const auto rowOf = [&](int row) {
            return cells + static_cast<std::size_t>(row) * static_cast<std::size_t>(resolve.shadeAcross);
        };
        const float* low = rowOf(y0);
        const float* high = rowOf(y1);
        first = std::max(resolve.firstPixelX / resolve.shadeCell - 1, 0);
        last = std::min((resolve.firstPixelX + pixels) / resolve.shadeCell + 1, resolve.shadeAcross - 1);
        for (int i = first; i <= last; ++i)
            values[static_cast<std::size_t>(i - first)] = low[i] + (high[i] - low[i]) * (up - static_cast<float>(y0));
    }

    /// At pixels `x`, between the cells' middles.
    [[nodiscard]] HWY_INLINE Lanes at(const ResolveTask& resolve, Lanes x) const
    {
        const IntTag di;
        const auto most = static_cast<float>(last - first);
        const Lanes position = clamped((x + Lanes(0.5F)) * Lanes(1.0F / static_cast<float>(resolve.shadeCell)) -
                                           Lanes(0.5F + static_cast<float>(first)),
                                       0.0F, most);
        const Lanes low = floored(position);
        const auto valueAt = [&](Lanes number) {
            return Lanes(hn::GatherIndex(Tag(), values.data(), hn::ConvertTo(di, number.v)));
        };
        return mixed(valueAt(low), valueAt(least(low + Lanes(1.0F), Lanes(most))), position - low);
    }
};

/// A row of both kinds of cells.
struct CellRows
{
    RowOfCells shade;
    RowOfCells hidden;
};

/// Adds a row of samples.
HWY_INLINE void addSamples(const TileTask& task, const ResolveTask& resolve, const TileSamples& samples, int y,
                           const CellRows& cells, RowOfLight& row)
{
    const hn::Rebind<std::uint16_t, Tag> du;
    const float* light = samples.light.data() + 4 * static_cast<std::ptrdiff_t>(inTile(0, y));
    const HeadSample* head = task.anyHead ? task.head + static_cast<std::size_t>(y) * task.headStride : nullptr;
    for (std::size_t x = 0; x < kTileSp; x += hn::Lanes(Tag())) {
        Lanes red;
        Lanes green;
        Lanes blue;
        Lanes left;
        hn::LoadInterleaved4(Tag(), light + 4 * x, red.v, green.v, blue.v, left.v);
        if (head == nullptr && !any(left < Lanes(1.0F))) {
            addTo(row.through.data() + x, left);
            continue;
        }
        // A sample that counts as opaque shows nothing behind: the hair's light is scaled up to cover it.
        if (const Yes opaque = left < Lanes(task.opaque); any(opaque)) {
            const Lanes gain = select(opaque, Lanes(1.0F) / (Lanes(1.0F) - left), Lanes(1.0F));
            left = select(opaque, Lanes(0.0F), left);
            red = red * gain;
            green = green * gain;
            blue = blue * gain;
        }
        const Lanes pixel = Lanes(static_cast<float>(resolve.firstPixelX)) +
                            floored((Lanes(hn::Iota(Tag(), 0.0F)) + Lanes(static_cast<float>(x))) *
                                    Lanes(1.0F / static_cast<float>(resolve.samplesX)));
        if (resolve.hidden != nullptr && any((left > Lanes(0.0F)) & (left < Lanes(kLeftOfHair)))) {
            // Hair behind that was not drawn is taken to be like the hair in front, but darker.
            const Lanes covered = Lanes(1.0F) - left;
            const Lanes dense = clamped((covered - Lanes(1.0F - kLeftOfHair)) * Lanes(3.0F), 0.0F, 1.0F);
            const Lanes filled = left * dense * cells.hidden.at(resolve, pixel);
            const Lanes more = Lanes(1.0F) + filled * Lanes(0.6F) / most(covered, Lanes(1e-3F));
            red = red * more;
            green = green * more;
            blue = blue * more;
            left = left - filled;
        }
        if (head != nullptr) {
            hn::Vec<decltype(du)> parts[4];
            hn::LoadInterleaved4(du, reinterpret_cast<const std::uint16_t*>(head + x), parts[0], parts[1], parts[2],
                                 parts[3]);
            const auto unitOf = [](hn::Vec<decltype(du)> part) {
                return Lanes(hn::ConvertTo(Tag(), hn::PromoteTo(IntTag(), part))) * Lanes(1.0F / 65535.0F);
            };
            const Lanes cover = unitOf(parts[3]);
            if (any(cover > Lanes(0.0F))) {
                const Lanes shade = resolve.shade != nullptr ? cells.shade.at(resolve, pixel) : Lanes(1.0F);
                const Lanes spread(resolve.shadeSpread);
                const Lanes redder = spread * Lanes(0.35F) * (root(shade) - shade);
                const Lanes lessBlue = spread * Lanes(0.2F) * shade * (Lanes(1.0F) - shade);
                const auto lit = [&](hn::Vec<decltype(du)> part, Lanes shaded) {
                    const Lanes skin = unitOf(part);
                    return skin * skin * (left * cover * shaded);
                };
                red = red + lit(parts[0], shade + redder);
                green = green + lit(parts[1], shade);
                blue = blue + lit(parts[2], shade - lessBlue);
                left = left * (Lanes(1.0F) - cover);
            }
        }
        addTo(row.red.data() + x, red);
        addTo(row.green.data() + x, green);
        addTo(row.blue.data() + x, blue);
        addTo(row.through.data() + x, left);
    }
}

/// The first `used` lanes, as many pixels.
HWY_INLINE void storePixels(Ints rgba, std::size_t used, std::uint8_t* to)
{
    if (used == hn::Lanes(IntTag())) {
        hn::StoreU(rgba, IntTag(), reinterpret_cast<std::int32_t*>(to));
        return;
    }
    HWY_ALIGN std::int32_t whole[kMostLanes];
    hn::Store(rgba, IntTag(), whole);
    std::memcpy(to, whole, 4 * used);
}

/// 0..1 as 0..255.
HWY_INLINE Ints byteOf(Lanes part)
{
    return hn::ConvertTo(IntTag(), (clamped(part, 0.0F, 1.0F) * Lanes(255.0F) + Lanes(0.5F)).v);
}

HWY_INLINE Ints rgba(Ints red, Ints green, Ints blue, Ints alpha)
{
    return hn::Or(hn::Or(red, hn::ShiftLeft<8>(green)), hn::Or(hn::ShiftLeft<16>(blue), hn::ShiftLeft<24>(alpha)));
}

/// The first `used` lanes.
HWY_INLINE void storeLinear(const Triple<Lanes>& colour, Lanes alpha, std::size_t used, float* to)
{
    HWY_ALIGN float whole[4 * kMostLanes];
    hn::StoreInterleaved4(colour.x.v, colour.y.v, colour.z.v, alpha.v, Tag(), whole);
    std::memcpy(to, whole, 4 * used * sizeof(float));
}

void resolveAll(const TileTask& task, const ResolveTask& resolve, const TileSamples& samples, std::uint8_t* pixels)
{
    const float perPixel = 1.0F / static_cast<float>(resolve.samplesX * resolve.samplesY);
    const auto count = static_cast<std::size_t>(task.width / resolve.samplesX);
    RowOfLight light;
    CellRows cells;
    for (int py = 0; py < task.height / resolve.samplesY; ++py) {
        const int row = resolve.firstPixelY + py;
        const float rise = (static_cast<float>(row) + 0.5F) / static_cast<float>(resolve.pictureHeight) * 2.0F - 1.0F;
        const glm::vec3 srgb = glm::clamp(resolve.background + resolve.backgroundRise * rise, 0.0F, 1.0F);
        const Ints bareRgba = resolve.transparent ? hn::Zero(IntTag())
                                                  : rgba(byteOf(Lanes(srgb.x)), byteOf(Lanes(srgb.y)),
                                                         byteOf(Lanes(srgb.z)), hn::Set(IntTag(), 255));
        const std::size_t first =
            static_cast<std::size_t>(resolve.pictureHeight - 1 - row) * static_cast<std::size_t>(resolve.pictureWidth) +
            static_cast<std::size_t>(resolve.firstPixelX);
        if (task.bare) {
            for (std::size_t x = 0; x < count; x += hn::Lanes(Tag()))
                storePixels(bareRgba, std::min(count - x, hn::Lanes(Tag())), pixels + 4 * (first + x));
            continue;
        }
        const Triple<Lanes> background =
            tripleOf<Lanes>(glm::vec3(linearFromSrgb(srgb.x), linearFromSrgb(srgb.y), linearFromSrgb(srgb.z)));
        if (resolve.hidden != nullptr)
            cells.hidden.take(resolve, resolve.hidden, static_cast<int>(count), row);
        if (resolve.shade != nullptr && task.anyHead)
            cells.shade.take(resolve, resolve.shade, static_cast<int>(count), row);
        light.clear();
        for (int sy = py * resolve.samplesY; sy < (py + 1) * resolve.samplesY; ++sy)
            addSamples(task, resolve, samples, sy, cells, light);
        light.shrink(resolve.samplesX);
        for (std::size_t x = 0; x < count; x += hn::Lanes(Tag())) {
            const std::size_t used = std::min(count - x, hn::Lanes(Tag()));
            const Lanes through = loaded(light.through.data() + x) * Lanes(perPixel);
            const Yes covered = through < Lanes(1.0F);
            Ints shown = bareRgba;
            if (any(covered) || resolve.linear != nullptr) {
                const Lanes cover = Lanes(1.0F) - through;
                const Lanes alpha = resolve.transparent ? cover : Lanes(1.0F);
                const Triple<Lanes> lightThere =
                    Triple<Lanes>{loaded(light.red.data() + x), loaded(light.green.data() + x),
                                  loaded(light.blue.data() + x)} *
                    Lanes(perPixel * kMostLight);
                const auto over = [&](const Triple<Lanes>& front) {
                    return resolve.transparent ? front : front + background * through;
                };
                if (resolve.linear != nullptr)
                    storeLinear(over(lightThere), alpha, used, resolve.linear + 4 * (first + x));
                // Only the scene's light is toned; the background is the screen's own colour.
                Triple<Lanes> screen = lightThere;
                if (any(through > Lanes(0.0F))) {
                    const Triple<Lanes> toned = toneOf(lightThere * (Lanes(1.0F) / most(cover, Lanes(1e-6F))));
                    screen = resolve.transparent ? toned : over(toned * cover);
                } else {
                    screen = toneOf(lightThere);
                }
                const Ints lit = rgba(byteOf(fastSrgb(screen.x)), byteOf(fastSrgb(screen.y)),
                                      byteOf(fastSrgb(screen.z)), byteOf(alpha));
                shown = hn::IfThenElse(hn::RebindMask(IntTag(), covered.m), lit, bareRgba);
            }
            storePixels(shown, used, pixels + 4 * (first + x));
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
