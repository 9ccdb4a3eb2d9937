// Light scattered once by a fibre: Marschner and others 2003 with lobes that keep their energy.
// Longitudinally a Gaussian of the half angle, azimuthally the exact reflection (R) and powers of cosines for what goes
// through (TT) and what comes back from the far side (TRT). Each is unchanged when light and eye are exchanged. Summed
// over all directions the lobes give 1 without absorption, less the 1/200 that is reflected inside more than once.
#if defined(HAIRPAINT_RENDERING_MARSCHNER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_MARSCHNER_INL_H_
#undef HAIRPAINT_RENDERING_MARSCHNER_INL_H_
#else
#define HAIRPAINT_RENDERING_MARSCHNER_INL_H_
#endif

#include "view/rendering/light/fibre_inl.h"
#include "view/rendering/light/fibre_shape.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

inline constexpr float kLeastExponent = 20.0F;          ///< Keeps products away from denormal numbers, which are slow.
inline constexpr float kNormalReflectance = 0.0465206F; ///< For a refractive index of 1.55.

/// Radiance for an irradiance of 1 across the beam, 1/sr.
template<class F>
struct FibreLobes
{
    F r;
    Triple<F> tt, trt;
    Triple<F> through; ///< What pigment leaves of light that crosses the fibre.
};

/// Schlick 1994.
template<class F>
HWY_INLINE F reflectance(F cosine)
{
    const F a = F(1.0F) - cosine;
    const F square = a * a;
    return F(kNormalReflectance) + F(1.0F - kNormalReflectance) * (square * square * a);
}

/// Mean of reflectance(cosD cos g) over the fibre's width; g is the angle on its cross-section.
template<class F>
HWY_INLINE F meanReflectance(F c)
{
    const F integral =
        F(1.0F) + c * (F(-3.92699082F) +
                       c * (F(6.66666667F) + c * (F(-5.89048623F) + c * (F(2.66666667F) - c * F(0.49087385F)))));
    return F(kNormalReflectance) + F(1.0F - kNormalReflectance) * integral;
}

/// Longitudinal part of lobe `which`: a Gaussian of twice the half angle's sine, so many times as narrow and, by
/// `perCosD`, as high.
template<class F>
HWY_INLINE F longitudinal(const FibreShape& shape, int which, F twiceSinH, F perCosD, F sharpness)
{
    const F off = (twiceSinH - F(shape.shift[which])) * sharpness;
    const F exponent = most(off * off * F(shape.exponent[which]), F(-kLeastExponent));
    return exp2Of(exponent) * F(shape.peak[which]) * perCosD;
}

/// Which lobes a light needs: one in front shows no TT, one behind no TRT.
enum class LobeSet
{
    All,
    Back,
    Forward
};

/// `depth`: optical depth of the fibre, crossed at right angles. `jitter` shifts the lobes of this one hair, which are
/// `sharpness` times as narrow as the shape's and as much higher.
template<LobeSet set, class F>
HWY_INLINE FibreLobes<F> marschner(const FibreShape& shape, const FibreAngles<F>& at, const Triple<F>& depth, F jitter,
                                   F sharpness = F(1.0F))
{
    const F one(1.0F);
    const F perCosD = one / at.cosD;
    const F twiceSinH = (at.sinI + at.sinO) * perCosD + jitter;
    const F height = perCosD * sharpness;
    const F half = at.cosPhi * F(0.5F);
    const F toward = F(0.5F) + half; // cos^2 of half the azimuth.
    const F cosHalf = root(toward);

    FibreLobes<F> lobes;
    lobes.r =
        longitudinal(shape, 0, twiceSinH, height, sharpness) * reflectance(at.cosD * cosHalf) * cosHalf * F(0.25F);
    // Refraction bends inclined rays up, so that their path is at most 1/cos(40 degrees) longer.
    const F sinSquare = one - at.cosD * at.cosD;
    const F path = one + sinSquare * (F(0.186F) + sinSquare * F(0.123F));
    lobes.through = absorbed(depth * path);
    const F reflected = meanReflectance(at.cosD);
    const F entered = (one - reflected) * (one - reflected) * F(kCosinePowerPeak);
    const auto eighth = [](F x) {
        x = most(x, F(0.05F));
        const F square = x * x;
        const F fourth = square * square;
        return fourth * fourth;
    };
    if constexpr (set != LobeSet::Back)
        lobes.tt =
            lobes.through * (longitudinal(shape, 1, twiceSinH, height, sharpness) * entered * eighth(F(0.5F) - half));
    if constexpr (set != LobeSet::Forward)
        lobes.trt = lobes.through * lobes.through *
                    (longitudinal(shape, 2, twiceSinH, height, sharpness) * entered * reflected * eighth(toward));
    return lobes;
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
