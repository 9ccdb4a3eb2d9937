// What the solver's kernel reads and writes: the arrays of a group's basis hairs, a step's forces, a group's gains.
#pragma once

#include "sim/groom/groom.h"
#include "sim/solver/collider_set.h"

#include <array>
#include <cstdint>

namespace hairpaint::sim {

inline constexpr double kStepSeconds = 1.0 / 120.0; ///< The solver's fixed step.
inline constexpr float kGravity = 9.81F;            ///< m/s2.
inline constexpr int kMaxPuffs = 4;

/// Constants of a strand, one row of kLanes floats each; a row of squared scales for each collider follows.
enum LaneField : std::uint8_t
{
    kSegmentLength, ///< m
    kInverseSquare, ///< 1/length^2
    kBend,          ///< Stiffness against bending of a step, see bendingGain().
    kHold,          ///< Strength of the spring to the rest shape of a step, see holdGain().
    kLoft,          ///< Strength of the spring that keeps a coat's height, at the root; it falls off over kLoftM.
    kHoldKeep,      ///< Fraction of the motion against the head that the held shape leaves, 0..1.
    kLieX,          ///< Unit vector in which the strand leaves the skin.
    kLieY,
    kLieZ,
    kPhaseGust, ///< Phases of the wind's three waves at this root, rad, 0..2 pi.
    kPhaseA,
    kPhaseB,
    kExposure,     ///< Fraction of the wind's strength.
    kGirth,        ///< Distance at which it is kept from the skin, m: half the thickness of the braid about it,
                   ///< or what the hair beneath takes up; 0 for a single hair.
    kGirthFirst,   ///< The same at its first node, which no more hair lies beneath than at rest.
    kRecoil,       ///< 0..1: see recoil(); 0 without body.
    kGive,         ///< Fraction of its length by which the strand stretches and shortens; 0: not at all.
    kStretch,      ///< Fraction by which it is longer now, -kGive..kGive,
    kStretchSpeed, ///< and by how much more a second.
    kLean,         ///< -1..1: how far it is put forward (else back) while it first falls.
    kLoad,         ///< Recent load in units of its own weight; kUnwanted where the strand is new.
    kStill,        ///< Steps without motion; kUnwanted where no hair is solved.
    kMiddleX,      ///< Where the middle node was when the hair last moved, Hd, m;
    kMiddleY,
    kMiddleZ,
    kTipX, ///< and the tip.
    kTipY,
    kTipZ,
    kScale ///< The first collider's row.
};

/// A braid reaches its girth over half a turn from its root: by this fraction of the length along it.
inline constexpr float kGirthSlope = 0.4F;
inline constexpr float kLoftM = 0.12F; ///< Length from the root along which the coat carries itself.
/// The most that it carries, as a displacement in a step, m: three tenths of its weight, as much as presses on a lying
/// coat; wind exceeds it.
inline constexpr float kLoftYieldM = 0.3F * kGravity * static_cast<float>(kStepSeconds * kStepSeconds);
inline constexpr float kUnwanted = 1e30F;
inline constexpr float kStillSteps = 60.0F; ///< A strand that lay still for so long falls asleep.
inline constexpr float kStillM = 2e-4F;     ///< What counts as lying still: middle and tip move no farther than this.
inline constexpr float kFastestM = 10.0F / 120; ///< Speed limit, m a step.

/// A rigid motion: rows * p + offset.
struct RigidMotion
{
    std::array<std::array<float, 3>, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::array<float, 3> offset{};
    bool identity = true;
};

/// Air that a puff moves. Hd, metres a step.
struct PuffForces
{
    std::array<float, 3> centre{};
    std::array<float, 3> velocity{};
    float inverseRadius2 = 0.0F; ///< 1/m2
};

/// How far the head is turned on its neck: skin below it lies elsewhere than in the head's own frame.
struct NeckTurn
{
    bool turned = false; ///< If false the other members are not read.
    std::array<float, 3> pivot{};
    /// Quaternion x, y, z, w >= 0: from the head's frame to the shoulders'.
    std::array<float, 4> turn{0.0F, 0.0F, 0.0F, 1.0F};
    float headY = 0.0F;      ///< Height from which down the neck twists, m;
    float perTwistM = 0.0F;  ///< fraction of the twist a metre;
    float shouldersY = 0.0F; ///< height at which it is complete, m.
};

/// What acts on every strand in one step. Hd, metres a step.
struct StepForces
{
    RigidMotion toNewHead; ///< From the head's frame a step ago to the present one.
    NeckTurn neck;         ///< At the step's end.
    std::array<float, 3> gravity{};
    bool windy = false; ///< Any wind or puff: nothing sleeps.
    std::array<float, 3> wind{};
    float gust = 0.0F; ///< 0..1: fraction of the wind that comes and goes, at different times at different points.
    std::array<float, 3> swirlA{}; ///< Amplitudes of the two waves of turbulence.
    std::array<float, 3> swirlB{};
    float phaseGust = 0.0F; ///< Phases of the three waves at this moment, rad, 0..2 pi.
    float phaseA = 0.0F;
    float phaseB = 0.0F;
    int puffCount = 0;
    std::array<PuffForces, kMaxPuffs> puffs{};
};

/// A group's own constants for a step of kStepSeconds.
struct GroupGains
{
    int nodes = 0;
    float drag = 1.0F; ///< Factor of the velocity.
    float gravityScale = 1.0F;
    float windGain = 0.0F;       ///< Fraction of the relative velocity of the air taken over in a step.
    float frictionKeep = 1.0F;   ///< Fraction of the tangential motion kept in contact.
    float stillM = kStillM;      ///< What counts as lying still, see kStillM.
    bool beginsInAir = false;    ///< Strands do not stand on skin: their first segments are kept out of it, too.
    bool leans = false;          ///< If false `lean` is not read.
    std::array<float, 3> lean{}; ///< What a kLean of 1 adds to gravity, Hd, m a step.
    float stickSlope2 = 0.0F;    ///< Contact sticks while (tangential/normal motion)^2 is below.
    std::array<float, kMostNodes> rootKeep{}; ///< Fraction of the motion against the head that hair around leaves.
    std::array<float, kMostNodes> waveACos{}, waveASin{}, waveBCos{}, waveBSin{}; ///< Turbulence along the strand.
};

inline constexpr int kBraidPlanes = 4; ///< Other braids that a node keeps off at once.
inline constexpr int kBraidRows = 3 + 4 * kBraidPlanes;

/// Half spaces that nodes of braids stay in, see BraidContact. They hold p where dot(n, p) >= d + steps * dot(n, v);
/// those of a lane without any have n and d 0.
struct BraidPlanes
{
    const std::int32_t* rowOfBlock = nullptr; ///< [blocks], -1 where no strand is a braid; null without braids.
    const float* rows = nullptr;              ///< [rows][nodes][kBraidRows][kLanes]: v, then n and d of each.
    const std::uint8_t* counts = nullptr;     ///< [rows][nodes]: half spaces, 0..kBraidPlanes.
    int stepsDone = 0;                        ///< Steps since they were found.
};

/// Blocks of kLanes strands. `rest`, `positions` and `previous`: [blocks][nodes][3][kLanes]; `lanes`:
/// [blocks][laneRows][kLanes]. Positions of the step before and of the present one take turns in `positions`.
struct SolverBlocks
{
    const float* rest = nullptr;
    std::array<float*, 2> positions{};
    float* previous = nullptr; ///< x* of equation 5: the present position less the velocity.
    float* lanes = nullptr;
    std::size_t laneRows = kScale;       ///< kScale and the colliders.
    std::uint8_t* awake = nullptr;       ///< [blocks] whether anything may still move; written by the kernel.
    const float* contact = nullptr;      ///< As `rest`: with hair around, see BodyPush; null without body.
    const std::uint8_t* dense = nullptr; ///< [blocks], see BodyPush; read with body alone.
    BraidPlanes braids{};
};

} // namespace hairpaint::sim
