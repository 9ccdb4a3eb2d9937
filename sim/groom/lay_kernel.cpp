// A hair follows the field under it, in the coat, until the field or its hold ends; from there on it is straight, or
// hangs where it is long and on its way down.
#include "sim/groom/lay_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/groom/lay_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include "sim/base/at_length_inl.h"
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// Floats of a LayCell: normal, height of the skin, direction of growth, direction of falling.
constexpr std::int32_t kCellFloats = 10;
static_assert(sizeof(LayCell) == kCellFloats * sizeof(float));

constexpr float kLiesFrom = 0.45F; ///< A field flatter than this holds hair fully.
constexpr float kPerLyingRange = 1.0F / (kLiesFrom - kStandsBelow);
constexpr float kTurnM = 0.008F;  ///< Length along which hair turns to another direction.
constexpr float kSteepest = 0.6F; ///< Greatest sine of the angle at which a hair leaves the skin or goes back to it.
/// The same for long hair that goes back to it: its weight draws it straight past hollows such as the neck.
constexpr float kSteepestOfLong = 0.2F;
constexpr float kHangM = 0.03F;    ///< Length along which long hair that leaves the head turns to hang by its weight.
constexpr float kMostPush = 0.5F;  ///< Greatest push out of the head in a step, as a fraction of the step.
constexpr float kClearM = 0.0005F; ///< Nothing is laid nearer to the skin.

/// The cells that points are in, -1 where in none, and everywhere where not `wanted`.
HWY_INLINE Ints cellsAt(const SkinBand::Grid& grid, const Lanes3& pHd, Yes wanted)
{
    const IntTag di;
    const auto inGrid = [&](Lanes p, float origin) { return (p - origin) * grid.perCell; };
    const Lanes3 at{inGrid(pHd.x, grid.originHd.x), inGrid(pHd.y, grid.originHd.y), inGrid(pHd.z, grid.originHd.z)};
    // False for what is not a number.
    const auto within = [&](Lanes p, float size) { return (p >= 0.0F) & (p < size); };
    const Yes inside = (wanted & within(at.x, grid.size.x)) & (within(at.y, grid.size.y) & within(at.z, grid.size.z));
    const auto whole = [&](Lanes p) { return asInts(onlyWhere(inside, p)); };
    const Ints columns = hn::Set(di, static_cast<std::int32_t>(grid.size.x));
    const Ints rows = hn::Set(di, static_cast<std::int32_t>(grid.size.y));
    const Ints index = hn::Add(hn::Mul(hn::Add(hn::Mul(whole(at.z), rows), whole(at.y)), columns), whole(at.x));
    return hn::IfThenElse(hn::RebindMask(di, inside.m), hn::GatherIndex(di, grid.indices, index), hn::Set(di, -1));
}

/// Cosine between a hair at its root and the field, below which the field is the other side's.
constexpr float kAgainst = -0.5F;
constexpr float kEdgeM = 0.006F; ///< Length from the root where that is checked: a cell and a half.

/// As turnedBetween() of direction_texel.h.
HWY_INLINE Lanes3 turned(const Lanes3& grown, const Lanes3& fallen, Lanes falls)
{
    const Lanes3 mean = grown + (fallen - grown) * falls;
    const Lanes flat = root(dot(grown, grown));
    const Lanes flatness = flat + (root(dot(fallen, fallen)) - flat) * falls;
    const Lanes length = root(dot(mean, mean));
    const Yes opposed = length <= flatness * kOpposedDirections;
    const Lanes3 nearest = select(falls < 0.5F, grown, fallen);
    return select(opposed, nearest, mean * (flatness / select(opposed, 1.0F, length)));
}

/// Cells are coarse: at the edge of a parting a hair may begin in a cell of the other side. It then keeps its own
/// direction instead of the cell's, and so does every hair that `keeps`.
HWY_INLINE Lanes3 goingOn(Yes atEdge, Yes keeps, const Lanes3& direction, const Lanes3& normal, const Lanes3& growth,
                          Lanes flatness)
{
    const Lanes3 onward = direction - normal * dot(direction, normal);
    const Lanes onward2 = most(dot(onward, onward), 1e-6F);
    const Yes strange = keeps | (atEdge & (dot(onward, growth) < kAgainst * flatness));
    return select(strange, onward * (flatness / root(onward2)), growth);
}

