// The edge of painted hair: how deep inside of it each root is. There hair is thinner, shorter and finer, however hard
// the edge was painted. Only an edge to bare skin counts, not one between dense hair and less dense, and not the gap of
// a part, which has hair on both sides.
#pragma once

#include "sim/groom/map_slot.h"
#include "sim/groom/roots.h"
#include "sim/groom/slot_set.h"
#include "sim/groom/variation.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace hairpaint::sim {

/// The roots of the first ranks, which cover the skin evenly, are its probes: where a probe's density is next to 0 the
/// skin is bare, and where enough of the probes around it are bare too it is open. A root's depth follows from its
/// distance to the nearest open probe. So it needs no neighbourhoods of the layout or the mesh, and a dab changes only
/// the roots around it. One thread writes; any number read between.
class Hairline
{
public:
    /// At a width of 0 it is off: it holds nothing and takes no time.
    void startOver(const std::shared_ptr<const RootSet>& roots, const HairlineSettings& settings);
    [[nodiscard]] bool isOff() const { return m_depth.empty(); }

    /// Reads the density of the roots in `dirty` again where the map's texels are others than the last time, and adds
    /// the roots whose depth changes. Uses parallelFor.
    void update(const MapRaster& density, SlotSet& dirty);

    /// The density map's value at the root, 0..1.
    [[nodiscard]] float density(std::uint32_t slot) const { return m_density[slot]; }
    /// 0 at the edge, 1 from about `softenM` inside it on, and where there is no hair.
    [[nodiscard]] float depth(std::uint32_t slot) const { return m_depth[slot]; }

private:
    void makeCells();
    [[nodiscard]] std::size_t cellOf(glm::vec3 positionHd) const;
    /// Updates which probes are bare, of the roots whose density differs; marks the cells that touch a cell where that
    /// differs.
    void readBare(const SlotSet& otherDensity, std::vector<std::uint8_t>& differs);
    /// Updates which probes of the cells marked in `bareDiffers` are open; marks the cells that touch a cell where that
    /// differs. Uses parallelFor.
    void findOpen(const std::vector<std::uint8_t>& bareDiffers, std::vector<std::uint8_t>& differs);
    [[nodiscard]] bool isOpen(std::size_t cell, std::uint32_t probe) const;
    /// Calls `change` with a cell and with all cells that touch it.
    template<typename Change>
    void aroundCell(std::size_t cell, const Change& change) const;
    [[nodiscard]] float depthAt(std::uint32_t slot) const;

    std::shared_ptr<const RootSet> m_roots;
    MapRaster m_map; ///< Which m_density was read from; null before.
    float m_softenM = 0.0F;
    float m_uneven = 0.0F;
    float m_spacingM = 0.0F; ///< Mean distance of neighbouring probes.
    glm::vec3 m_originHd{0.0F};
    float m_perCell = 0.0F;              ///< 1/m; a cell is as large as the reach of an edge.
    glm::u64vec3 m_size{0};              ///< Cells along each axis, with a spare one on each side.
    std::vector<std::uint32_t> m_cell;   ///< [slots]
    std::vector<float> m_density;        ///< [slots]
    std::vector<float> m_depth;          ///< [slots]
    std::vector<std::uint32_t> m_first;  ///< [cells + 1] where each cell's probes begin in the arrays by probe.
    std::vector<std::uint32_t> m_probe;  ///< [probes] slots, cell by cell.
    std::vector<std::uint8_t> m_isBare;  ///< [probes] 1 where no hair grows.
    std::vector<std::uint8_t> m_isOpen;  ///< [probes] 1 where the skin around is bare too.
    std::vector<std::uint32_t> m_open;   ///< [probes] slots of a cell's open probes, from its m_first on.
    std::vector<glm::vec3> m_openHd;     ///< [probes] and their positions.
    std::vector<std::uint32_t> m_openIn; ///< [cells] number of open probes.
    /// [cells] number of cells with open probes among it and those that touch it.
    std::vector<std::uint8_t> m_openAround;
};

/// Fraction of the density that is left at a depth.
[[nodiscard]] float densityAtDepth(float depth);
/// What chance and the hairline make of a hair that its map and curl give `lengthM`.
[[nodiscard]] HairVariation variationAt(const GroupSettings& settings, const RootSet& roots, const Hairline& hairline,
                                        std::uint32_t slot, float lengthM);
/// Makes a hair at a depth shorter and finer, and some of them baby hairs. Nothing at 1.
void thinAtDepth(float baby, float depth, std::uint64_t seed, std::uint32_t rank, HairVariation& own);

} // namespace hairpaint::sim
