// The contacts with ellipsoids and skin that both solver kernels share; compiled once for each instruction set. As
// vec3_inl.h: the same bytes with each.
#if defined(HAIRPAINT_SIM_STRAND_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_STRAND_KERNEL_INL_H_
#undef HAIRPAINT_SIM_STRAND_KERNEL_INL_H_
#else
#define HAIRPAINT_SIM_STRAND_KERNEL_INL_H_
#endif

#include "sim/base/vec3_inl.h"
#include "sim/solver/solver_layout.h"

#include <bit>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

template<class D>
HWY_INLINE Vec3<hn::Vec<D>> rotated(D d, const std::array<std::array<float, 3>, 3>& rows, const Vec3<hn::Vec<D>>& p)
{
    return {dot(set3(d, rows[0]), p), dot(set3(d, rows[1]), p), dot(set3(d, rows[2]), p)};
}

template<class D>
HWY_INLINE Vec3<hn::Vec<D>> moved(D d, const RigidMotion& motion, const Vec3<hn::Vec<D>>& p)
{
    return add(rotated(d, motion.rows, p), set3(d, motion.offset));
}

/// Where a node touched an ellipsoid: outward normal (not unit), its squared length, and the squared depth it had.
template<class D>
struct Contact
{
    Vec3<hn::Vec<D>> normal;
    hn::Vec<D> normal2;
    hn::Vec<D> depth2;
    hn::Mask<D> touched;
};

template<class D>
HWY_INLINE Contact<D> noContact(D d)
{
    const auto zero = hn::Zero(d);
    return {{zero, zero, zero}, hn::Set(d, 1.0F), zero, hn::MaskFromVec(zero)};
}

/// Moves p out of the ellipsoid, scaled so that its squared radius is `scale2`, to first order along the surface's
/// normal and at most `furthest` metres. Returns whether any lane was inside.
template<class D>
HWY_INLINE bool pushOut(D d, const Collider& collider, hn::Vec<D> scale2, hn::Vec<D> furthest, Vec3<hn::Vec<D>>& p,
                        Contact<D>& contact)
{
    const auto q = rotated(d, collider.rows, sub(p, set3(d, collider.centre)));
    const auto r2 = dot(q, q);
    const auto inside = hn::Lt(r2, scale2);
    if (hn::AllFalse(d, inside))
        return false;
    const auto r = hn::Sqrt(hn::Max(r2, hn::Set(d, 1e-8F)));
    // Half the gradient of |q|^2; |gradient| / r is the change of r over a metre.
    auto g = scale(set3(d, {collider.rows[0][0], collider.rows[0][1], collider.rows[0][2]}), q.x);
    g = addScaled(g, set3(d, collider.rows[1]), q.y);
    g = addScaled(g, set3(d, collider.rows[2]), q.z);
    const auto g2 = hn::Max(dot(g, g), hn::Set(d, 1e-8F));
    auto stride = hn::Div(hn::Mul(hn::Sub(hn::Sqrt(scale2), r), r), g2);
    auto depth2 = hn::Mul(hn::Mul(stride, stride), g2);
    const auto far = hn::And(inside, hn::Gt(depth2, hn::Mul(furthest, furthest)));
    if (HWY_UNLIKELY(!hn::AllFalse(d, far))) {
        stride = hn::IfThenElse(far, hn::Div(furthest, hn::Sqrt(g2)), stride);
        depth2 = hn::IfThenElse(far, hn::Mul(furthest, furthest), depth2);
    }
    p = choose(inside, addScaled(p, g, stride), p);
    contact.normal = choose(inside, g, contact.normal);
    contact.normal2 = hn::IfThenElse(inside, g2, contact.normal2);
    contact.depth2 = hn::IfThenElse(inside, depth2, contact.depth2);
    contact.touched = hn::Or(contact.touched, inside);
    return true;
}

/// What two neighbours along x hold: the one at the lower x, and how much more the other one does.
template<class D>
struct CellRow
{
    hn::Vec<D> low, rise;
};

/// Both in one word: a grid has room for it at its end.
template<class D>
HWY_INLINE CellRow<D> cellRow(D d, const std::int8_t* HWY_RESTRICT values, hn::VFromD<hn::RebindToSigned<D>> offset)
{
    static_assert(std::endian::native == std::endian::little);
    const hn::RebindToSigned<D> di;
    const auto word = hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(values), offset);
    const auto low = hn::ShiftRight<24>(hn::ShiftLeft<24>(word));
    const auto high = hn::ShiftRight<24>(hn::ShiftLeft<16>(word));
    return {hn::ConvertTo(d, low), hn::ConvertTo(d, hn::Sub(high, low))};
}

