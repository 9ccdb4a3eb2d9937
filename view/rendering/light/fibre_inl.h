// What the scattering models of a fibre have in common: angles against its tangent, and absorption inside it.
#if defined(HAIRPAINT_RENDERING_FIBRE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_FIBRE_INL_H_
#undef HAIRPAINT_RENDERING_FIBRE_INL_H_
#else
#define HAIRPAINT_RENDERING_FIBRE_INL_H_
#endif

#include "view/rendering/light/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// Angles of the light and the eye, both seen from the fibre; inclinations are measured from the plane across it.
template<class F>
struct FibreAngles
{
    F sinI, cosI; ///< Inclination of the light.
    F sinO, cosO; ///< Inclination of the eye.
    F cosPhi;     ///< Cosine of the azimuth between them.
    F cosD;       ///< Cosine of half the difference of the inclinations; 0 only for a ray along the fibre.
};

template<class F>
HWY_INLINE F cosineOf(F sine)
{
    return root(most(F(1.0F) - sine * sine, F(1e-6F)));
}

/// From dot products of unit vectors: tangent . light, tangent . eye with its cosine, light . eye.
template<class F>
HWY_INLINE FibreAngles<F> fibreAngles(F sinI, F sinO, F cosO, F lightDotEye)
{
    const F cosI = cosineOf(sinI);
    const F cosines = cosI * cosO;
    const F sines = sinI * sinO;
    const F cosPhi = clamped((lightDotEye - sines) / cosines, -1.0F, 1.0F);
    const F cosD = root(most((cosines + sines) * F(0.5F) + F(0.5F), F(1e-4F)));
    return {sinI, cosI, sinO, cosO, cosPhi, cosD};
}

/// exp(-x) for x from 0 on, within 0.003: the eighth power of a short series.
template<class F>
HWY_INLINE F absorbed(F x)
{
    const F a = F(1.0F) / (F(1.0F) + x * (F(1.0F / 8.0F) + x * F(1.0F / 128.0F)));
    const F square = a * a;
    const F fourth = square * square;
    return fourth * fourth;
}
template<class F>
HWY_INLINE Triple<F> absorbed(const Triple<F>& x)
{
    return {absorbed(x.x), absorbed(x.y), absorbed(x.z)};
}

/// Optical depth of a fibre, crossed at right angles, whose coat looks as `colour` (linear, 0..1): Chiang and others
/// 2016, equation 9, for an azimuthal roughness of 0.3, over the mean chord through a fibre of refractive index 1.55.
template<class F>
HWY_INLINE F fibreDepth(F colour)
{
    constexpr float kLn2 = 0.69314718F;
    constexpr float kOfRoughness = 5.8877F;
    constexpr float kMeanChord = 1.8526F; ///< In radii of the fibre.
    const F log = log2Of(clamped(colour, 0.001F, 0.999F)) * F(kLn2 / kOfRoughness);
    return log * log * F(kMeanChord);
}
template<class F>
HWY_INLINE Triple<F> fibreDepth(const Triple<F>& colour)
{
    return {fibreDepth(colour.x), fibreDepth(colour.y), fibreDepth(colour.z)};
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
