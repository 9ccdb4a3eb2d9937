// The rest shape of gathered hair: taut over the skin to its tie's ring, through it, and on as the tie's form says.
#pragma once

#include "sim/groom/gather_kernel.h"
#include "sim/groom/group_settings.h"
#include "sim/groom/taut_strings.h"
#include "sim/groom/tie.h"

#include <span>
#include <vector>

namespace hairpaint::sim {

/// The node in the ring: those before it lie on the skin, those after it are the tail. The same for all hairs of a
/// group.
[[nodiscard]] int ringNode(int nodes);

/// Lays the hair of one tie: kLanes hairs at once, by gatherLanes(). Immutable; any thread. Must not outlive the
/// strings.
class GatheredLay
{
public:
    GatheredLay() = default;
    /// `coatM`: how high hair lies that is not taut at all.
    GatheredLay(const Tie& tie, const TautStrings& strings, float coatM);

    /// Puts a hair into a lane; what else the lanes say of it is the caller's.
    void put(GatherLanes& lanes, std::size_t lane, std::uint32_t face, glm::vec3 rootHd) const;
    /// Lays the hairs: `nodesHd` [nodes][3][kLanes]. `leastFreeM`: least length behind the ring; 0: hair that is too
    /// short ends before it.
    void lay(GatherLanes& lanes, int nodes, std::span<float> nodesHd, float leastFreeM = 0.0F) const;
    /// A point of the path from the ring (`fraction` 0) up to `heightM` along its axis (1), as a coil rises: see
    /// coilGirth() in curve_formula.inl.
    [[nodiscard]] glm::vec3 onCoil(float heightM, float fraction) const;

private:
    void makeTail();

    const TautStrings* m_strings = nullptr;
    GatherTask m_task; ///< What all hair has in common.
    std::vector<TailPoint> m_tail;
};

} // namespace hairpaint::sim
