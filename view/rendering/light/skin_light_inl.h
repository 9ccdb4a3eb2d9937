// Light on skin, as head.frag has it: lamps and surroundings with a faint sheen; pores that stir the normal.
#if defined(HAIRPAINT_RENDERING_SKIN_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_SKIN_LIGHT_INL_H_
#undef HAIRPAINT_RENDERING_SKIN_LIGHT_INL_H_
#else
#define HAIRPAINT_RENDERING_SKIN_LIGHT_INL_H_
#endif

#include "view/rendering/light/environment_inl.h"
#include "view/rendering/light/hair_light.h"
#include "view/rendering/light/lanes_inl.h"
#include "view/rendering/light/skin_light.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// A point of the skin. Marks are 0..1.
template<class F>
struct SkinPoint
{
    Triple<F> positionHd;
    Triple<F> positionWo;
    Triple<F> normalWo;
    F sky, lips, lids, blush;
    F pixelM;              ///< How far apart neighbouring pixels are on the skin.
    bool isTinted = false; ///< Whether the two below are there; see ScalpTint::Texel.
    Triple<F> tint;
    F untinted;
};

HWY_INLINE Lanes unitHashOf(Ints x, Ints y, Ints z)
{
    using hn::Mul;
    using hn::Set;
    using hn::ShiftRight;
    using hn::Xor;
    const hn::Rebind<std::uint32_t, Tag> du;
    const auto bits = [&](Ints i) { return hn::BitCast(du, i); };
    auto h = Xor(Xor(Mul(bits(x), Set(du, 0x8DA6B343U)), Mul(bits(y), Set(du, 0xD8163841U))),
                 Mul(bits(z), Set(du, 0xCB1AB31FU)));
    h = Xor(h, ShiftRight<16>(h));
    h = Mul(h, Set(du, 0x7FEB352DU));
    h = Xor(h, ShiftRight<15>(h));
    h = Mul(h, Set(du, 0x846CA68BU));
    h = Xor(h, ShiftRight<16>(h));
    return Lanes(
        hn::Mul(hn::ConvertTo(Tag(), hn::BitCast(IntTag(), ShiftRight<8>(h))), hn::Set(Tag(), 1.0F / 16777216.0F)));
}

/// Gradient of value noise over cells of one unit.
HWY_INLINE Triple<Lanes> noiseGradient(const Triple<Lanes>& p)
{
    const IntTag di;
    const Triple<Lanes> cell{floored(p.x), floored(p.y), floored(p.z)};
    const Triple<Lanes> t = p - cell;
    const Triple<Lanes> ease = t * t *
                               Triple<Lanes>{Lanes(3.0F) - t.x * Lanes(2.0F), Lanes(3.0F) - t.y * Lanes(2.0F),
                                             Lanes(3.0F) - t.z * Lanes(2.0F)};
    const Triple<Lanes> one = tripleOf<Lanes>(glm::vec3(1.0F));
    const Triple<Lanes> slope = t * (one - t) * Lanes(6.0F);
    const Ints x = hn::ConvertTo(di, cell.x.v);
    const Ints y = hn::ConvertTo(di, cell.y.v);
    const Ints z = hn::ConvertTo(di, cell.z.v);
    Lanes low[4];
    Lanes rise[4];
    Lanes alongX[4];
    for (int i = 0; i < 4; ++i) {
        const Ints yi = hn::Add(y, hn::Set(di, i & 1));
        const Ints zi = hn::Add(z, hn::Set(di, i >> 1));
        low[i] = unitHashOf(x, yi, zi);
        rise[i] = unitHashOf(hn::Add(x, hn::Set(di, 1)), yi, zi) - low[i];
        alongX[i] = low[i] + rise[i] * ease.x;
    }
    const Lanes y0 = mixed(alongX[0], alongX[1], ease.y);
    const Lanes y1 = mixed(alongX[2], alongX[3], ease.y);
    return slope * Triple<Lanes>{mixed(mixed(rise[0], rise[1], ease.y), mixed(rise[2], rise[3], ease.y), ease.z),
                                 mixed(alongX[1] - alongX[0], alongX[3] - alongX[2], ease.z), y1 - y0};
}

