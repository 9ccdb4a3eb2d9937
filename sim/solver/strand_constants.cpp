// Gains and per-strand constants.
#include "sim/solver/strand_constants.h"

#include "sim/base/deterministic.h"
#include "sim/solver/start_shape.h"
#include "sim/solver/wind_phases.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

namespace {

constexpr auto kStep = static_cast<float>(kStepSeconds);
constexpr float kWindRate = 2.4F; ///< 1/s: how fast hair takes over the air's motion across it.
constexpr float kShortStiffness = 0.6F;
constexpr float kStraightenFraction = 0.02F; ///< Of body.
/// Below this gain a held shape is only a leaning, and its other nodes may lie on the ellipsoids.
constexpr float kHeldShape = 0.2F;

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

} // namespace

GroupGains gainsOf(const PhysicsSettings& physics, int nodes)
{
    GroupGains gains;
    gains.nodes = nodes;
    gains.drag = expDet(-std::clamp(physics.damping, 0.0F, 60.0F) * kStep);
    gains.gravityScale = physics.gravityScale;
    gains.windScale = physics.windScale;
    gains.windGain = 1.0F - expDet(-kWindRate * kStep);
    gains.frictionKeep = 1.0F - rescaled(physics.friction);
    const float slope = physics.friction / std::max(1.0F - physics.friction, 1e-3F); // 0.5 holds on 45 degrees
    gains.stickSlope2 = slope * slope;
    gains.straighten = kStraightenFraction * rescaled(physics.body);
    for (int i = 1; i < nodes; ++i) {
        const auto node = static_cast<std::size_t>(i);
        const float fraction = static_cast<float>(i) / static_cast<float>(nodes - 1);
        const float left = 1.0F - fraction;
        const float left5 = left * left * left * left * left;
        const float fading = left5 * left5 + (left - left5 * left5) * physics.body; // full body reaches far
        gains.body[node] = rescaled(physics.body * fading);
        gains.bodyKeep[node] = damped(gains.body[node]);
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

float holdOf(float gel, float body, float lengthM)
{
    const float shortness = std::clamp((0.10F - lengthM) / (0.10F - 0.02F), 0.0F, 1.0F);
    const float stiff = kShortStiffness * shortness * shortness * std::min(1.0F, 4.0F * body);
    const float gelled = gel * gel * gel; // so that half the slider is half the effect
    return 1.0F - (1.0F - gelled) * (1.0F - stiff);
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

    const float segment = basis.segmentLengths[basisIndex];
    const float hash = strandHash(groom, basisIndex);
    const glm::vec3 edge = rest[1] - rest[0];
    const float edge2 = glm::dot(edge, edge);
    StrandRoot root;
    root.positionHd = rest[0];
    root.normalHd = edge2 > 0.0F ? edge / std::sqrt(edge2) : glm::vec3(0.0F, 1.0F, 0.0F);
    root.lengthM = segment * static_cast<float>(groom.nodes - 1);
    root.gel = std::clamp(basis.gel[basisIndex], 0.0F, 1.0F);
    root.body = std::clamp(physics.body, 0.0F, 1.0F);
    root.parting = std::clamp(physics.parting, 0.0F, 1.0F);
    root.sweepBack = std::clamp(physics.sweepBack, 0.0F, 1.0F);
    root.hash01 = hash;
    const glm::vec3 lie = lieDirection(root);
    const float hold = holdOf(root.gel, root.body, root.lengthM);
    const float gain = rescaled(hold);

    state.field(basisIndex, kSegmentLength) = segment;
    state.field(basisIndex, kInverseSquare) = segment > 0.0F ? 1.0F / (segment * segment) : 0.0F;
    state.field(basisIndex, kLoose) = 1.0F - gain;
    state.field(basisIndex, kLooseDrag) = damped(gain);
    state.field(basisIndex, kLieX) = lie.x;
    state.field(basisIndex, kLieY) = lie.y;
    state.field(basisIndex, kLieZ) = lie.z;
    const WindPhases phases = windPhases(rest[0], hash);
    state.field(basisIndex, kPhaseGust) = phases.gust;
    state.field(basisIndex, kPhaseA) = phases.a;
    state.field(basisIndex, kPhaseB) = phases.b;
    // A held shape keeps out every node; hair that falls anyway only what stands at the root.
    const std::span<const glm::vec3> clear =
        std::span(rest).first(hold > kHeldShape ? nodes : std::min<std::size_t>(nodes, 2));
    for (int c = 0; c < colliders.count; ++c) {
        const float scale = strandScale(colliders.items[static_cast<std::size_t>(c)], clear,
                                        coatM(basis.height[basisIndex], physics.volumeM, segment));
        state.field(basisIndex, kScale + c) = scale * scale;
    }
}

} // namespace hairpaint::sim
