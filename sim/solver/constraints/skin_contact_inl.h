// Contact with the skin: a node nearer than its clearance is moved along the gradient of the skin's distance, which is
// read trilinearly from a grid (DistanceGrid; signed distance fields, Jones, Baerentzen and Sramek 2006).
#if defined(HAIRPAINT_SIM_SKIN_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_SKIN_CONTACT_INL_H_
#undef HAIRPAINT_SIM_SKIN_CONTACT_INL_H_
#else
#define HAIRPAINT_SIM_SKIN_CONTACT_INL_H_
#endif

#include "sim/skin/skin_field_inl.h"
#include "sim/solver/constraints/contact_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Moves p so far from the skin, all in metres: to first order and at most `furthest`. Returns whether any lane was
/// nearer.
HWY_INLINE bool pushOutOfSkin(const SkinField& skin, Lanes clearance, Lanes furthest, Lanes3& p, Contact& contact)
{
    const IntTag di;
    Lanes3 cell = (p - everyLane(skin.origin)) * skin.inverseCell;
    Yes inGrid = (cell.x >= 0.0F) & (cell.x < skin.last[0]); // false for not a number
    inGrid = inGrid & ((cell.y >= 0.0F) & (cell.y < skin.last[1]));
    inGrid = inGrid & ((cell.z >= 0.0F) & (cell.z < skin.last[2]));
    if (!any(inGrid))
        return false;
    cell = select(inGrid, cell, Lanes3{0.0F, 0.0F, 0.0F});
    const Ints x = asInts(cell.x);
    const Ints y = asInts(cell.y);
    const Ints z = asInts(cell.z);
    const Ints first = hn::Add(x, hn::Add(hn::Mul(y, hn::Set(di, skin.row)), hn::Mul(z, hn::Set(di, skin.slice))));
    const CellFace front = cellFace(skin.pairs, first);
    const Lanes toUnits(1.0F / DistanceGrid::kUnitM);
    const Lanes clear = clearance * toUnits;
    const Yes near = inGrid & (front.low < clear + skin.unitsADiagonal);
    if (!any(near))
        return false;

    const CellFace back = cellFace(skin.pairs + skin.slice, first);
    const Lanes3 t = cell - Lanes3{asFloats(x), asFloats(y), asFloats(z)};
    const CellValue value(front, back, t);
    const Lanes depth = clear - value.at(t);
    const Yes inside = inGrid & (depth > 0.0F);
    if (!any(inside))
        return false;
    // Units a cell; where the distance does not change, in the middle of a thin sheet, p stays.
    const Lanes3 g = value.slope(front, back, t) * (1.0F / skin.unitsACell);
    const Lanes g2 = most(dot(g, g), 0.04F);
    const Lanes leave = least(depth, furthest * toUnits);
    const Lanes inverse = Lanes(1.0F) / g2;
    const Lanes stride = leave * DistanceGrid::kUnitM * inverse;
    p = select(inside, p + g * stride, p);
    touch(contact, inside, g, inverse, stride * stride * g2);
    return true;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