/// Pores and fine lines, as far as the picture can show them: a cell smaller than two pixels would only flicker.
HWY_INLINE Triple<Lanes> grained(const SkinLighting& given, const SkinPoint<Lanes>& point, const Triple<Lanes>& n)
{
    constexpr float kCellsM[2] = {0.0016F, 0.0007F};
    constexpr float kSlopes[2] = {0.045F, 0.09F};
    Triple<Lanes> slope = tripleOf<Lanes>(glm::vec3(0.0F));
    for (int i = 0; i < 2; ++i) {
        const Lanes seen = Lanes(1.0F) - smoothStep(0.2F, 0.5F, point.pixelM * Lanes(1.0F / kCellsM[i]));
        if (any(seen > Lanes(0.0F)))
            slope = slope + noiseGradient(point.positionHd * Lanes(1.0F / kCellsM[i])) * (seen * Lanes(kSlopes[i]));
    }
    const glm::mat3& m = given.woFromHd;
    const auto row = [&](int r) {
        return (slope.x * Lanes(m[0][r]) + slope.y * Lanes(m[1][r]) + slope.z * Lanes(m[2][r])) * Lanes(given.grain);
    };
    const Triple<Lanes> turned{row(0), row(1), row(2)};
    return unit(n - (turned - n * dot(turned, n)));
}

/// Sky that reaches a point of which `sky` is open, light thrown back by the skin around it included: Jimenez and
/// others, Practical Realtime Strategies for Accurate Indirect Occlusion.
template<class F>
HWY_INLINE F openness(F sky, F albedo)
{
    const F a = F(2.0404F) * albedo - F(0.3324F);
    const F b = F(-4.7951F) * albedo + F(0.6417F);
    const F c = F(2.7552F) * albedo + F(0.6903F);
    return most(sky, ((sky * a + b) * sky + c) * sky);
}

HWY_INLINE Triple<Lanes> skinLight(const SkinLighting& given, const SkinPoint<Lanes>& point)
{
    using F = Lanes;
    const F one(1.0F);
    const F zero(0.0F);
    const Triple<F> v = unit(tripleOf<F>(given.eyeWo) - point.positionWo);
    const Triple<F> smooth = unit(point.normalWo);
    const Triple<F> n = given.grain > 0.0F ? grained(given, point, smooth) : smooth;
    const auto mixedWith = [&](const Triple<F>& a, glm::vec3 b, F t) { return a + (tripleOf<F>(b) - a) * t; };
    Triple<F> albedo = mixedWith(tripleOf<F>(given.colour), given.lips, point.blush * F(0.35F));
    albedo = mixedWith(albedo, given.lids, point.lids);
    albedo = mixedWith(albedo, given.lips, point.lips);
    if (point.isTinted)
        albedo = albedo * point.untinted + point.tint;

    const F up = n.y * F(0.5F) + F(0.5F);
    const Triple<F> around = irradianceAt(given.around, n) * (F(0.52F) + F(0.2F) * up);
    Triple<F> lit = Triple<F>{around.x * openness(point.sky, albedo.x), around.y * openness(point.sky, albedo.y),
                              around.z * openness(point.sky, albedo.z)} *
                    albedo;
    Triple<F> gloss = around * (point.sky * point.sky * F(0.06F));
    const F turnedAway = one - most(dot(smooth, v), zero);
    const F grazing = turnedAway * turnedAway * turnedAway;
    gloss = gloss * grazing * (albedo + tripleOf<F>(glm::vec3(0.3F)));

    const F exponent = mixed(F(24.0F), F(48.0F), point.lips);
    for (const FarLight* lamp : {&given.key, &given.fill, &given.rim}) {
        const Triple<F> l = tripleOf<F>(lamp->towardWo);
        const F facingRough = dot(n, l);
        const F facingSmooth = dot(smooth, l);
        // A fold that is open to half the sky is open to light from right above it alone.
        const F open = smoothStep(-0.25F, 0.35F, facingSmooth + F(2.0F) * point.sky * point.sky - one);
        // Light goes under the skin and comes out beyond the edge of the shadow, red furthest. There pores are filled
        // too.
        const auto body = [&](float wrapOf, float smoothOf, float light) {
            const float wrap = 0.16F + given.scatter * wrapOf;
            const F facing = mixed(facingRough, facingSmooth, F(given.scatter * smoothOf));
            const F key = clamped((facing + F(wrap)) * F(1.0F / (1.0F + wrap)), 0.0F, 1.0F);
            return key * root(key) * open * F(0.85F * light);
        };
        lit = lit + albedo * Triple<F>{body(0.15F, 0.7F, lamp->colour.x), body(0.03F, 0.4F, lamp->colour.y),
                                       body(0.0F, 0.3F, lamp->colour.z)};
        const F shine = powerOf(most(dot(n, unit(l + v)), zero), exponent) * (exponent + F(8.0F)) * F(0.0011F) *
                        clamped(facingRough * F(4.0F), 0.0F, 1.0F);
        gloss = gloss + tripleOf<F>(lamp->colour) * (point.sky * shine * (one + F(4.0F) * grazing));
    }
    return lit + gloss * F(given.sheen);
}

