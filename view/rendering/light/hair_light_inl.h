// Light on a point of a hair, as hair_light.glsl has it: scattered once by the hair itself, many times by the coat, and
// attenuated by the hair and the head in front of it.
#if defined(HAIRPAINT_RENDERING_HAIR_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_HAIR_LIGHT_INL_H_
#undef HAIRPAINT_RENDERING_HAIR_LIGHT_INL_H_
#else
#define HAIRPAINT_RENDERING_HAIR_LIGHT_INL_H_
#endif

#include "view/rendering/light/dual_scattering_inl.h"
#include "view/rendering/light/environment_inl.h"
#include "view/rendering/light/hair_light.h"
#include "view/rendering/light/illuminated_line_inl.h"
#include "view/rendering/light/kajiya_kay_inl.h"
#include "view/rendering/light/marschner_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// A point of a hair, Wo, m.
template<class F>
struct HairPoint
{
    Triple<F> position;
    Triple<F> tangent; ///< Unit, toward the tip.
    Triple<F> colour;  ///< Colour of a coat of such hair; linear, with the hair's own lightness in it.
    Triple<F> depth;   ///< fibreDepth() of `colour`.
    F turned;          ///< turnedBy() of this hair.
    F towardKey;       ///< Area of hair between it and the light, the eye, the rim light, over the area that it covers.
    F towardEye;
    F towardRim;
    F shine = F(1.0F);     ///< This hair's factor on the group's shine.
    F sharpness = F(1.0F); ///< Sharpness of its highlights over the group's.
};

/// By how much a fibre's lobes stand elsewhere than those of its neighbours, as twice the half angle's sine: fibres of
/// a lock lie a few degrees askew, so that a coat glints where it would otherwise be one sheet. `variation` -1..1 is
/// the hair's own; of another lightness they turn otherwise.
template<class F>
HWY_INLINE F turnedBy(F variation)
{
    constexpr float kMost = 0.12F;
    const F pair = variation * F(2.0F);
    return (pair - floored(pair + F(0.5F))) * F(2.0F * kMost);
}

/// White of a highlight that hairs of a coat show: one hair mirrors all of a light that grazes it, but it seldom lies
/// free. `cosPhi` 1 where the eye is beside the light, -1 where they face each other.
template<class F>
HWY_INLINE F drawnGloss(F white, F cosPhi)
{
    constexpr float kBound = 6.0F; ///< Where light and eye are at right angles the white stays below 1 / kBound.
    return white / (F(1.0F) + white * (F(1.0F) - cosPhi) * F(kBound));
}

/// Fraction of a far light that passes the head: an umbra of its size with a soft edge.
template<class F>
HWY_INLINE F besideHead(const Triple<F>& fromHead, float radiusM, const Triple<F>& toward)
{
    const F along = dot(fromHead, toward);
    const F off = root(most(dot(fromHead, fromHead) - along * along, F(0.0F)));
    const float r = radiusM > 1e-4F ? radiusM : 1e-4F;
    const F inside = F(1.0F) - smoothStep(0.5F * r, 1.3F * r, off);
    return F(1.0F) - inside * smoothStep(0.0F, 0.8F * r, along * F(-1.0F));
}

/// How the point lies in its coat.
template<class F>
struct CoatPoint
{
    Triple<F> view;     ///< Toward the eye.
    Triple<F> fromHead; ///< From the head's middle, m.
    Triple<F> normal;   ///< Normal of the coat, unit: halfway from the head's to the one across the hair.
    F sinO, cosO;
    F open; ///< 0..1: nothing of the head stands right behind it, so that light goes on through it to the eye.
};

/// Evens out what the coat keeps in its own shade: seen from all around in studio light it then shows the colour that
/// was painted (test_painted_colour).
inline constexpr float kCoat = 1.1F;

