// From the scene's light to the screen's: what is dim stays as it is, what is bright rolls off toward white.
#if defined(HAIRPAINT_RENDERING_TONE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_TONE_INL_H_
#undef HAIRPAINT_RENDERING_TONE_INL_H_
#else
#define HAIRPAINT_RENDERING_TONE_INL_H_
#endif

#include "view/rendering/light/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

inline constexpr float kMostLight = 4.0F; ///< What samples hold at most; a white wall in full light is 1.
inline constexpr float kToneKnee = 0.5F;  ///< Up to here light is shown as it is.

/// 0..1 of light from 0 on; a hyperbola that leaves the straight line with the line's slope.
template<class F>
HWY_INLINE F toneOf(F light)
{
    const F over = most(light - F(kToneKnee), F(0.0F)) * F(1.0F / (1.0F - kToneKnee));
    return least(light, F(kToneKnee)) + F(1.0F - kToneKnee) * over / (F(1.0F) + over);
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