/// Lays as many hairs as a vector has lanes, from `lane` on.
HWY_INLINE void layFrom(const LayTask& task, std::size_t lane)
{
    const IntTag di;
    const LayLanes& lanes = *task.lanes;
    const auto row = [&](const LayLanes::Row& values) { return loaded(values.data() + lane); };
    const auto row3 = [&](const std::array<LayLanes::Row, 3>& rows) {
        return Lanes3{row(rows[0]), row(rows[1]), row(rows[2])};
    };
    const Lanes one(1.0F);
    const Lanes segment = row(lanes.segmentM);
    const Lanes steps = row(lanes.steps);
    const Lanes falls = row(lanes.falls);
    const Lanes coat = row(lanes.coatM);
    const Lanes perRise = row(lanes.perRise);
    const Lanes keeps = row(lanes.keepsM);
    const bool anyRises = any(perRise > 0.0F);
    const Lanes step = segment / steps;
    const Lanes perClimb = one / most(step, kTurnM);
    const Lanes diving = 0.0F - (kSteepest + falls * (kSteepestOfLong - kSteepest));
    const Lanes turning = step / (step + kTurnM);
    const Lanes push = step * kMostPush;
    const int mostSteps = static_cast<int>(hn::GetLane(hn::MaxOfLanes(Tag(), steps.v)));
    const bool anyFalls = !all(falls == 0.0F);

    HWY_ALIGN std::int32_t found[kLanes];
    std::array<std::size_t, kLanes> passes{};
    Yes lies = task.cells != nullptr ? row(lanes.lies) > 0.0F : noLane();
    const Yes mayHang = lies & (falls > 0.0F);
    const Lanes hanging = falls * step / (step + kHangM);
    Lanes path(0.0F);
    Lanes3 direction = row3(lanes.directionHd);
    Lanes3 p = row3(lanes.rootHd);
    stored3(p, task.nodesHd + lane);
    for (int node = 1; node < task.nodes; ++node) {
        const Lanes3 parent = p;
        for (int k = 0; k < mostSteps; ++k) {
            const Yes inStep = static_cast<float>(k) < steps;
            Yes held = lies & inStep & (path < kFurthestLayM);
            if (any(held)) {
                const Ints cell = cellsAt(task.grid, p, held);
                held = {hn::RebindMask(Tag(), hn::Gt(cell, hn::Set(di, -1)))};
                hn::Store(cell, di, found);
                for (std::size_t i = 0; i < hn::Lanes(Tag()); ++i)
                    if (found[i] >= 0 && passes[i] < task.mostPassed)
                        task.passed[(lane + i) * task.mostPassed + passes[i]++] = found[i];

                const Ints first = hn::Mul(hn::Max(cell, hn::Zero(di)), hn::Set(di, kCellFloats));
                const auto gathered = [&](std::size_t offset) {
                    return gatheredFrom(&task.cells->normalHd.x + offset, first);
                };
                const auto gathered3 = [&](std::size_t offset) {
                    return Lanes3{gathered(offset), gathered(offset + 1), gathered(offset + 2)};
                };
                const Lanes3 normal = gathered3(0);
                const Lanes height = dot(p, normal) - gathered(3);
                Lanes3 growth = gathered3(4);
                if (anyFalls)
                    growth = turned(growth, gathered3(7), falls);

                // Nothing is laid inside the head; stubble, whose steps are shorter than cells are flat, goes on all
                // the same.
                const Yes sinks = held & (path > 0.0F) & ((height < kClearM) & (height > -SkinBand::kReachM));
                p = p + normal * onlyWhere(sinks, least(kClearM - height, push));

                const Lanes flatness = least(root(dot(growth, growth)), one);
                const Yes atEdge = held & (path < kEdgeM);
                const Yes isKept = held & (path < keeps);
                if (any(atEdge | isKept))
                    growth = goingOn(atEdge, isKept, direction, normal, growth, flatness);
                Lanes aim = coat;
                if (anyRises) {
                    // A head's curve falls off with the square of the path, too: nothing stands over what is nearer to
                    // the root.
                    const Lanes risen = least((path + step) * perRise, one);
                    aim = select(perRise > 0.0F, coat * (risen * risen), coat);
                }
                const Lanes sine = least(most((aim - height) * perClimb, diving), kSteepest);
                const Lanes sine2 = sine * sine;
                const Lanes cosine = one - sine2 * (0.5F + 0.125F * sine2);
                const Lanes flat = flatness - kStandsBelow;
                const Lanes follows = clamped(flat * kPerLyingRange, 0.0F, 1.0F) * turning;
                const Lanes perFlatness = cosine / most(flatness, 1e-6F);
                const Lanes3 wanted = growth * perFlatness + normal * sine;
                Lanes3 next = direction + (wanted - direction) * follows;
                next = next * (one / root(most(dot(next, next), 1e-6F)));
                direction = select(held, next, direction);
                path = path + onlyWhere(held, step);
                held = held & (flat > 0.0F);
            }
            const Yes hangs = mayHang & inStep & (direction.y < 0.0F) & (!held);
            if (any(hangs)) {
                Lanes3 next = direction - direction * hanging;
                next.y = next.y - hanging;
                direction = select(hangs, next * (one / root(most(dot(next, next), 1e-6F))), direction);
            }
            // What is not in this step waits as it is.
            lies = held | ((!inStep) & lies);
            p = p + direction * onlyWhere(inStep, step);
        }
        p = atLength(parent, p, segment, direction);
        stored3(p, task.nodesHd + static_cast<std::size_t>(node) * StrandBlocks::kNodeStride + lane);
    }
}

void LayLanesOf(const LayTask& task)
{
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(Tag()))
        layFrom(task, lane);
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
