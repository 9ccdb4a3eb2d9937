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

/// Where a node touched an ellipsoid or the skin: outward normal (not unit), the inverse of its squared length, and the
/// squared depth it had.
template<class D>
struct Contact
{
    Vec3<hn::Vec<D>> normal;
    hn::Vec<D> inverseNormal2;
    hn::Vec<D> depth2;
    hn::Mask<D> touched;
    hn::Mask<D> latest; ///< The lanes of the latest touch; valid once there was one.
};

template<class D>
HWY_INLINE Contact<D> noContact(D d)
{
    const auto zero = hn::Zero(d);
    return {{zero, zero, zero}, hn::Set(d, 1.0F), zero, hn::MaskFromVec(zero), hn::MaskFromVec(zero)};
}

template<class D>
HWY_INLINE void touch(Contact<D>& contact, hn::Mask<D> where, const Vec3<hn::Vec<D>>& normal, hn::Vec<D> inverseNormal2,
                      hn::Vec<D> depth2)
{
    contact.normal = choose(where, normal, contact.normal);
    contact.inverseNormal2 = hn::IfThenElse(where, inverseNormal2, contact.inverseNormal2);
    contact.depth2 = hn::IfThenElse(where, depth2, contact.depth2);
    contact.touched = hn::Or(contact.touched, where);
    contact.latest = where;
}

/// Moves p out of the ellipsoid, scaled so that its squared radius is `scale2`, to first order along the surface's
/// normal and at most `furthest` metres. Returns whether any lane was inside.
template<class D>
HWY_INLINE bool pushOut(D d, const Collider& collider, hn::Vec<D> scale2, hn::Vec<D> furthest, Vec3<hn::Vec<D>>& p,
                        Contact<D>& contact)
{
    using V = hn::Vec<D>;
    const auto& squares = collider.squares;
    const auto& mixed = collider.mixed;
    const Vec3<V> q = sub(p, set3(d, collider.centre));
    const Vec3<V> square{hn::Mul(q.x, hn::Set(d, squares[0])), hn::Mul(q.y, hn::Set(d, squares[1])),
                         hn::Mul(q.z, hn::Set(d, squares[2]))};
    const V zero = hn::Zero(d);
    Vec3<V> across{zero, zero, zero}; // What comes of the products of two axes.
    V r2 = dot(q, square);
    if (!collider.aligned()) {
        const V zAcrossY = hn::Mul(q.z, hn::Set(d, mixed[2]));
        across = {hn::Add(hn::Mul(q.y, hn::Set(d, mixed[0])), hn::Mul(q.z, hn::Set(d, mixed[1]))),
                  hn::Add(hn::Mul(q.x, hn::Set(d, mixed[0])), zAcrossY),
                  hn::Add(hn::Mul(q.x, hn::Set(d, mixed[1])), hn::Mul(q.y, hn::Set(d, mixed[2])))};
        r2 = dot(q, {hn::Add(square.x, across.x), hn::Add(square.y, zAcrossY), square.z});
    }
    const auto inside = hn::Lt(r2, scale2);
    if (hn::AllFalse(d, inside))
        return false;
    // Half the gradient of r2.
    const Vec3<V> g = addScaled(square, across, hn::Set(d, 0.5F));
    const auto g2 = hn::Max(dot(g, g), hn::Set(d, 1e-8F));
    const auto inverse = hn::Div(hn::Set(d, 1.0F), g2);
    // The change of the radius r over a metre is |g|/r, and (scale - r) r is sqrt(scale2 r2) - r2.
    const V square2 = hn::Max(r2, hn::Set(d, 1e-8F));
    auto stride = hn::Mul(hn::Sub(hn::Sqrt(hn::Mul(scale2, square2)), square2), inverse);
    auto depth2 = hn::Mul(hn::Mul(stride, stride), g2);
    const auto far = hn::And(inside, hn::Gt(depth2, hn::Mul(furthest, furthest)));
    if (HWY_UNLIKELY(!hn::AllFalse(d, far))) {
        stride = hn::IfThenElse(far, hn::Mul(furthest, hn::Sqrt(inverse)), stride);
        depth2 = hn::IfThenElse(far, hn::Mul(furthest, furthest), depth2);
    }
    p = choose(inside, addScaled(p, g, stride), p);
    touch(contact, inside, g, inverse, depth2);
    return true;
}

/// What four neighbours hold: those at the lower x, and by how much more the others do.
template<class D>
struct CellFace
{
    hn::Vec<D> low, rise;           ///< At the lower y,
    hn::Vec<D> lowAbove, riseAbove; ///< at the higher.
};

