// Gains and per-strand constants.
#include "sim/solver/strand_constants.h"

#include "sim/base/deterministic.h"
#include "sim/groom/lay_kernel.h"
#include "sim/solver/wind_phases.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace hairpaint::sim {

namespace {

constexpr auto kStep = static_cast<float>(kStepSeconds);
constexpr float kWindRate = 1.0F; ///< 1/s: how fast a lock takes over the air's motion across it.
/// holdGain() above which all nodes of a rest shape must be outside the ellipsoids, not only the first two.
constexpr float kHeldShape = 0.02F;
constexpr float kRootDamping = 0.3F; ///< Fraction of a hair's motion at its root that the hair around takes in a step.

/// A gain of a step of 1/60 s, for kStepSeconds: half as long, so 1 - sqrt(1 - k).
float rescaled(float gain)
{
    static_assert(kStepSeconds * 120.0 == 1.0);
    return 1.0F - std::sqrt(1.0F - std::clamp(gain, 0.0F, 1.0F));
}

/// Fraction of motion that is left where a gain of `k` a step pulls: about critical damping of that spring.
float damped(float k)
{
    return 1.0F - std::min(1.0F, 1.2F * std::sqrt(k));
}

constexpr float kOfRest = 0.95F; ///< Fraction of its distance at rest at which hair beneath keeps a strand.

/// How far from the skin the hair beneath keeps a strand (root first) with body: 95 % of its own distance at rest where
/// that is least over the head once it has risen by kGirthSlope; at most its height in the coat.
float heldUpM(const ColliderSet& colliders, std::span<const glm::vec3> restHd, float segmentM, float coatHeightM)
{
    float heldM = colliders.grid ? coatHeightM : 0.0F;
    // Further on it is straight and knows nothing of the shoulders that it will lie on.
    for (std::size_t i = 2; i < restHd.size() && segmentM * static_cast<float>(i) < kFurthestLayM && heldM > 0.0F;
         ++i) {
        const auto sample = colliders.grid->at(restHd[i]);
        if (sample && kOfRest * sample->distanceM < kGirthSlope * segmentM * static_cast<float>(i))
            heldM = std::min(heldM, std::max(kOfRest * sample->distanceM, 0.0F));
    }
    return heldM;
}

/// The same at its first node: beside a parting hair has none beneath it, and the coat begins there. A part of what
/// holds the others is left, else the strand bows up to them and the coat grows.
float heldAtFirstM(const ColliderSet& colliders, std::span<const glm::vec3> restHd, float heldM)
{
    const auto sample = heldM > 0.0F ? colliders.grid->at(restHd[1]) : std::nullopt;
    constexpr float kLeft = 0.3F;
    const float ownM = sample ? std::clamp(kOfRest * sample->distanceM, 0.0F, heldM) : heldM;
    return ownM + kLeft * (heldM - ownM);
}

} // namespace

GroupGains gainsOf(const PhysicsSettings& physics, int nodes)
{
    GroupGains gains;
    gains.nodes = nodes;
    gains.drag = expDet(-std::clamp(physics.damping, 0.0F, 60.0F) * kStep);
    gains.gravityScale = physics.gravityScale;
    gains.windGain = 1.0F - expDet(-kWindRate * kStep);
    gains.frictionKeep = 1.0F - rescaled(physics.friction);
    const float slope = physics.friction / std::max(1.0F - physics.friction, 1e-3F); // 0.5 holds on 45 degrees
    gains.stickSlope2 = slope * slope;
    for (int i = 1; i < nodes; ++i) {
        const float left = 1.0F - static_cast<float>(i) / static_cast<float>(nodes - 1);
        gains.rootKeep[static_cast<std::size_t>(i)] = 1.0F - kRootDamping * left * left * left * left;
    }
    setWaveTables(gains);
    return gains;
}

float strandHash(const Groom& groom, std::size_t basisIndex)
{
    std::uint64_t number = basisIndex;
    if (groom.roots && basisIndex < groom.roots->basisSlot.size())
        number = groom.roots->rankOfSlot[groom.roots->basisSlot[basisIndex]];
    return unitFloat(hash64(0x77696e64ULL, number));
}

float bendingGain(float stiffnessM, float segmentM)
{
    constexpr float kStiffest = 1e7F; // Floats in the bending matrix allow no more; hair is rigid long before.
    if (!(segmentM > 0.0F))
        return 0.0F;
    const float segment2 = segmentM * segmentM;
    const float cube = stiffnessM * stiffnessM * stiffnessM;
    return std::min(kGravity * kStep * kStep * cube / (segment2 * segment2), kStiffest);
}

float holdGain(float gel)
{
    // Hair with gel of 0.3 sags under gravity by 2.5 cm, and with each tenth more by half as much.
    constexpr float kSagM = 0.025F;
    constexpr float kLn2 = 0.6931472F;
    // Gel of 1 holds against any force.
    const float amount = std::clamp(gel, 0.0F, 1.0F);
    const float amount2 = amount * amount;
    const float amount4 = amount2 * amount2;
    const float left = std::max(1.0F - amount4 * amount4, 1e-6F);
    return kGravity * kStep * kStep / kSagM * ((expDet(kLn2 * 10.0F * amount) - 1.0F) / (7.0F * left));
}

