// From the scene's light to the screen's: what is dim stays as it is, what is bright rolls off toward white.
#if defined(HAIRPAINT_RENDERING_TONE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_TONE_INL_H_
#undef HAIRPAINT_RENDERING_TONE_INL_H_
#else
#define HAIRPAINT_RENDERING_TONE_INL_H_
#endif

#include "view/rendering/light/lanes_inl.h"
#include "view/rendering/light/light_range.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

inline constexpr float kToneKnee = 0.5F;      ///< Up to here light is shown as it is.
inline constexpr float kPaling = 0.5F;        ///< How much of its colour the brightest light loses.
inline constexpr float kMostPainted = 0.875F; ///< What is painted lighter would take too much light to show.

/// 0..1 of light from 0 on; a hyperbola that leaves the straight line with the line's slope.
template<class F>
HWY_INLINE F toneOf(F light)
{
    const F over = most(light - F(kToneKnee), F(0.0F)) * F(1.0F / (1.0F - kToneKnee));
    return least(light, F(kToneKnee)) + F(1.0F - kToneKnee) * over / (F(1.0F) + over);
}

/// By the brightest channel, so that no colour changes its hue; what is far too bright pales.
template<class F>
HWY_INLINE Triple<F> toneOf(const Triple<F>& light)
{
    const F brightest = most(most(light.x, light.y), most(light.z, F(1e-6F)));
    if (!any(brightest > F(kToneKnee)))
        return light;
    const F shown = toneOf(brightest);
    const F rolledOff = most(shown - F(kToneKnee), F(0.0F)) * F(1.0F / (1.0F - kToneKnee));
    const F square = rolledOff * rolledOff;
    const F white = square * square * F(kPaling);
    const Triple<F> coloured = light * (shown / brightest * (F(1.0F) - white));
    const F grey = shown * white;
    return coloured + Triple<F>{grey, grey, grey};
}

/// Light that toneOf() shows as `shown`, 0..kMostPainted.
template<class F>
HWY_INLINE Triple<F> lightShownAs(const Triple<F>& shown)
{
    const F brightest = most(most(shown.x, shown.y), most(shown.z, F(1e-6F)));
    const F over = clamped(brightest - F(kToneKnee), 0.0F, kMostPainted - kToneKnee);
    const F light = least(brightest, F(kToneKnee)) + over * F(1.0F - kToneKnee) / (F(1.0F - kToneKnee) - over);
    return shown * (light / brightest);
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
