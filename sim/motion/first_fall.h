// How hair that is new falls: before the shoulders or behind them, as a hairdresser lays it.
#pragma once

#include "sim/skin/neck.h"
#include "sim/solver/solver_layout.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <span>

namespace hairpaint::sim {

/// Where hair meets a shoulder, a few millimetres decide whether it slides off before it or behind, and so do the
/// shoulders of the head it is on. At first each strand therefore leans to its own side: forward where it hangs before
/// the neck's middle, back where it hangs behind it. Strands that start hanging do so before they are seen, all hair
/// that starts from its rest shape does for a second. Thereafter physics alone rules. A value; any thread.
class FirstFall
{
public:
    /// One that begins now.
    [[nodiscard]] static FirstFall begun();
    void begin() { m_stepsDone = 0; }
    void pass(std::size_t steps) { m_stepsDone += steps; }
    /// Sets gains.leans and gains.lean; returns for how many steps from now on they are right, at least one.
    std::size_t apply(const Neck& neck, GroupGains& gains) const;

private:
    std::size_t m_stepsDone = static_cast<std::size_t>(-1) / 2; ///< Long over.
};

/// Whether a strand may hang down to the shoulders. `restHd`: its rest shape, root first. Hd, m. None does on a head
/// whose neck is not known.
[[nodiscard]] bool reachesShoulders(std::span<const glm::vec3> restHd, float segmentM, const Neck& neck);

/// What kLean is of a strand that hangs as `hangingHd` from an upright head: -1 behind the middle of the neck, 1 before
/// it, with a smooth step between; 0 where it ends above the shoulders.
[[nodiscard]] float leanOf(std::span<const glm::vec3> hangingHd, float segmentM, const Neck& neck);

} // namespace hairpaint::sim
