// Looking up the opacity grids.
#if defined(HAIRPAINT_RENDERING_GRID_LOOKUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_GRID_LOOKUP_INL_H_
#undef HAIRPAINT_RENDERING_GRID_LOOKUP_INL_H_
#else
#define HAIRPAINT_RENDERING_GRID_LOOKUP_INL_H_
#endif

#include "view/rendering/coat_axis.h"
#include "view/rendering/light/hair_light.h"
#include "view/rendering/light/lanes_inl.h"

#include <glm/glm.hpp>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// 0..1 in the grid; a little before the point, so that a strand does not shade itself.
HWY_INLINE Triple<Lanes> inGrid(const glm::mat4& gridFromWo, const Triple<Lanes>& p, float before)
{
    const auto row = [&](int r, float less) {
        return p.x * Lanes(gridFromWo[0][r]) + p.y * Lanes(gridFromWo[1][r]) + p.z * Lanes(gridFromWo[2][r]) +
               Lanes(gridFromWo[3][r] - less);
    };
    return {row(0, 0.0F), row(1, 0.0F), row(2, before)};
}

/// The same in the eye's grid, of a point of the picture.
HWY_INLINE Triple<Lanes> inEyeGrid(const EyeGrid& grid, Lanes x, Lanes y, Lanes distanceM, float before)
{
    return {(x - Lanes(grid.low.x)) * Lanes(grid.per.x), (y - Lanes(grid.low.y)) * Lanes(grid.per.y),
            (distanceM - Lanes(grid.low.z)) * Lanes(grid.per.z) - Lanes(before)};
}

/// A position in a grid, moved across its z out of the coat where that faces the light, or the eye, or stands steep.
HWY_INLINE Triple<Lanes> outOfCoat(const Triple<Lanes>& position, const CoatAxis& axis, int side)
{
    constexpr float kFacesAway = 3.0F; ///< Over the cosine from which on nothing is moved.
    const Triple<Lanes> d = position - tripleOf<Lanes>(axis.middle);
    const Triple<Lanes> out = d - tripleOf<Lanes>(axis.down) * most(dot(d, tripleOf<Lanes>(axis.perDown)), 0.0F);
    const Lanes per = Lanes(1.0F) / root(most(dot(out, out), 1e-12F));
    const Lanes part = clamped(Lanes(1.0F) - out.z * per * Lanes(kFacesAway), 0.0F, 1.0F);
    const Lanes move = per * part * Lanes(kOutOfCoatVoxels / static_cast<float>(side));
    return {position.x + out.x * move, position.y + out.y * move, position.z};
}

/// Where a point lies between the middles of voxels; the outermost ones go on.
struct GridPosition
{
    Ints first; ///< Number of the lowest voxel.
    Lanes x, y, z;
};

/// `slices` voxels along z are looked up from there.
HWY_INLINE GridPosition positionIn(int side, const Triple<Lanes>& position, int slices)
{
    const IntTag di;
    const auto size = static_cast<float>(side);
    const auto along = [&](Lanes p, float most, Lanes& part) {
        const Lanes at = clamped(p * Lanes(size) - Lanes(0.5F), 0.0F, most);
        const Lanes low = floored(at);
        part = at - low;
        return hn::ConvertTo(di, low.v);
    };
    GridPosition found;
    const Ints x = along(position.x, size - 1.001F, found.x);
    const Ints y = along(position.y, size - 1.001F, found.y);
    const Ints z = along(position.z, size - static_cast<float>(slices) + 0.999F, found.z);
    found.first = hn::Add(hn::Mul(hn::Add(hn::Mul(z, hn::Set(di, side)), y), hn::Set(di, side)), x);
    return found;
}

/// In a slice of the grid: between the columns around the point, and the least of those.
struct SliceOpacity
{
    Lanes mixed, least;
};
HWY_INLINE SliceOpacity columnsAt(const std::uint32_t* grid, int side, const GridPosition& position, int slice)
{
    const IntTag di;
    const auto* from = reinterpret_cast<const std::int32_t*>(grid) + slice * side * side;
    const auto along = [&](int row) -> SliceOpacity {
        const Ints pair = hn::GatherIndex(di, from + row * side, position.first);
        const Lanes low(hn::ConvertTo(Tag(), hn::And(pair, hn::Set(di, 0xFFFF))));
        const Lanes high(hn::ConvertTo(Tag(), hn::And(hn::ShiftRight<16>(pair), hn::Set(di, 0xFFFF))));
        return {mixed(low, high, position.x), least(low, high)};
    };
    const SliceOpacity low = along(0);
    const SliceOpacity high = along(1);
    const Lanes unit(1.0F / kGridUnits);
    return {mixed(low.mixed, high.mixed, position.y) * unit, least(low.least, high.least) * unit};
}

HWY_INLINE Lanes sliceAt(const std::uint32_t* grid, int side, const GridPosition& position, int slice)
{
    return columnsAt(grid, side, position, slice).mixed;
}

HWY_INLINE Lanes opacityAt(const std::uint32_t* grid, int side, const Triple<Lanes>& position)
{
    const GridPosition at = positionIn(side, position, 2);
    return mixed(sliceAt(grid, side, at, 0), sliceAt(grid, side, at, 1), at.z);
}

/// There and a voxel further.
struct OpacityTwice
{
    Lanes here, further;
    Lanes inEveryColumn; ///< Here: so much in each of the columns around.
};
HWY_INLINE OpacityTwice opacityTwice(const std::uint32_t* grid, int side, const Triple<Lanes>& position)
{
    const GridPosition at = positionIn(side, position, 3);
    const SliceOpacity near = columnsAt(grid, side, at, 0);
    const SliceOpacity middle = columnsAt(grid, side, at, 1);
    return {mixed(near.mixed, middle.mixed, at.z), mixed(middle.mixed, sliceAt(grid, side, at, 2), at.z),
            mixed(near.least, middle.least, at.z)};
}

/// All of the column that the point lies in.
HWY_INLINE Lanes columnAt(const std::uint32_t* grid, int side, const Triple<Lanes>& position)
{
    return sliceAt(grid, side, positionIn(side, {position.x, position.y, Lanes(0.0F)}, 2), side - 1);
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
