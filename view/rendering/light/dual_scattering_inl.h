// Light that reaches a hair through other hair, and what the hair around throws back: after Zinke and others 2008.
#if defined(HAIRPAINT_RENDERING_DUAL_SCATTERING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_DUAL_SCATTERING_INL_H_
#undef HAIRPAINT_RENDERING_DUAL_SCATTERING_INL_H_
#else
#define HAIRPAINT_RENDERING_DUAL_SCATTERING_INL_H_
#endif

#include "view/rendering/light/fibre_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// Light left of 1 behind some fibres.
template<class F>
struct Passed
{
    F direct;      ///< Fraction of light that met no hair.
    Triple<F> all; ///< With what was scattered forward by those that it met.
};

/// Behind `crossed` fibres on average, each of optical depth `depth`. Light meets none of them with probability
/// exp(-kMet crossed); what it meets sends kDensity of the light on (their d_f), less what each absorbs and throws
/// back.
template<class F>
HWY_INLINE Passed<F> passedThrough(F crossed, const Triple<F>& depth)
{
    constexpr float kMet = 0.75F;
    constexpr float kLostBack = 0.07F; ///< Optical depth of what a fibre reflects.
    constexpr float kDensity = 0.7F;
    const F direct = absorbed(crossed * F(kMet));
    const F scattered = (F(1.0F) - direct) * F(kDensity);
    const auto channel = [&](F d) { return direct + scattered * absorbed(crossed * (d + F(kLostBack))); };
    return {direct, {channel(depth.x), channel(depth.y), channel(depth.z)}};
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
