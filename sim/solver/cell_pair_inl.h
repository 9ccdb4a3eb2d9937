// Two cells of HairBody's grid side by side, eight numbers, as one vector where the instruction set has such.
#if defined(HAIRPAINT_SIM_CELL_PAIR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_CELL_PAIR_INL_H_
#undef HAIRPAINT_SIM_CELL_PAIR_INL_H_
#else
#define HAIRPAINT_SIM_CELL_PAIR_INL_H_
#endif

#include "sim/base/lanes_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Two cells side by side, four numbers each.
#if HWY_TARGET != HWY_SCALAR && HWY_MAX_BYTES >= 32
using PairTag = hn::FixedTag<float, 8>;
using PairIntTag = hn::FixedTag<std::int32_t, 8>;
struct CellPair
{
    hn::Vec<PairTag> v;
};
HWY_INLINE CellPair pairOf(Quad first, Quad second)
{
    return {hn::Combine(PairTag(), second.v, first.v)};
}
HWY_INLINE CellPair pairAt(const std::int32_t* HWY_RESTRICT cell)
{
    return {hn::ConvertTo(PairTag(), hn::LoadU(PairIntTag(), cell))};
}
HWY_INLINE void addPair(CellPair pair, float weight, std::int32_t* HWY_RESTRICT cell)
{
    const PairIntTag di;
    const hn::Vec<PairIntTag> whole = hn::ConvertTo(di, hn::Mul(pair.v, hn::Set(PairTag(), weight)));
    hn::StoreU(hn::Add(hn::LoadU(di, cell), whole), di, cell);
}
HWY_INLINE CellPair operator-(CellPair a, CellPair b)
{
    return {hn::Sub(a.v, b.v)};
}
/// a + b t
HWY_INLINE CellPair plus(CellPair a, CellPair b, float t)
{
    return {hn::Add(a.v, hn::Mul(b.v, hn::Set(PairTag(), t)))};
}
HWY_INLINE Quad firstCell(CellPair pair)
{
    return {hn::LowerHalf(QuadTag(), pair.v)};
}
HWY_INLINE Quad secondCell(CellPair pair)
{
    return {hn::UpperHalf(QuadTag(), pair.v)};
}
#else
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Quad quadOfCell(const std::int32_t* HWY_RESTRICT cell)
{
    return {{static_cast<float>(cell[0]), static_cast<float>(cell[1]), static_cast<float>(cell[2]),
             static_cast<float>(cell[3])}};
}
HWY_INLINE void addToCell(const Quad& quad, std::int32_t* HWY_RESTRICT cell)
{
    for (std::size_t i = 0; i < 4; ++i)
        cell[i] += static_cast<std::int32_t>(quad.v[i]);
}
#else
using QuadIntTag = hn::FixedTag<std::int32_t, 4>;
HWY_INLINE Quad quadOfCell(const std::int32_t* HWY_RESTRICT cell)
{
    return {hn::ConvertTo(QuadTag(), hn::Load(QuadIntTag(), cell))};
}
HWY_INLINE void addToCell(Quad quad, std::int32_t* HWY_RESTRICT cell)
{
    const QuadIntTag di;
    hn::Store(hn::Add(hn::Load(di, cell), hn::ConvertTo(di, quad.v)), di, cell);
}
#endif
struct CellPair
{
    Quad first, second;
};
HWY_INLINE CellPair pairOf(const Quad& first, const Quad& second)
{
    return {first, second};
}
HWY_INLINE CellPair pairAt(const std::int32_t* HWY_RESTRICT cell)
{
    return {quadOfCell(cell), quadOfCell(cell + 4)};
}
HWY_INLINE void addPair(const CellPair& pair, float weight, std::int32_t* HWY_RESTRICT cell)
{
    addToCell(pair.first * quadOf(weight), cell);
    addToCell(pair.second * quadOf(weight), cell + 4);
}
HWY_INLINE CellPair operator-(const CellPair& a, const CellPair& b)
{
    return {a.first - b.first, a.second - b.second};
}
HWY_INLINE CellPair plus(const CellPair& a, const CellPair& b, float t)
{
    return {a.first + b.first * quadOf(t), a.second + b.second * quadOf(t)};
}
HWY_INLINE Quad firstCell(const CellPair& pair)
{
    return pair.first;
}
HWY_INLINE Quad secondCell(const CellPair& pair)
{
    return pair.second;
}
#endif

HWY_INLINE float firstOf(const Quad& quad)
{
#if HWY_TARGET == HWY_SCALAR
    return quad.v[0];
#else
    return hn::GetLane(quad.v);
#endif
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
