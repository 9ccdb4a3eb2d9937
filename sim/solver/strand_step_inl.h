// One step of a group's basis hairs: the list of what acts on them, each in a file of its own under constraints/.
#if defined(HAIRPAINT_SIM_STRAND_STEP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_STRAND_STEP_INL_H_
#undef HAIRPAINT_SIM_STRAND_STEP_INL_H_
#else
#define HAIRPAINT_SIM_STRAND_STEP_INL_H_
#endif

#include "sim/base/at_length_inl.h"
#include "sim/solver/constraints/bending_inl.h"
#include "sim/solver/constraints/body_inl.h"
#include "sim/solver/constraints/braids_inl.h"
#include "sim/solver/constraints/coil_inl.h"
#include "sim/solver/constraints/fibre_damping_inl.h"
#include "sim/solver/constraints/friction_inl.h"
#include "sim/solver/constraints/head_following_inl.h"
#include "sim/solver/constraints/inertia_inl.h"
#include "sim/solver/constraints/lean_inl.h"
#include "sim/solver/constraints/length_inl.h"
#include "sim/solver/constraints/obstacles_inl.h"
#include "sim/solver/constraints/recoil_inl.h"
#include "sim/solver/constraints/sleep_inl.h"
#include "sim/solver/constraints/speed_limit_inl.h"
#include "sim/solver/constraints/wind_inl.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// The half spaces of a block with braids, at its first node; `rows` is null for others.
struct BraidRows
{
    const float* HWY_RESTRICT rows = nullptr;
    const std::uint8_t* HWY_RESTRICT counts = nullptr;
    int stepsOn = 0; ///< Steps since they were found, with this one.
};

/// What a step's strands read and write. Every pointer is already at their block and lane.
struct StrandRows
{
    const float* HWY_RESTRICT rest;
    const float* HWY_RESTRICT current;
    float* HWY_RESTRICT next;
    float* HWY_RESTRICT previous;
    float* HWY_RESTRICT lanes;
    float* HWY_RESTRICT p;          ///< Scratch: where nodes are headed.
    const float* HWY_RESTRICT hair; ///< Contact with hair around; null where there is none.
    bool hasBody;
    bool recoils; ///< Any of the strands, see recoil().
    BraidRows braids;
};

/// Where equation 5, with drag, gravity, wind and the hair around, and the strand's own stiffness lead its nodes, into
/// rows.p.
HWY_INLINE void predict(const GroupGains& gains, const StepForces& step, const StrandRows& rows)
{
    const Lanes inverseSquare = loaded(rows.lanes + kInverseSquare * kLanes);
    const Lanes3 weight = everyLane(step.gravity) * gains.gravityScale;
    StrandAir air{};
    if (step.windy)
        air = airAround(step, rows.lanes);
    HWY_ALIGN float eliminated[std::size_t{kMostNodes} * 2 * kLanes];
    BendingSolve bending(gains.nodes, rows.lanes, eliminated);
    Lanes3 before = loaded3(rows.current);
    if (!step.toNewHead.identity)
        before = moved(step.toNewHead, before);
    stored3(loaded3(rows.rest), rows.p);
    const int last = gains.nodes - 1;
    NodeMotion upcoming = motionOf(step, gains.drag, rows.current, rows.previous, 1);
    Lanes3 velocityBefore{0.0F, 0.0F, 0.0F};
    for (int i = 1; i <= last; ++i) {
        const auto node = static_cast<std::size_t>(i);
        const Lanes3 x = upcoming.position;
        Lanes3 v = upcoming.velocity;
        if (i < last) {
            upcoming = motionOf(step, gains.drag, rows.current, rows.previous, i + 1);
            const Lanes3 undamped = v;
            v = dampedBending(velocityBefore, v, upcoming.velocity);
            velocityBefore = undamped;
        }
        if (step.windy)
            v = blown(gains, airAt(air, gains, step, node, x), x - before, inverseSquare, v);
        const Lanes3 styled = loaded3(rows.rest + node * StrandBlocks::kNodeStride);
        const Lanes3 gravity = gains.leans ? weight + leaning(gains, rows.lanes, i) : weight;
        Lanes3 headed = x + v + gravity;
        if (rows.hair != nullptr)
            headed = x + amongHair(rows.hair + node * StrandBlocks::kNodeStride, v + gravity);
        bending.eliminate(i, headed - styled, rows.p);
        before = x;
    }
    bending.substitute(rows.rest, rows.p);
}

