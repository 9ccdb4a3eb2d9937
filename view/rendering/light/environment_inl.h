// Light from all around on a surface.
#if defined(HAIRPAINT_RENDERING_ENVIRONMENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_ENVIRONMENT_INL_H_
#undef HAIRPAINT_RENDERING_ENVIRONMENT_INL_H_
#else
#define HAIRPAINT_RENDERING_ENVIRONMENT_INL_H_
#endif

#include "view/rendering/light/environment.h"
#include "view/rendering/light/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// On a surface with unit normal n; what the short series leaves below 0 is cut.
template<class F>
HWY_INLINE Triple<F> irradianceAt(const Irradiance& e, const Triple<F>& n)
{
    const F basis[8] = {
        n.y, n.z, n.x, n.x * n.y, n.y * n.z, n.z * n.z * F(3.0F) - F(1.0F), n.x * n.z, n.x * n.x - n.y * n.y};
    const auto channel = [&](int c) {
        F sum(e[0][c]);
        for (std::size_t i = 0; i < 8; ++i)
            sum = sum + basis[i] * F(e[i + 1][c]);
        return most(sum, F(0.0F));
    };
    return {channel(0), channel(1), channel(2)};
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
