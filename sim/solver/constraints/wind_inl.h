// Wind: drag of the air against each segment's relative velocity. The air is the wind with gusts that pass over the
// head, two waves of turbulence and puffs.
#if defined(HAIRPAINT_SIM_WIND_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HAIRPAINT_SIM_WIND_INL_H_
#undef HAIRPAINT_SIM_WIND_INL_H_
#else
#define HAIRPAINT_SIM_WIND_INL_H_
#endif

#include "sim/base/lanes_inl.h"
#include "sim/solver/solver_layout.h"

HWY_BEFORE_NAMESPACE();
namespace hairpaint::sim::HWY_NAMESPACE {

/// sin(x) for |x| < 4 pi, within 0.002: two parabolas.
HWY_INLINE Lanes waveSin(Lanes x)
{
    const Lanes turns = rounded(x * 0.15915494F);
    const Lanes y = x - turns * 6.2831853F;
    const Lanes a = y * 1.2732395F - y * magnitude(y) * 0.40528473F;
    return (a * magnitude(a) - a) * 0.225F + a;
}

/// The air around one strand: the wind there, and its two waves of turbulence.
struct StrandAir
{
    Lanes3 wind;
    Lanes sinA, cosA, sinB, cosB;
};

HWY_INLINE StrandAir airAround(const StepForces& step, const float* HWY_RESTRICT lanes)
{
    constexpr float kQuarter = 1.5707963F;
    const Lanes gustWave = waveSin(loaded(lanes + kPhaseGust * kLanes) - step.phaseGust);
    const Lanes lull = step.gust * (0.5F - 0.5F * gustWave);
    const Lanes exposure = loaded(lanes + kExposure * kLanes);
    const Lanes strength = exposure * (1.0F - lull);
    const Lanes a = loaded(lanes + kPhaseA * kLanes) - step.phaseA;
    const Lanes b = loaded(lanes + kPhaseB * kLanes) - step.phaseB;
    const auto wave = [&](Lanes phase) { return waveSin(phase) * exposure; };
    return {everyLane(step.wind) * strength, wave(a), wave(a + kQuarter), wave(b), wave(b + kQuarter)};
}

/// Velocity of the air at one node, m a step.
HWY_INLINE Lanes3 airAt(const StrandAir& air, const GroupGains& gains, const StepForces& step, std::size_t node,
                        const Lanes3& p)
{
    const Lanes waveA = air.sinA * gains.waveACos[node] + air.cosA * gains.waveASin[node];
    const Lanes waveB = air.sinB * gains.waveBCos[node] + air.cosB * gains.waveBSin[node];
    Lanes3 wind = air.wind + everyLane(step.swirlA) * waveA;
    wind = wind + everyLane(step.swirlB) * waveB;
    for (int i = 0; i < step.puffCount; ++i) {
        const PuffForces& puff = step.puffs[static_cast<std::size_t>(i)];
        const Lanes3 away = p - everyLane(puff.centre);
        const Lanes left = most(Lanes(0.0F), 1.0F - dot(away, away) * puff.inverseRadius2);
        wind = wind + everyLane(puff.velocity) * (left * left);
    }
    return wind;
}

/// A node's velocity after a step in air of velocity `wind`: -((t x r) x t) for the relative velocity r, since only its
/// part across the segment `edge` drags.
HWY_INLINE Lanes3 blown(const GroupGains& gains, const Lanes3& wind, const Lanes3& edge, Lanes inverseSquare,
                        const Lanes3& velocity)
{
    const Lanes3 relative = wind - velocity;
    const Lanes along = dot(edge, relative) * inverseSquare;
    const Lanes3 across = relative - edge * along;
    return velocity + across * gains.windGain;
}

} // namespace hairpaint::sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