/// Of one word: a grid has room for it at its end.
template<class D>
HWY_INLINE CellFace<D> cellFace(D d, const DistanceGrid::Pair* HWY_RESTRICT pairs,
                                hn::VFromD<hn::RebindToSigned<D>> offset)
{
    static_assert(std::endian::native == std::endian::little && sizeof(DistanceGrid::Pair) == 2);
    const hn::RebindToSigned<D> di;
    const auto word = hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(pairs), hn::Add(offset, offset));
    const auto low = hn::ShiftRight<24>(hn::ShiftLeft<24>(word));
    const auto lowAbove = hn::ShiftRight<24>(hn::ShiftLeft<16>(word));
    const auto high = hn::ShiftRight<24>(hn::ShiftLeft<8>(word));
    const auto highAbove = hn::ShiftRight<24>(word);
    return {hn::ConvertTo(d, low), hn::ConvertTo(d, hn::Sub(high, low)), hn::ConvertTo(d, lowAbove),
            hn::ConvertTo(d, hn::Sub(highAbove, lowAbove))};
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
    const CellFace<D> front = cellFace(d, skin.pairs, first);
    const V toUnits = hn::Set(d, 1.0F / DistanceGrid::kUnitM);
    const V clear = hn::Mul(clearance, toUnits);
    const auto near = hn::And(inGrid, hn::Lt(front.low, hn::Add(clear, hn::Set(d, skin.unitsADiagonal))));
    if (hn::AllFalse(d, near))
        return false;

    const CellFace<D> back = cellFace(d, skin.pairs + skin.slice, first);
    const Vec3<V> t = sub(cell, {hn::ConvertTo(d, x), hn::ConvertTo(d, y), hn::ConvertTo(d, z)});
    const auto mix = [](V a, V b, V s) { return hn::Add(a, hn::Mul(hn::Sub(b, a), s)); };
    const V x00 = hn::Add(front.low, hn::Mul(front.rise, t.x));
    const V x10 = hn::Add(front.lowAbove, hn::Mul(front.riseAbove, t.x));
    const V x01 = hn::Add(back.low, hn::Mul(back.rise, t.x));
    const V x11 = hn::Add(back.lowAbove, hn::Mul(back.riseAbove, t.x));
    const V low = mix(x00, x10, t.y);
    const V high = mix(x01, x11, t.y);
    const V depth = hn::Sub(clear, mix(low, high, t.z));
    const auto inside = hn::And(inGrid, hn::Gt(depth, zero));
    if (hn::AllFalse(d, inside))
        return false;
    // Units a cell; where the distance does not change, in the middle of a thin sheet, p stays.
    const Vec3<V> slope{mix(mix(front.rise, front.riseAbove, t.y), mix(back.rise, back.riseAbove, t.y), t.z),
                        mix(hn::Sub(x10, x00), hn::Sub(x11, x01), t.z), hn::Sub(high, low)};
    const Vec3<V> g = scale(slope, hn::Set(d, 1.0F / skin.unitsACell));
    const V g2 = hn::Max(dot(g, g), hn::Set(d, 0.04F));
    const V leave = hn::Min(depth, hn::Mul(furthest, toUnits));
    const V inverse = hn::Div(hn::Set(d, 1.0F), g2);
    const V stride = hn::Mul(hn::Mul(leave, hn::Set(d, DistanceGrid::kUnitM)), inverse);
    p = choose(inside, addScaled(p, g, stride), p);
    touch(contact, inside, g, inverse, hn::Mul(hn::Mul(stride, stride), g2));
    return true;
}

template<class V>
struct Turn
{
    Vec3<V> v;
    V w;
};