/// Moves p so far from the skin, all in metres: to first order along the gradient of its distance and at most
/// `furthest`. Returns whether any lane was nearer.
template<class D>
HWY_INLINE bool pushOutOfSkin(D d, const SkinField& skin, hn::Vec<D> clearance, hn::Vec<D> furthest,
                              Vec3<hn::Vec<D>>& p, Contact<D>& contact)
{
    using V = hn::Vec<D>;
    const hn::RebindToSigned<D> di;
    const V zero = hn::Zero(d);
    Vec3<V> cell = scale(sub(p, set3(d, skin.origin)), hn::Set(d, skin.inverseCell));
    auto inGrid = hn::And(hn::Ge(cell.x, zero), hn::Lt(cell.x, hn::Set(d, skin.last[0]))); // false for not a number
    inGrid = hn::And(inGrid, hn::And(hn::Ge(cell.y, zero), hn::Lt(cell.y, hn::Set(d, skin.last[1]))));
    inGrid = hn::And(inGrid, hn::And(hn::Ge(cell.z, zero), hn::Lt(cell.z, hn::Set(d, skin.last[2]))));
    if (hn::AllFalse(d, inGrid))
        return false;
    cell = choose(inGrid, cell, Vec3<V>{zero, zero, zero});
    const auto x = hn::ConvertTo(di, cell.x);
    const auto y = hn::ConvertTo(di, cell.y);
    const auto z = hn::ConvertTo(di, cell.z);
    const auto first = hn::Add(x, hn::Add(hn::Mul(y, hn::Set(di, skin.row)), hn::Mul(z, hn::Set(di, skin.slice))));
    const CellRow<D> row00 = cellRow(d, skin.values, first);
    const V toUnits = hn::Set(d, 1.0F / DistanceGrid::kUnitM);
    const V clear = hn::Mul(clearance, toUnits);
    const auto near = hn::And(inGrid, hn::Lt(row00.low, hn::Add(clear, hn::Set(d, skin.unitsADiagonal))));
    if (hn::AllFalse(d, near))
        return false;

    const CellRow<D> row10 = cellRow(d, skin.values + skin.row, first);
    const CellRow<D> row01 = cellRow(d, skin.values + skin.slice, first);
    const CellRow<D> row11 = cellRow(d, skin.values + skin.slice + skin.row, first);
    const Vec3<V> t = sub(cell, {hn::ConvertTo(d, x), hn::ConvertTo(d, y), hn::ConvertTo(d, z)});
    const auto alongX = [&t](const CellRow<D>& row) { return hn::Add(row.low, hn::Mul(row.rise, t.x)); };
    const auto mix = [](V a, V b, V s) { return hn::Add(a, hn::Mul(hn::Sub(b, a), s)); };
    const V x00 = alongX(row00);
    const V x10 = alongX(row10);
    const V x01 = alongX(row01);
    const V x11 = alongX(row11);
    const V low = mix(x00, x10, t.y);
    const V high = mix(x01, x11, t.y);
    const V depth = hn::Sub(clear, mix(low, high, t.z));
    const auto inside = hn::And(inGrid, hn::Gt(depth, zero));
    if (hn::AllFalse(d, inside))
        return false;
    // Units a cell; where the distance does not change, in the middle of a thin sheet, p stays.
    const Vec3<V> slope{mix(mix(row00.rise, row10.rise, t.y), mix(row01.rise, row11.rise, t.y), t.z),
                        mix(hn::Sub(x10, x00), hn::Sub(x11, x01), t.z), hn::Sub(high, low)};
    const Vec3<V> g = scale(slope, hn::Set(d, 1.0F / skin.unitsACell));
    const V g2 = hn::Max(dot(g, g), hn::Set(d, 0.04F));
    const V leave = hn::Min(depth, hn::Mul(furthest, toUnits));
    const V stride = hn::Div(hn::Mul(leave, hn::Set(d, DistanceGrid::kUnitM)), g2);
    p = choose(inside, addScaled(p, g, stride), p);
    contact.normal = choose(inside, g, contact.normal);
    contact.normal2 = hn::IfThenElse(inside, g2, contact.normal2);
    contact.depth2 = hn::IfThenElse(inside, hn::Mul(hn::Mul(stride, stride), g2), contact.depth2);
    contact.touched = hn::Or(contact.touched, inside);
    return true;
}

/// The same for the places of the segment from p's parent, which p moves by moving further; `first`: of the strand.
template<class D>
HWY_INLINE bool pushSegmentOutOfSkin(D d, const SkinField& skin, hn::Vec<D> clearance, hn::Vec<D> furthest, bool first,
                                     const Vec3<hn::Vec<D>>& parent, Vec3<hn::Vec<D>>& p, Contact<D>& contact)
{
    bool any = pushOutOfSkin(d, skin, clearance, furthest, p, contact);
    for (std::size_t i = 1; i < kSegmentParts.size() && !first; ++i) {
        const Vec3<hn::Vec<D>> place = addScaled(parent, sub(p, parent), hn::Set(d, kSegmentParts[i]));
        Vec3<hn::Vec<D>> out = place;
        if (!pushOutOfSkin(d, skin, clearance, furthest, out, contact))
            continue;
        p = addScaled(p, sub(out, place), hn::Set(d, 1.0F / kSegmentParts[i]));
        any = true;
    }
    return any;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
