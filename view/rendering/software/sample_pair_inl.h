// Two samples of a tile in one register, where registers are that wide.
#if defined(HAIRPAINT_RENDERING_SAMPLE_PAIR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_RENDERING_SAMPLE_PAIR_INL_H_
#undef HAIRPAINT_RENDERING_SAMPLE_PAIR_INL_H_
#else
#define HAIRPAINT_RENDERING_SAMPLE_PAIR_INL_H_
#endif

#include "view/rendering/light/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::rendering::HWY_NAMESPACE {

/// Two samples beside each other.
#if HWY_MAX_BYTES >= 32 && HWY_TARGET != HWY_SCALAR
struct Pair
{
    hn::Vec<hn::FixedTag<float, 8>> v;
};
HWY_INLINE Pair pairOf(Quad first, Quad second)
{
    return {hn::Combine(hn::FixedTag<float, 8>(), second.v, first.v)};
}
template<bool kAdjacent>
HWY_INLINE Pair loadedPair(const float* first, const float* second)
{
    if constexpr (kAdjacent)
        return {hn::LoadU(hn::FixedTag<float, 8>(), first)};
    else
        return pairOf(quadOf(first), quadOf(second));
}
template<bool kAdjacent>
HWY_INLINE void storedPair(Pair pair, float* first, float* second)
{
    if constexpr (kAdjacent) {
        hn::StoreU(pair.v, hn::FixedTag<float, 8>(), first);
    } else {
        stored(Quad{hn::LowerHalf(QuadTag(), pair.v)}, first);
        stored(Quad{hn::UpperHalf(QuadTag(), pair.v)}, second);
    }
}
HWY_INLINE Pair operator+(Pair a, Pair b)
{
    return {hn::Add(a.v, b.v)};
}
HWY_INLINE Pair operator*(Pair a, Pair b)
{
    return {hn::Mul(a.v, b.v)};
}
/// The fourth of each in all four.
HWY_INLINE Pair fourths(Pair a)
{
    return {hn::Broadcast<3>(a.v)};
}
/// Each of two floats in all four of one. Reads eight.
HWY_INLINE Pair spread(const float* two)
{
    HWY_ALIGN static constexpr std::int32_t kFirstThenSecond[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    const hn::FixedTag<float, 8> d;
    return {hn::TableLookupLanes(hn::LoadU(d, two), hn::SetTableIndices(d, kFirstThenSecond))};
}
#else
struct Pair
{
    Quad first, second;
};
HWY_INLINE Pair pairOf(Quad first, Quad second)
{
    return {first, second};
}
template<bool kAdjacent>
HWY_INLINE Pair loadedPair(const float* first, const float* second)
{
    return {quadOf(first), quadOf(second)};
}
template<bool kAdjacent>
HWY_INLINE void storedPair(const Pair& pair, float* first, float* second)
{
    stored(pair.first, first);
    stored(pair.second, second);
}
HWY_INLINE Pair operator+(const Pair& a, const Pair& b)
{
    return {a.first + b.first, a.second + b.second};
}
HWY_INLINE Pair operator*(const Pair& a, const Pair& b)
{
    return {a.first * b.first, a.second * b.second};
}
HWY_INLINE Pair spread(const float* two)
{
    return {quadOf(two[0]), quadOf(two[1])};
}
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Pair fourths(const Pair& a)
{
    return {quadOf(a.first.v[3]), quadOf(a.second.v[3])};
}
#else
HWY_INLINE Pair fourths(const Pair& a)
{
    return {{hn::Broadcast<3>(a.first.v)}, {hn::Broadcast<3>(a.second.v)}};
}
#endif
#endif

} // namespace hairpaint::rendering::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
