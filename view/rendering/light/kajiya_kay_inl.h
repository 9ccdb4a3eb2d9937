// Light scattered once by a fibre: Kajiya and Kay 1989, with a second, coloured highlight as Scheuermann 2004 has it.
#if defined(HAIRPAINT_RENDERING_KAJIYA_KAY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_KAJIYA_KAY_INL_H_
#undef HAIRPAINT_RENDERING_KAJIYA_KAY_INL_H_
#else
#define HAIRPAINT_RENDERING_KAJIYA_KAY_INL_H_
#endif

#include "view/rendering/light/fibre_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

template<class F>
struct Highlights
{
    F first, second; ///< In the light's colour; in the hair's.
};

/// cos^n of the angle between the eye and the cone of mirrored rays, the cone opened by `shift` toward the tip.
template<class F>
HWY_INLINE F mirroredCone(const FibreAngles<F>& at, float sinShift, float cosShift, F exponent)
{
    const F sine = at.sinI * F(cosShift) + at.cosI * F(sinShift);
    const F cosine = at.cosI * F(cosShift) - at.sinI * F(sinShift);
    return powerOf(clamped(cosine * at.cosO - sine * at.sinO, 0.0F, 1.0F), exponent);
}

/// `exponent` of the first highlight; the second is four times as wide. Cones toward the tip and toward the root.
template<class F>
HWY_INLINE Highlights<F> kajiyaKay(const FibreAngles<F>& at, F exponent)
{
    constexpr float kSinTip = 0.0898785F; // Twice the scales' tilt,
    constexpr float kCosTip = 0.9959527F;
    constexpr float kSinRoot = -0.1790296F; // four times.
    constexpr float kCosRoot = 0.9838437F;
    return {mirroredCone(at, kSinTip, kCosTip, exponent), mirroredCone(at, kSinRoot, kCosRoot, exponent * F(0.25F))};
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
