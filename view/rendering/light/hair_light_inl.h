// Light on a point of a hair, as strand_shade.comp has it: Kajiya and Kay 1989 with two highlights shifted along the
// hair (Marschner et al. 2003), light falling through the coat by the opacity grids.
#if defined(HAIRPAINT_RENDERING_HAIR_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_HAIR_LIGHT_INL_H_
#undef HAIRPAINT_RENDERING_HAIR_LIGHT_INL_H_
#else
#define HAIRPAINT_RENDERING_HAIR_LIGHT_INL_H_
#endif

#include "view/rendering/light/hair_light.h"
#include "view/rendering/light/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// A point of a hair, Wo, m.
template<class F>
struct HairPoint
{
    Triple<F> place;
    Triple<F> tangent; ///< Unit.
    Triple<F> colour;  ///< Linear, its own lightness in it already.
    F variation;       ///< -1..1 times the group's.
    F towardLight;     ///< Area of hair between it and the light, the eye, over the area that it covers.
    F towardEye;
};

template<class F>
HWY_INLINE Triple<F> hairLight(const HairLighting& given, const HairPoint<F>& point)
{
    const F one(1.0F);
    const F zero(0.0F);
    const F direct = exp2Of(F(-0.40F) * point.towardLight);
    const F around = exp2Of(F(-0.30F) * point.towardEye);
    const Triple<F> view = unit(tripleOf<F>(given.eyeWo) - point.place);
    const Triple<F> light = tripleOf<F>(given.lightWo);
    Triple<F> outward = point.place - tripleOf<F>(given.headWo);
    outward = outward * (one / root(dot(outward, outward) + F(1e-8F)));
    const F facing = dot(outward, light);
    const F hemisphere = F(0.55F) + F(0.35F) * outward.y;

    const F tl = dot(point.tangent, light);
    const F tv = dot(point.tangent, view);
    const F sl = root(most(one - tl * tl, zero));
    // Only the part of the coat that faces the light; softly, since light scatters round.
    const F wrap = clamped(facing * F(0.62F) + F(0.38F), 0.0F, 1.0F);
    const F diffuse = (F(0.35F) + F(0.65F) * sl) * wrap * wrap;
    // A dim fill from the eye shows the hair's form where the light does not reach.
    const F toEye = clamped(dot(outward, view) * F(0.7F) + F(0.3F), 0.0F, 1.0F);
    const F fill = F(0.75F) * toEye * toEye * root(most(one - tv * tv, zero));

    // Two highlights: one in the light's colour moved toward the root, a wider one in the hair's toward the tip.
    const float width = 0.012F + 0.35F * given.roughness * given.roughness;
    const F sum = tl + tv;
    const F a = sum - F(0.07F) + F(0.05F) * point.variation;
    const F b = sum + F(0.16F) + F(0.25F) * point.variation;
    const F first = exp2Of(a * a * F(-1.0F / width));
    const F second = exp2Of(b * b * F(-1.0F / (width * 3.0F)));
    const F lobe = F(given.shine) * wrap * sl * direct;

    // Light bounces from hair to hair: fair hair brightens more than dark.
    const F direct23 = diffuse * F(2.3F) * direct;
    const F ambient = F(given.ambient * 1.7F) * (hemisphere + fill) * around;
    const auto channel = [&](F hair, float lightColour) {
        const F body = hair * (direct23 * F(lightColour) + ambient);
        return body + lobe * F(lightColour) * (first * F(0.20F) + second * F(1.1F) * root(hair) * hair);
    };
    Triple<F> lit{channel(point.colour.x, given.lightColour.x), channel(point.colour.y, given.lightColour.y),
                  channel(point.colour.z, given.lightColour.z)};
    return lit * (one / (one + F(0.35F) * most(lit.x, most(lit.y, lit.z))));
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