template<class V>
HWY_INLINE Vec3<V> cross(const Vec3<V>& a, const Vec3<V>& b)
{
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

template<class V>
HWY_INLINE Vec3<V> turnedBy(const Turn<V>& q, const Vec3<V>& p)
{
    const Vec3<V> half = cross(q.v, addScaled(cross(q.v, p), p, q.w));
    return add(p, add(half, half));
}

/// The whole turn from the head's frame to the shoulders'.
template<class D>
HWY_INLINE Turn<hn::Vec<D>> wholeTurn(D d, const NeckTurn& neck)
{
    return {{hn::Set(d, neck.turn[0]), hn::Set(d, neck.turn[1]), hn::Set(d, neck.turn[2])}, hn::Set(d, neck.turn[3])};
}

/// As much of it as skin at height y takes part in.
template<class D>
HWY_INLINE Turn<hn::Vec<D>> turnAt(D d, const NeckTurn& neck, hn::Vec<D> y)
{
    using V = hn::Vec<D>;
    const V one = hn::Set(d, 1.0F);
    const V t =
        hn::Min(hn::Max(hn::Mul(hn::Sub(hn::Set(d, neck.headY), y), hn::Set(d, neck.perTwistM)), hn::Zero(d)), one);
    const V s = hn::Mul(hn::Mul(t, t), hn::Sub(hn::Set(d, 3.0F), hn::Add(t, t)));
    const Turn<V> whole = wholeTurn(d, neck);
    const Vec3<V> v = scale(whole.v, s);
    const V w = hn::Add(hn::Sub(one, s), hn::Mul(s, whole.w));
    const V perLength = hn::Div(one, hn::Sqrt(hn::Add(dot(v, v), hn::Mul(w, w))));
    return {scale(v, perLength), hn::Mul(w, perLength)};
}

/// `push`, which takes p and a contact as the skin knows them, for skin that is turned by `turn` about the neck.
template<class D, class Push>
HWY_INLINE bool pushTurned(D d, const NeckTurn& neck, const Turn<hn::Vec<D>>& turn, Vec3<hn::Vec<D>>& p,
                           Contact<D>& contact, const Push& push)
{
    using V = hn::Vec<D>;
    const Vec3<V> pivot = set3(d, neck.pivot);
    const Vec3<V> place = add(turnedBy(turn, sub(p, pivot)), pivot);
    Vec3<V> out = place;
    Contact<D> own = noContact(d);
    if (!push(out, own))
        return false;
    const V zero = hn::Zero(d);
    const Turn<V> back{sub(Vec3<V>{zero, zero, zero}, turn.v), turn.w};
    p = choose(own.touched, add(p, turnedBy(back, sub(out, place))), p);
    touch(contact, own.touched, turnedBy(back, own.normal), own.inverseNormal2, own.depth2);
    return true;
}

/// pushOut() for an ellipsoid of the head or, below the neck, of the shoulders.
template<class D>
HWY_INLINE bool pushOut(D d, const Collider& collider, const NeckTurn& neck, hn::Vec<D> scale2, hn::Vec<D> furthest,
                        Vec3<hn::Vec<D>>& p, Contact<D>& contact)
{
    if (HWY_LIKELY(!neck.turned) || collider.centre[1] > neck.shouldersY)
        return pushOut(d, collider, scale2, furthest, p, contact);
    return pushTurned(d, neck, wholeTurn(d, neck), p, contact, [&](Vec3<hn::Vec<D>>& place, Contact<D>& own) {
        return pushOut(d, collider, scale2, furthest, place, own);
    });
}

/// pushOutOfSkin() for a bust whose shoulders do not turn with the head.
template<class D>
HWY_INLINE bool pushOutOfBust(D d, const SkinField& skin, const NeckTurn& neck, hn::Vec<D> clearance,
                              hn::Vec<D> furthest, Vec3<hn::Vec<D>>& p, Contact<D>& contact)
{
    using V = hn::Vec<D>;
    if (HWY_LIKELY(!neck.turned))
        return pushOutOfSkin(d, skin, clearance, furthest, p, contact);
    // By how much the skin there is turned depends on its own height: found from the shoulders', then again.
    const V pivotY = hn::Set(d, neck.pivot[1]);
    const Vec3<V> fromPivot = sub(p, set3(d, neck.pivot));
    const V whole = hn::Add(turnedBy(wholeTurn(d, neck), fromPivot).y, pivotY);
    const V once = hn::Add(turnedBy(turnAt(d, neck, whole), fromPivot).y, pivotY);
    return pushTurned(d, neck, turnAt(d, neck, once), p, contact, [&](Vec3<V>& place, Contact<D>& own) {
        return pushOutOfSkin(d, skin, clearance, furthest, place, own);
    });
}

/// The same for the places of the segment from p's parent, which p moves by moving further; `first`: of the strand.
template<class D>
HWY_INLINE bool pushSegmentOutOfSkin(D d, const SkinField& skin, const NeckTurn& neck, hn::Vec<D> clearance,
                                     hn::Vec<D> furthest, bool first, const Vec3<hn::Vec<D>>& parent,
                                     Vec3<hn::Vec<D>>& p, Contact<D>& contact)
{
    using V = hn::Vec<D>;
    bool any = pushOutOfBust(d, skin, neck, clearance, furthest, p, contact);
    hn::Mask<D> touched = any ? contact.latest : hn::MaskFromVec(hn::Zero(d));
    for (std::size_t i = 1; i < kSegmentParts.size() && !first; ++i) {
        const Vec3<V> edge = sub(p, parent);
        const Vec3<V> place = addScaled(parent, edge, hn::Set(d, kSegmentParts[i]));
        Vec3<V> out = place;
        if (!pushOutOfBust(d, skin, neck, clearance, furthest, out, contact))
            continue;
        p = addScaled(p, sub(out, place), hn::Set(d, 1.0F / kSegmentParts[i]));
        touched = hn::Or(touched, contact.latest);
        any = true;
    }
    contact.latest = touched;
    return any;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