HWY_INLINE BraidsBeside braidsBeside(const BraidRows& braids, int node)
{
    if (braids.rows == nullptr)
        return {nullptr, 0, 0};
    const auto at = static_cast<std::size_t>(node);
    return {braids.rows + at * kBraidRows * kLanes, braids.counts[at], braids.stepsOn};
}

/// One exact pass from root to tip: each node at its length, outside of what it touches, its velocity for the next
/// step.
HWY_INLINE Lanes3 projectNode(const GroupGains& gains, const ColliderSet& colliders, const StepForces& step,
                              const StrandRows& rows, int node, Lanes length, Yes moving, const Lanes3& parent)
{
    const std::size_t offset = static_cast<std::size_t>(node) * StrandBlocks::kNodeStride;
    const Lanes3 start = loaded3(rows.current + offset);
    const Lanes3 lie = loaded3(rows.lanes + kLieX * kLanes);
    const Obstacles obstacles{
        colliders, step.neck, rows.lanes, clearanceOf(rows.lanes, length, node), node == 1 && !gains.beginsInAir,
        parent};
    const Lanes3 headed = loaded3(rows.p + offset);
    Lanes3 p = atLength(parent, headed, length, lie);
    if (rows.recoils && node > 1)
        recoil(rows.lanes, moving, p - headed, rows.previous + offset - StrandBlocks::kNodeStride);
    BraidsBeside braids = braidsBeside(rows.braids, node);
    if (braids.keep(gains, start, p))
        p = select(braids.touched(), atLength(parent, p, length, lie), p);
    Contact contact = noContact();
    Yes ofSkin = contact.touched;
    if (collide(obstacles, p, contact, ofSkin)) {
        p = rubbed(gains, contact, start, p);
        if (rows.hasBody)
            p = heldBeside(contact, loaded3(rows.rest), start, p);
        p = select(contact.touched, atLength(parent, p, length, lie), p);
        Contact second = noContact();
        if (collideAgain(obstacles, p, second, ofSkin))
            p = select(second.touched, atLength(parent, p, length, lie), p);
    }

    const Lanes3 onHead = p - start; // motion as the head sees it
    Lanes3 velocity = step.toNewHead.identity ? onHead : p - moved(step.toNewHead, start);
    const Lanes keep = keptAgainstHead(gains, rows.lanes, node);
    velocity = followingHead(velocity, onHead, keep);
    if (any(braids.touched()))
        velocity = braids.leaving(onHead, keep, velocity, p);
    velocity = limited(sliding(contact, onHead, keep, velocity));
    p = select(moving, p, start);
    stored3(p, rows.next + offset);
    stored3(select(moving, p - velocity, p), rows.previous + offset);
    return p;
}

/// The step, from the last positions in rows.current to the next in rows.next.
HWY_INLINE void stepStrands(const GroupGains& gains, const ColliderSet& colliders, const StepForces& step,
                            const StrandRows& rows)
{
    StillWatch watch(step.windy, gains.stillM, rows.lanes);
    const Lanes length = coiledLength(rows.lanes);
    predict(gains, step, rows);
    const Lanes tension = restoreLengths(gains.nodes, length, watch.moving(), rows.p);
    swingCoil(gains.nodes, watch.moving(), tension * length, rows.lanes);
    const Lanes3 root = loaded3(rows.rest);
    stored3(root, rows.next);
    stored3(root, rows.previous);
    Lanes3 p = root;
    for (int node = 1; node < gains.nodes; ++node) {
        p = projectNode(gains, colliders, step, rows, node, length, watch.moving(), p);
        watch.see(node, gains.nodes, p, rows.lanes);
    }
    const Yes lost = isLost(loaded3(rows.rest), p);
    if (HWY_UNLIKELY(any(lost)))
        restart(gains.nodes, lost, rows.rest, rows.next, rows.previous);
    watch.finish(step.windy, gains.nodes, rows.next, rows.lanes);
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
