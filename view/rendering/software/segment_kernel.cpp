// Sixteen segments at a time.
#include "view/rendering/software/segment_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "view/rendering/software/segment_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "view/rendering/light/lanes_inl.h"
#include <algorithm>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

HWY_INLINE Ints wholeOf(Lanes positive)
{
    return hn::ConvertTo(IntTag(), positive.v);
}

/// Two whole numbers of 16 bits as one.
HWY_INLINE void storedPair(Ints low, Ints high, std::uint32_t* to)
{
    hn::StoreU(hn::Or(low, hn::ShiftLeft<16>(high)), IntTag(), reinterpret_cast<std::int32_t*>(to));
}

HWY_INLINE std::uint32_t bitsOf(Yes yes)
{
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Tag(), yes.m, bytes);
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U;
}

void boundsOfAll(const TileGrid& tiles, const StrandPoints& points, int segments, SegmentBounds& bounds)
{
    constexpr float kUnitsPerSample = 1.0F / kWidthUnit;
    constexpr float kLeastUnits = 1.0F;
    constexpr float kMostUnits = 65535.0F;
    const auto tilesOf = [](Lanes a, Lanes b, Lanes reach, float last, std::uint32_t* to) {
        const Lanes low = clamped((least(a, b) - reach) * Lanes(1.0F / kTileSp), 0.0F, last);
        const Lanes high = clamped((most(a, b) + reach) * Lanes(1.0F / kTileSp), 0.0F, last);
        storedPair(wholeOf(low), wholeOf(high), to);
    };
    for (std::size_t j = 0; j < static_cast<std::size_t>(segments); ++j) {
        std::uint32_t seen = 0;
        for (std::size_t lane = 0; lane < kMostLanes; lane += hn::Lanes(Tag())) {
            const std::size_t a = j * kMostLanes + lane;
            const std::size_t b = a + kMostLanes;
            const Lanes w0 = loaded(points.width.data() + a) * Lanes(kUnitsPerSample);
            const Lanes w1 = loaded(points.width.data() + b) * Lanes(kUnitsPerSample);
            const Yes wide = most(w0, w1) > Lanes(kLeastUnits);
            if (!any(wide))
                continue;
            const Lanes x0 = loaded(points.x.data() + a);
            const Lanes y0 = loaded(points.y.data() + a);
            const Lanes x1 = loaded(points.x.data() + b);
            const Lanes y1 = loaded(points.y.data() + b);
            const Lanes reach = Lanes(1.0F) + most(w0, w1) * Lanes(0.5F * kWidthUnit);
            // False for what is not a number.
            const auto within = [&](Lanes p, Lanes q, int first, int size) {
                const Lanes begin(static_cast<float>(first));
                const Lanes end(static_cast<float>(size));
                return ((p + reach > begin) | (q + reach > begin)) & ((p - reach < end) | (q - reach < end));
            };
            const Yes inside = wide & within(x0, x1, 0, tiles.width) &
                               within(y0, y1, tiles.firstUp * kTileSp, std::min(tiles.endUp * kTileSp, tiles.height));
            seen |= bitsOf(inside) << lane;
            tilesOf(x0, x1, reach, static_cast<float>(tiles.across - 1), bounds.tilesX.data() + a);
            tilesOf(y0, y1, reach, static_cast<float>(tiles.up - 1), bounds.tilesY.data() + a);
            storedPair(wholeOf(loaded(points.depth.data() + a)), wholeOf(loaded(points.depth.data() + b)),
                       bounds.depths.data() + a);
            storedPair(wholeOf(least(w0 + Lanes(0.5F), Lanes(kMostUnits))),
                       wholeOf(least(w1 + Lanes(0.5F), Lanes(kMostUnits))), bounds.widths.data() + a);
        }
        bounds.lanes[j] = seen & points.mayBeSeen[j];
    }
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::rendering {

HWY_EXPORT(boundsOfAll);

void findBounds(const TileGrid& tiles, const StrandPoints& points, int segments, SegmentBounds& bounds)
{
    bounds.resize(static_cast<std::size_t>(segments));
    HWY_DYNAMIC_DISPATCH(boundsOfAll)(tiles, points, segments, bounds);
}

} // namespace hairpaint::rendering
#endif
