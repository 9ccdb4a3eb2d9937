// A hair follows the field under it, in the coat, until the field or its hold ends; from there on it is straight.
#include "sim/groom/lay_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/groom/lay_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/base/vec3_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Of a cell: normal, height of the skin, direction of growth, of falling.
constexpr std::int32_t kCellFloats = 10;
static_assert(sizeof(LayCell) == kCellFloats * sizeof(float));

constexpr float kLiesFrom = 0.45F; ///< A field flatter than this holds hair fully.
constexpr float kPerLyingRange = 1.0F / (kLiesFrom - kStandsBelow);
constexpr float kTurnM = 0.008F;        ///< Along which hair turns to another direction.
constexpr float kSteepest = 0.6F;       ///< Sine of the angle at which a hair goes back to the skin;
constexpr float kSteepestOfLong = 0.2F; ///< of long hair, whose weight draws it straight past hollows such as the neck.
constexpr float kMostPush = 0.5F;       ///< Of a step, out of the head.
constexpr float kClearM = 0.0005F;      ///< Nothing is laid nearer to the skin.

/// The cells that positions are in, -1 where in none, and everywhere where not `wanted`.
template<class D, class DI = hn::Rebind<std::int32_t, D>>
HWY_INLINE hn::Vec<DI> cellsAt(D d, const SkinBand::Grid& grid, const Vec3<hn::Vec<D>>& place, hn::Mask<D> wanted)
{
    const DI di;
    const auto perCell = hn::Set(d, grid.perCell);
    const auto inGrid = [&](hn::Vec<D> p, float origin) { return hn::Mul(hn::Sub(p, hn::Set(d, origin)), perCell); };
    const Vec3<hn::Vec<D>> at{inGrid(place.x, grid.originHd.x), inGrid(place.y, grid.originHd.y),
                              inGrid(place.z, grid.originHd.z)};
    const auto within = [&](hn::Vec<D> p, float size) {
        // False for what is not a number.
        return hn::And(hn::Ge(p, hn::Zero(d)), hn::Lt(p, hn::Set(d, size)));
    };
    const auto inside = hn::And(hn::And(wanted, within(at.x, grid.size.x)),
                                hn::And(within(at.y, grid.size.y), within(at.z, grid.size.z)));
    const auto whole = [&](hn::Vec<D> p) { return hn::ConvertTo(di, hn::IfThenElseZero(inside, p)); };
    const auto columns = hn::Set(di, static_cast<std::int32_t>(grid.size.x));
    const auto rows = hn::Set(di, static_cast<std::int32_t>(grid.size.y));
    const auto index = hn::Add(hn::Mul(hn::Add(hn::Mul(whole(at.z), rows), whole(at.y)), columns), whole(at.x));
    return hn::IfThenElse(hn::RebindMask(di, inside), hn::GatherIndex(di, grid.indices, index), hn::Set(di, -1));
}

constexpr float kAgainst = -0.5F; ///< Cosine between a hair at its root and a field that is the other side's.
constexpr float kEdgeM = 0.006F;  ///< A cell and a half.

/// As turnedBetween() of direction_texel.h.
template<class D>
HWY_INLINE Vec3<hn::Vec<D>> turned(D d, const Vec3<hn::Vec<D>>& grown, const Vec3<hn::Vec<D>>& fallen, hn::Vec<D> falls)
{
    using V = hn::Vec<D>;
    const Vec3<V> mean = addScaled(grown, sub(fallen, grown), falls);
    const V flat = hn::Sqrt(dot(grown, grown));
    const V flatness = hn::Add(flat, hn::Mul(hn::Sub(hn::Sqrt(dot(fallen, fallen)), flat), falls));
    const V length = hn::Sqrt(dot(mean, mean));
    const auto opposed = hn::Le(length, hn::Mul(flatness, hn::Set(d, kOpposedDirections)));
    const Vec3<V> nearest = choose(hn::Lt(falls, hn::Set(d, 0.5F)), grown, fallen);
    return choose(opposed, nearest, scale(mean, hn::Div(flatness, hn::IfThenElse(opposed, hn::Set(d, 1.0F), length))));
}

