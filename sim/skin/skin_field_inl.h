// Reading a grid of distances at as many points as there are lanes.
#if defined(HAIRPAINT_SIM_SKIN_FIELD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_SKIN_FIELD_INL_H_
#undef HAIRPAINT_SIM_SKIN_FIELD_INL_H_
#else
#define HAIRPAINT_SIM_SKIN_FIELD_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/skin/skin_field.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Values of four neighbours: those at the lower x, and the differences to those at the higher x.
struct CellFace
{
    Lanes low, rise;           ///< At the lower y.
    Lanes lowAbove, riseAbove; ///< At the higher y.
};

/// Reads four neighbours by one 32-bit load a lane; the grid is padded at its end, so that a load there stays inside.
HWY_INLINE CellFace cellFace(const DistanceGrid::Pair* HWY_RESTRICT pairs, Ints offset)
{
    static_assert(std::endian::native == std::endian::little && sizeof(DistanceGrid::Pair) == 2);
    const IntTag di;
    const Ints word = hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(pairs), hn::Add(offset, offset));
    const Ints low = hn::ShiftRight<24>(hn::ShiftLeft<24>(word));
    const Ints lowAbove = hn::ShiftRight<24>(hn::ShiftLeft<16>(word));
    const Ints high = hn::ShiftRight<24>(hn::ShiftLeft<8>(word));
    const Ints highAbove = hn::ShiftRight<24>(word);
    return {asFloats(low), asFloats(hn::Sub(high, low)), asFloats(lowAbove), asFloats(hn::Sub(highAbove, lowAbove))};
}

/// What lies between the eight corners of a cell, in units of the values.
struct CellValue
{
    Lanes x00, x10, x01, x11; ///< On the four edges along x, by y and z.
    Lanes low, high;          ///< On the faces of lower and higher z.

    HWY_INLINE CellValue(const CellFace& front, const CellFace& back, const Lanes3& t)
        : x00(front.low + front.rise * t.x), x10(front.lowAbove + front.riseAbove * t.x),
          x01(back.low + back.rise * t.x), x11(back.lowAbove + back.riseAbove * t.x), low(mixed(x00, x10, t.y)),
          high(mixed(x01, x11, t.y))
    {}
    [[nodiscard]] HWY_INLINE Lanes at(const Lanes3& t) const { return mixed(low, high, t.z); }
    /// Of the same faces; units a cell.
    [[nodiscard]] HWY_INLINE Lanes3 slope(const CellFace& front, const CellFace& back, const Lanes3& t) const
    {
        return {mixed(mixed(front.rise, front.riseAbove, t.y), mixed(back.rise, back.riseAbove, t.y), t.z),
                mixed(x10 - x00, x11 - x01, t.z), high - low};
    }
};

/// Signed distance and its direction of steepest rise, as DistanceGrid::Sample.
struct FieldSample
{
    Yes inGrid; ///< False for not a number; all else is right only there.
    Lanes distanceM;
    Lanes3 gradient;
};

/// As DistanceGrid::at(), operation by operation.
HWY_INLINE FieldSample sampleField(const SkinField& skin, const Lanes3& p)
{
    const IntTag di;
    const auto inCells = [&](Lanes along, float origin) { return (along - origin) / skin.cellM; };
    Lanes3 cell{inCells(p.x, skin.origin[0]), inCells(p.y, skin.origin[1]), inCells(p.z, skin.origin[2])};
    Yes inGrid = (cell.x >= 0.0F) & (cell.x < skin.last[0]);
    inGrid = inGrid & ((cell.y >= 0.0F) & (cell.y < skin.last[1]));
    inGrid = inGrid & ((cell.z >= 0.0F) & (cell.z < skin.last[2]));
    cell = select(inGrid, cell, Lanes3{0.0F, 0.0F, 0.0F});
    const Ints x = asInts(cell.x);
    const Ints y = asInts(cell.y);
    const Ints z = asInts(cell.z);
    const Ints first = hn::Add(x, hn::Add(hn::Mul(y, hn::Set(di, skin.row)), hn::Mul(z, hn::Set(di, skin.slice))));
    const CellFace front = cellFace(skin.pairs, first);
    const CellFace back = cellFace(skin.pairs + skin.slice, first);
    const Lanes3 t = cell - Lanes3{asFloats(x), asFloats(y), asFloats(z)};
    const CellValue value(front, back, t);
    return {.inGrid = inGrid,
            .distanceM = value.at(t) * DistanceGrid::kUnitM,
            .gradient = value.slope(front, back, t) * (DistanceGrid::kUnitM / skin.cellM)};
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
