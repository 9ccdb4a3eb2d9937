// Where braids grow: connected regions of braid kind, their centres, and the centre that each hair belongs to.
#pragma once

#include "sim/groom/groom.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// Neighbours in a region stand no further apart than this many mean spacings of basis hairs.
inline constexpr float kBraidReachSpacings = 1.8F;

/// Basis hairs of one kind that stand within kBraidReachSpacings of each other form a region. Each region has centres
/// at least the group's braid spacing apart, then moved to the middle of the part that is nearest to them. Immutable.
/// Where very many basis hairs crowd onto one spot, some of a region may be left out of it and braid by themselves.
class BraidLayout
{
public:
    BraidLayout() = default;
    /// kindOfBasis: [basis hairs], BraidKind.
    BraidLayout(const RootSet& roots, std::vector<std::uint8_t> kindOfBasis, float spacingM);

    /// Whether no hair is braided.
    [[nodiscard]] bool empty() const { return m_centres.empty(); }
    /// The nearest centre of the region around `slot`, as an index into basis hairs; kNoCentre where no neighbouring
    /// basis hair is of this kind.
    [[nodiscard]] std::uint32_t centreOf(const RootSet& roots, std::uint32_t slot, std::uint8_t kind) const;
    [[nodiscard]] std::span<const std::uint32_t> centres() const { return m_centres; }
    /// Pairs of basis hairs whose distance was looked at. For tests.
    [[nodiscard]] std::size_t compared() const { return m_compared; }

private:
    void findRegions(const RootSet& roots);
    void chooseCentres(const RootSet& roots, float spacingM);
    void moveCentresToTheMiddle(const RootSet& roots);
    [[nodiscard]] std::span<const std::uint32_t> centresOfRegion(std::uint32_t region) const
    {
        return std::span(m_centres).subspan(m_regionStart[region], m_regionStart[region + 1] - m_regionStart[region]);
    }

    std::vector<std::uint8_t> m_kindOfBasis;
    std::vector<std::uint32_t> m_regionOfBasis; ///< kNoCentre where there is no braid.
    std::vector<std::uint32_t> m_regionStart;   ///< [regions + 1], into m_centres.
    std::vector<std::uint32_t> m_centres;       ///< Indices of basis hairs.
    std::size_t m_compared = 0;
};

} // namespace hairpaint::sim
