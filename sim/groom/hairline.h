// The edge of painted hair: how deep inside of it each root is. There hair is thinner, shorter and finer, however hard
// the edge was painted. Only an edge to bare skin counts, not one between dense hair and less dense.
#pragma once

#include "sim/groom/map_sampler.h"
#include "sim/groom/roots.h"
#include "sim/groom/slot_set.h"
#include "sim/groom/variation.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace hairpaint::sim {

/// The even cover that the first of the ranks make of the skin is its measure: where their density is nothing, skin is
/// bare, and a root's depth follows from the nearest of those. So it needs neither the layout's neighbourhoods nor the
/// mesh's, and a dab changes the roots around it alone. One thread writes; any number read between.
class Hairline
{
public:
    /// At a width of 0 it is off: it holds nothing and takes no time.
    void startOver(const std::shared_ptr<const RootSet>& roots, const HairlineSettings& settings);
    [[nodiscard]] bool isOff() const { return m_depth.empty(); }

    /// Reads the density of roots of `dirty` again, and adds those that are as deep no longer. Uses parallelFor.
    void update(const MapSampler& density, SlotSet& dirty);

    /// Of the map.
    [[nodiscard]] float density(std::uint32_t slot) const { return m_density[slot]; }
    /// 0 at the edge, 1 from `softenM` on, more or less, and where there is no hair.
    [[nodiscard]] float depth(std::uint32_t slot) const { return m_depth[slot]; }

private:
    void makeCells();
    [[nodiscard]] std::size_t cellOf(glm::vec3 positionHd) const;
    /// Brings what is bare up to date; marks the cells in whose reach that differs.
    void readBare(const SlotSet& dirty, std::vector<std::uint8_t>& differs);
    /// `change` of all cells that touch one.
    template<typename Change>
    void aroundCell(std::size_t cell, const Change& change) const;
    [[nodiscard]] float depthAt(std::uint32_t slot) const;

    std::shared_ptr<const RootSet> m_roots;
    float m_softenM = 0.0F;
    float m_uneven = 0.0F;
    float m_spacingM = 0.0F; ///< Of the probes.
    glm::vec3 m_originHd{0.0F};
    float m_perCell = 0.0F;                 ///< 1/m; a cell is as large as the reach of an edge.
    glm::u64vec3 m_size{0};                 ///< In cells, with one to spare on each side.
    std::vector<std::uint32_t> m_cell;      ///< [slots]
    std::vector<float> m_density;           ///< [slots]
    std::vector<float> m_depth;             ///< [slots]
    std::vector<std::uint32_t> m_first;     ///< [cells + 1]: the probes in each,
    std::vector<std::uint32_t> m_probe;     ///< their slots,
    std::vector<std::uint8_t> m_isBare;     ///< and whether hair does not grow there.
    std::vector<std::uint32_t> m_bare;      ///< Slots of those of a cell that are, from its m_first on,
    std::vector<glm::vec3> m_bareHd;        ///< and where they are.
    std::vector<std::uint32_t> m_bareIn;    ///< [cells]: number of those that are bare.
    std::vector<std::uint8_t> m_bareAround; ///< [cells]: number of cells with such, of itself and those that touch it.
};

/// Part of the density that is left at a depth.
[[nodiscard]] float densityAtDepth(float depth);
/// What chance and the hairline make of a hair that its map and curl give `lengthM`.
[[nodiscard]] HairVariation variationAt(const GroupSettings& settings, const RootSet& roots, const Hairline& hairline,
                                        std::uint32_t slot, float lengthM);
/// Makes a hair at a depth shorter and finer, and some of them baby hairs. Nothing at 1.
void thinAtDepth(float baby, float depth, std::uint64_t seed, std::uint32_t rank, HairVariation& own);

} // namespace hairpaint::sim