/// Lanes lane..lane + Lanes(d).
template<class D>
HWY_INLINE void layFrom(D d, const LayTask& task, std::size_t lane)
{
    using V = hn::Vec<D>;
    using M = hn::Mask<D>;
    const hn::Rebind<std::int32_t, D> di;
    const LayLanes& lanes = *task.lanes;
    const auto row = [&](const LayLanes::Row& values) { return hn::LoadU(d, values.data() + lane); };
    const auto row3 = [&](const std::array<LayLanes::Row, 3>& rows) {
        return Vec3<V>{row(rows[0]), row(rows[1]), row(rows[2])};
    };
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F);
    const V segment = row(lanes.segmentM);
    const V steps = row(lanes.steps);
    const V falls = row(lanes.falls);
    const V coat = row(lanes.coatM);
    const V step = hn::Div(segment, steps);
    const V perClimb = hn::Div(one, hn::Max(step, hn::Set(d, kTurnM)));
    const V diving =
        hn::Sub(zero, hn::Add(hn::Set(d, kSteepest), hn::Mul(falls, hn::Set(d, kSteepestOfLong - kSteepest))));
    const V turning = hn::Div(step, hn::Add(step, hn::Set(d, kTurnM)));
    const V push = hn::Mul(step, hn::Set(d, kMostPush));
    const int mostSteps = static_cast<int>(hn::GetLane(hn::MaxOfLanes(d, steps)));
    const bool anyFalls = !hn::AllTrue(d, hn::Eq(falls, zero));

    HWY_ALIGN std::int32_t found[kLanes];
    std::array<std::size_t, kLanes> passes{};
    M lies = task.cells != nullptr ? hn::Gt(row(lanes.lies), zero) : hn::Lt(zero, zero);
    V path = zero;
    Vec3<V> direction = row3(lanes.directionHd);
    Vec3<V> place = row3(lanes.rootHd);
    store3(d, place, task.nodesHd + lane);
    for (int node = 1; node < task.nodes; ++node) {
        const Vec3<V> parent = place;
        for (int k = 0; k < mostSteps; ++k) {
            const M inStep = hn::Lt(hn::Set(d, static_cast<float>(k)), steps);
            M held = hn::And(hn::And(lies, inStep), hn::Lt(path, hn::Set(d, kFurthestLayM)));
            if (!hn::AllFalse(d, held)) {
                const auto cell = cellsAt(d, task.grid, place, held);
                held = hn::RebindMask(d, hn::Gt(cell, hn::Set(di, -1)));
                hn::Store(cell, di, found);
                for (std::size_t i = 0; i < hn::Lanes(d); ++i)
                    if (found[i] >= 0 && passes[i] < task.mostPassed)
                        task.passed[(lane + i) * task.mostPassed + passes[i]++] = found[i];

                const auto first = hn::Mul(hn::Max(cell, hn::Zero(di)), hn::Set(di, kCellFloats));
                const auto gathered = [&](std::size_t offset) {
                    return hn::GatherIndex(d, &task.cells->normalHd.x + offset, first);
                };
                const auto gathered3 = [&](std::size_t offset) {
                    return Vec3<V>{gathered(offset), gathered(offset + 1), gathered(offset + 2)};
                };
                const Vec3<V> normal = gathered3(0);
                const V height = hn::Sub(dot(place, normal), gathered(3));
                Vec3<V> growth = gathered3(4);
                if (anyFalls)
                    growth = turned(d, growth, gathered3(7), falls);

                // Nothing is laid inside the head; stubble, whose steps are shorter than cells are flat, goes on all
                // the same.
                const M sinks =
                    hn::And(hn::And(held, hn::Gt(path, zero)), hn::And(hn::Lt(height, hn::Set(d, kClearM)),
                                                                       hn::Gt(height, hn::Set(d, -SkinBand::kReachM))));
                const V rise = hn::Min(hn::Sub(hn::Set(d, kClearM), height), push);
                place = addScaled(place, normal, hn::IfThenElseZero(sinks, rise));

                const V flatness = hn::Min(hn::Sqrt(dot(growth, growth)), one);
                // Cells are coarse: at the edge of a parting hair begins in one of the other side, and goes on as it
                // does.
                const M atEdge = hn::And(held, hn::Lt(path, hn::Set(d, kEdgeM)));
                if (!hn::AllFalse(d, atEdge)) {
                    const Vec3<V> onward = sub(direction, scale(normal, dot(direction, normal)));
                    const V onward2 = hn::Max(dot(onward, onward), hn::Set(d, 1e-6F));
                    const M strange =
                        hn::And(atEdge, hn::Lt(dot(onward, growth), hn::Mul(hn::Set(d, kAgainst), flatness)));
                    growth = choose(strange, scale(onward, hn::Div(flatness, hn::Sqrt(onward2))), growth);
                }
                const V sine =
                    hn::Min(hn::Max(hn::Mul(hn::Sub(coat, height), perClimb), diving), hn::Set(d, kSteepest));
                const V sine2 = hn::Mul(sine, sine);
                const V cosine =
                    hn::Sub(one, hn::Mul(sine2, hn::Add(hn::Set(d, 0.5F), hn::Mul(hn::Set(d, 0.125F), sine2))));
                const V flat = hn::Sub(flatness, hn::Set(d, kStandsBelow));
                const V follows =
                    hn::Mul(hn::Min(hn::Max(hn::Mul(flat, hn::Set(d, kPerLyingRange)), zero), one), turning);
                const V perFlatness = hn::Div(cosine, hn::Max(flatness, hn::Set(d, 1e-6F)));
                const Vec3<V> wanted = addScaled(scale(growth, perFlatness), normal, sine);
                Vec3<V> next = addScaled(direction, sub(wanted, direction), follows);
                next = scale(next, hn::Div(one, hn::Sqrt(hn::Max(dot(next, next), hn::Set(d, 1e-6F)))));
                direction = choose(held, next, direction);
                path = hn::Add(path, hn::IfThenElseZero(held, step));
                held = hn::And(held, hn::Gt(flat, zero));
            }
            // What is not in this step waits as it is.
            lies = hn::Or(held, hn::AndNot(inStep, lies));
            place = addScaled(place, direction, hn::IfThenElseZero(inStep, step));
        }
        place = atLength(d, parent, place, segment, direction);
        store3(d, place, task.nodesHd + static_cast<std::size_t>(node) * StrandBlocks::kNodeStride + lane);
    }
}

void LayLanesOf(const LayTask& task)
{
    const hn::CappedTag<float, kLanes> d;
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(d))
        layFrom(d, task, lane);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hairpaint::sim {

HWY_EXPORT(LayLanesOf);

void layLanes(const LayTask& task)
{
    HWY_DYNAMIC_DISPATCH(LayLanesOf)(task);
}

} // namespace hairpaint::sim
#endif