/// Light that comes through the hair between a point and the end of a grid. What is blended between neighbours is the
/// light, not the hair: a plait holds so much of it that the least part of its voxel would be dark.
HWY_INLINE Lanes lightThrough(const std::uint32_t* grid, int side, const Triple<Lanes>& position, float strength)
{
    const IntTag di;
    const auto size = static_cast<float>(side);
    const Lanes atX = clamped(position.x * Lanes(size) - Lanes(0.5F), -1.0F, size);
    const Lanes atY = clamped(position.y * Lanes(size) - Lanes(0.5F), -1.0F, size);
    const Lanes atZ = clamped(position.z * Lanes(size) - Lanes(0.5F), -1.0F, size);
    const Lanes lowX = floored(atX);
    const Lanes lowY = floored(atY);
    const Lanes lowZ = floored(atZ);
    Lanes light(0.0F);
    for (int i = 0; i < 8; ++i) {
        const Lanes cx = lowX + Lanes(static_cast<float>(i & 1));
        const Lanes cy = lowY + Lanes(static_cast<float>((i >> 1) & 1));
        const Lanes cz = lowZ + Lanes(static_cast<float>(i >> 2));
        const Lanes wx = (i & 1) != 0 ? atX - lowX : Lanes(1.0F) - (atX - lowX);
        const Lanes wy = ((i >> 1) & 1) != 0 ? atY - lowY : Lanes(1.0F) - (atY - lowY);
        const Lanes wz = (i >> 2) != 0 ? atZ - lowZ : Lanes(1.0F) - (atZ - lowZ);
        const Yes inside =
            (cx > Lanes(-0.5F)) & (cx < Lanes(size - 0.5F)) & (cy > Lanes(-0.5F)) & (cy < Lanes(size - 0.5F));
        const auto whole = [&](Lanes c) { return hn::ConvertTo(di, clamped(c, 0.0F, size - 1.0F).v); };
        const Ints index =
            hn::Add(hn::Mul(hn::Add(hn::Mul(whole(cz), hn::Set(di, side)), whole(cy)), hn::Set(di, side)), whole(cx));
        const Ints voxels = hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(grid), index);
        const Lanes units(hn::ConvertTo(Tag(), hn::And(voxels, hn::Set(di, 0xFFFF))));
        const Lanes hair = select(inside, units * Lanes(1.0F / kGridUnits), Lanes(0.0F));
        light = light + wx * wy * wz * exp2Of(hair * Lanes(-strength));
    }
    return light;
}

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