/// Light of one lamp: `passed` is the fraction that the hair in front transmits.
template<LobeSet set, class F>
HWY_INLINE Triple<F> lightOf(const HairLighting& given, const FarLight& lamp, const HairPoint<F>& point,
                             const CoatPoint<F>& coat, const Passed<F>& passed)
{
    constexpr float kPi = 3.14159265F;
    const Triple<F> toward = tripleOf<F>(lamp.towardWo);
    const FibreAngles<F> at = fibreAngles(dot(point.tangent, toward), coat.sinO, coat.cosO, dot(toward, coat.view));
    constexpr float kForward = 0.5F; ///< Fraction of the light past one hair that meets no other right after.
    const F shine = F(given.shine) * point.shine;
    // Softly around the coat, since light scatters on within it; what shines through its thin parts is there too.
    const F wrap = clamped(dot(coat.normal, toward) * F(0.62F) + F(0.38F), 0.0F, 1.0F);
    const F facing = F(0.1F) + F(0.9F) * wrap * wrap;
    Triple<F> lit;
    if (given.scattering == ScatteringModel::Marschner) {
        const FibreLobes<F> lobes = marschner<set>(given.shape, at, point.depth, point.turned, point.sharpness);
        const F front = shine * passed.direct * F(kPi);
        const F body = (F(0.35F) + F(0.65F) * at.cosI) * facing * F(kCoat);
        // Where the coat turns from the light, hairs lie under those that have it.
        const F shown = F(0.3F) + F(0.7F) * wrap;
        const F white = drawnGloss(lobes.r * front * shown * F(set == LobeSet::Forward ? kForward : 1.0F), at.cosPhi);
        lit = point.colour * passed.all * body + Triple<F>{white, white, white};
        // What went through one hair goes through those beside it too: even a thin coat colours it.
        if constexpr (set != LobeSet::Back)
            lit = lit + lobes.tt * lobes.through * lobes.through * lobes.through * passed.all *
                            (coat.open * F(kPi * kForward));
        if constexpr (set != LobeSet::Forward)
            lit = lit + lobes.trt * front;
    } else if (given.scattering == ScatteringModel::KajiyaKay) {
        const Highlights<F> highlights = kajiyaKay(at, F(given.highlightExponent) * point.sharpness * point.sharpness);
        const F gloss = shine * passed.direct * wrap;
        const F white = highlights.first * gloss * F(0.15F);
        lit = point.colour * passed.all * (at.cosI * facing * F(kCoat)) + Triple<F>{white, white, white} +
              point.colour * (highlights.second * gloss * F(0.5F));
    } else {
        const LineLight<F> line = illuminatedLine(at, F(given.highlightExponent) * point.sharpness * point.sharpness);
        const F white = line.specular * shine * passed.direct * F(0.25F);
        lit = point.colour * passed.all * (line.diffuse * facing * F(kCoat)) + Triple<F>{white, white, white};
    }
    return lit * tripleOf<F>(lamp.colour);
}

template<class F>
HWY_INLINE Triple<F> hairLight(const HairLighting& given, const HairPoint<F>& point)
{
    const F one(1.0F);
    CoatPoint<F> coat;
    coat.view = unit(tripleOf<F>(given.eyeWo) - point.position);
    coat.fromHead = point.position - tripleOf<F>(given.headWo);
    const Triple<F> outward = coat.fromHead * (one / root(dot(coat.fromHead, coat.fromHead) + F(1e-8F)));
    // Halfway from the head's own form to the hair's.
    coat.normal = unit(outward * F(1.3F) - point.tangent * dot(outward, point.tangent));
    coat.sinO = dot(point.tangent, coat.view);
    coat.cosO = cosineOf(coat.sinO);
    coat.open = besideHead(coat.fromHead, given.headRadiusM, coat.view * F(-1.0F));

    const Passed<F> fromKey = passedThrough(point.towardKey, point.depth);
    const Passed<F> fromEye = passedThrough(point.towardEye, point.depth);
    const Passed<F> fromRim = passedThrough(point.towardRim, point.depth);
    const F keyLeft = besideHead(coat.fromHead, given.headRadiusM, tripleOf<F>(given.key.towardWo));
    const F rimLeft = besideHead(coat.fromHead, given.headRadiusM, tripleOf<F>(given.rim.towardWo));
    // Surroundings come from the side where the coat is open, which is about where the eye looks in.
    const Triple<F> around = irradianceAt(given.around, coat.normal) * point.colour * fromEye.all * F(kCoat);
    Triple<F> lit = around + lightOf<LobeSet::Back>(given, given.fill, point, coat, fromEye);
    if (any(keyLeft > F(0.0F)))
        lit = lit + lightOf<LobeSet::All>(given, given.key, point, coat, fromKey) * keyLeft;
    if (any(rimLeft > F(0.0F)))
        lit = lit + lightOf<LobeSet::Forward>(given, given.rim, point, coat, fromRim) * rimLeft;
    return lit;
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