float styledFraction(float holdGain)
{
    constexpr float kHalf = 0.05F;
    return std::min(holdGain / (kHalf + holdGain), 1.0F);
}

float loftGain(float loft)
{
    constexpr float kSagM = 0.0008F; ///< Displacement by gravity at the root with a loft of 1.
    return loft > 0.0F ? kGravity * kStep * kStep / kSagM * std::min(loft, 1.0F) : 0.0F;
}

float coatM(float height, float volumeM, float segmentM)
{
    return std::min(height * volumeM, 0.5F * segmentM);
}

void setStrandConstants(StrandState& state, const Groom& groom, std::size_t basisIndex, const ColliderSet& colliders)
{
    const BasisStyles& basis = *groom.basis;
    const PhysicsSettings& physics = groom.settings.physics;
    std::array<glm::vec3, kMostNodes> rest;
    const auto nodes = static_cast<std::size_t>(groom.nodes);
    groom.blocks().read(basis.restPositions, basisIndex, std::span(rest).first(nodes));

    const float segment = basis[BasisQuantity::SegmentLength][basisIndex];
    const float hash = strandHash(groom, basisIndex);
    const glm::vec3 edge = rest[1] - rest[0];
    const float edge2 = glm::dot(edge, edge);
    const glm::vec3 lie = edge2 > 0.0F ? edge / std::sqrt(edge2) : glm::vec3(0.0F, 1.0F, 0.0F);
    const float hold = holdGain(basis[BasisQuantity::Gel][basisIndex]);

    state.field(basisIndex, kSegmentLength) = segment;
    state.field(basisIndex, kInverseSquare) = segment > 0.0F ? 1.0F / (segment * segment) : 0.0F;
    state.field(basisIndex, kBend) = bendingGain(physics.stiffnessM, segment);
    state.field(basisIndex, kHold) = hold;
    // A braid is no coat: its weight is not carried.
    const bool isBraided = basis[BasisQuantity::Girth][basisIndex] > 0.0F;
    state.field(basisIndex, kLoft) = isBraided ? 0.0F : loftGain(physics.loft);
    state.field(basisIndex, kHoldKeep) = damped(hold / (1.0F + hold));
    state.field(basisIndex, kLieX) = lie.x;
    state.field(basisIndex, kLieY) = lie.y;
    state.field(basisIndex, kLieZ) = lie.z;
    const WindPhases phases = windPhases(rest[0], hash, basis[BasisQuantity::Height][basisIndex]);
    state.field(basisIndex, kPhaseGust) = phases.gust;
    state.field(basisIndex, kPhaseA) = phases.a;
    state.field(basisIndex, kPhaseB) = phases.b;
    state.field(basisIndex, kExposure) = phases.exposure * physics.windScale;
    // Further out nothing is known of the skin.
    constexpr float kMostGirthM = DistanceGrid::kReachM - 0.5F * DistanceGrid::kCellM;
    float girthM = basis[BasisQuantity::Girth][basisIndex];
    float firstM = girthM;
    if (physics.body > 0.0F) {
        const std::span<const glm::vec3> line = std::span(rest).first(nodes);
        const float amount = std::min(2.0F * physics.body, 1.0F);
        const float heldM = heldUpM(colliders, line, segment, physics.volumeM);
        girthM = std::max(girthM, amount * heldM);
        firstM = std::max(firstM, amount * heldAtFirstM(colliders, line, heldM));
    }
    state.field(basisIndex, kGirth) = std::min(girthM, kMostGirthM);
    state.field(basisIndex, kGirthFirst) = std::min(firstM, kMostGirthM);
    constexpr float kGivenBack = 1.0F; // With less, what is left over keeps a braid creeping over a shoulder.
    state.field(basisIndex, kRecoil) = isBraided && physics.body > 0.0F ? kGivenBack : 0.0F;
    state.field(basisIndex, kGive) = basis[BasisQuantity::Give][basisIndex] / (1.0F + hold);
    state.field(basisIndex, kStretch) =
        std::clamp(state.field(basisIndex, kStretch), -state.field(basisIndex, kGive), state.field(basisIndex, kGive));
    // A held shape keeps out every node; hair that falls anyway only what stands at the root.
    const std::span<const glm::vec3> clear =
        std::span(rest).first(hold > kHeldShape ? nodes : std::min<std::size_t>(nodes, 2));
    for (int c = 0; c < colliders.count; ++c) {
        const float scale = strandScale(colliders.items[static_cast<std::size_t>(c)], clear,
                                        coatM(basis[BasisQuantity::Height][basisIndex], physics.volumeM, segment));
        state.field(basisIndex, kScale + c) = scale * scale;
    }
}

} // namespace hairpaint::sim
