// Light on an infinitely thin line: Zoeckler, Stalling and Hege 1996.
#if defined(HAIRPAINT_RENDERING_ILLUMINATED_LINE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_ILLUMINATED_LINE_INL_H_
#undef HAIRPAINT_RENDERING_ILLUMINATED_LINE_INL_H_
#else
#define HAIRPAINT_RENDERING_ILLUMINATED_LINE_INL_H_
#endif

#include "view/rendering/light/fibre_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

inline constexpr float kExcessBrightness = 4.8F; ///< Power that tames the sum over all normals of a line (Banks 1994).

template<class F>
struct LineLight
{
    F diffuse;
    F specular;
};

/// The normal of all those across the line that is best for each: diffuse (1-(L.T)^2)^(p/2), specular with `exponent`.
template<class F>
HWY_INLINE LineLight<F> illuminatedLine(const FibreAngles<F>& at, F exponent)
{
    const F mirrored = most(at.cosI * at.cosO - at.sinI * at.sinO, F(0.0F));
    return {powerOf(at.cosI, F(kExcessBrightness)), powerOf(mirrored, exponent)};
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
