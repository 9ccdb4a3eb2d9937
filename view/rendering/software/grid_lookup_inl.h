// Looking up the opacity grids.
#if defined(HAIRPAINT_RENDERING_GRID_LOOKUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_GRID_LOOKUP_INL_H_
#undef HAIRPAINT_RENDERING_GRID_LOOKUP_INL_H_
#else
#define HAIRPAINT_RENDERING_GRID_LOOKUP_INL_H_
#endif

#include "view/rendering/light/lanes_inl.h"

#include <glm/glm.hpp>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// 0..1 in the grid; a little before the place, so that a strand does not shade itself.
HWY_INLINE Triple<Lanes> inGrid(const glm::mat4& gridFromWo, const Triple<Lanes>& p, float before)
{
    const auto row = [&](int r, float less) {
        return p.x * Lanes(gridFromWo[0][r]) + p.y * Lanes(gridFromWo[1][r]) + p.z * Lanes(gridFromWo[2][r]) +
               Lanes(gridFromWo[3][r] - less);
    };
    return {row(0, 0.0F), row(1, 0.0F), row(2, before)};
}

/// Between the middles of voxels; the outermost ones go on.
HWY_INLINE Lanes opacityAt(const float* grid, int side, const Triple<Lanes>& place)
{
    const IntTag di;
    const auto size = static_cast<float>(side);
    const auto along = [&](Lanes p, Lanes& part) {
        const Lanes at = clamped(p * Lanes(size) - Lanes(0.5F), 0.0F, size - 1.001F);
        const Lanes low = floored(at);
        part = at - low;
        return hn::ConvertTo(di, low.v);
    };
    Lanes fx;
    Lanes fy;
    Lanes fz;
    const Ints x = along(place.x, fx);
    const Ints y = along(place.y, fy);
    const Ints z = along(place.z, fz);
    const Ints first = hn::Add(hn::Mul(hn::Add(hn::Mul(z, hn::Set(di, side)), y), hn::Set(di, side)), x);
    const auto voxel = [&](int offset) { return Lanes(hn::GatherIndex(Tag(), grid + offset, first)); };
    const int slice = side * side;
    const Lanes low = mixed(mixed(voxel(0), voxel(1), fx), mixed(voxel(side), voxel(side + 1), fx), fy);
    const Lanes high =
        mixed(mixed(voxel(slice), voxel(slice + 1), fx), mixed(voxel(slice + side), voxel(slice + side + 1), fx), fy);
    return mixed(low, high, fz);
}

/// All of the column that the place lies in.
HWY_INLINE Lanes columnAt(const float* grid, int side, const Triple<Lanes>& place)
{
    const IntTag di;
    const auto size = static_cast<float>(side);
    const Lanes x = clamped(place.x * Lanes(size) - Lanes(0.5F), 0.0F, size - 1.001F);
    const Lanes y = clamped(place.y * Lanes(size) - Lanes(0.5F), 0.0F, size - 1.001F);
    const Lanes lowX = floored(x);
    const Lanes lowY = floored(y);
    const Ints first = hn::Add(hn::Mul(hn::ConvertTo(di, lowY.v), hn::Set(di, side)), hn::ConvertTo(di, lowX.v));
    const float* last = grid + (side - 1) * side * side;
    const auto voxel = [&](int offset) { return Lanes(hn::GatherIndex(Tag(), last + offset, first)); };
    return mixed(mixed(voxel(0), voxel(1), x - lowX), mixed(voxel(side), voxel(side + 1), x - lowX), y - lowY);
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
