// Probes in cells as large as an edge's reach, so that the bare ones near a root are in the cells that touch its own.
#include "sim/groom/hairline.h"

#include "sim/base/deterministic.h"
#include "sim/base/parallel.h"
#include "sim/groom/map_sampler.h"
#include "sim/groom/tile_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace hairpaint::sim {

namespace {

constexpr std::uint64_t kHairlineKey = 0x656467650A75u; ///< Apart from the keys of other uses of the seed.
constexpr float kBareBelow = 0.01F;                     ///< Density below which the skin at a probe counts as bare.
constexpr float kNotRead = -1.0F;                       ///< A density before the map was read.
constexpr float kProbesApart = 0.4F; ///< Distance of probes over the softened width; they are no closer than roots.
constexpr float kWavers = 0.4F;      ///< Greatest fraction by which that width wavers.
constexpr float kRecedes = 0.3F;     ///< Greatest distance by which the edge lies further inside, over that width.
/// The same, added where the edge is fully uneven; it comes back over some 4 cm.
constexpr float kRecedesUneven = 1.3F;
constexpr float kCoarser = 0.55F;
constexpr float kUnevenPhase = 5.3F;
constexpr float kPhase = 4.4F;
constexpr float kEdgePhase = 1.9F;
constexpr float kFiner = 2.0F; ///< Factor by which the edge wavers faster than the width.
constexpr float kMostLineCellsAcross = 96.0F;
constexpr std::size_t kChunksAtOnce = 4;

/// Order in which three cells in a row are searched: the middle one first, so that the others can most often be
/// skipped.
constexpr std::array<std::size_t, 3> kNearFirst{1, 0, 2};

/// A bare probe is open where more than this share of the probes so many of their spacings around it is bare: half of
/// them are along an edge, a sixth in the gap of a part.
constexpr float kOpenShare = 0.42F;
constexpr float kOpenReach = 2.5F;
constexpr std::size_t kCellsAtOnce = 16;

/// Distance from an open probe to the edge, over the probes' spacing: the edge lies about halfway between probes.
constexpr float kBetweenProbes = 0.4F;

bool sameTexels(const TiledRaster& before, const TiledRaster& after)
{
    const std::optional<std::vector<TexelRect>> footprints = footprintsThatDiffer(before, after);
    return footprints && footprints->empty();
}

} // namespace

void Hairline::startOver(const std::shared_ptr<const RootSet>& roots, const HairlineSettings& settings)
{
    if (!(settings.softenM > 0.0F)) {
        *this = Hairline();
        return;
    }
    if (roots == m_roots && settings.softenM == m_softenM && settings.uneven == m_uneven)
        return;
    m_roots = roots;
    m_softenM = settings.softenM;
    m_uneven = settings.uneven;
    makeCells();
    m_map.reset();
    m_density.assign(roots->count(), kNotRead);
    m_depth.assign(roots->count(), 1.0F);
}

void Hairline::makeCells()
{
    const RootSet& roots = *m_roots;
    m_spacingM = kProbesApart * m_softenM;
    const double wanted = roots.skin->areaM2() / (static_cast<double>(m_spacingM) * static_cast<double>(m_spacingM));
    const auto probes = static_cast<std::size_t>(std::min(wanted, static_cast<double>(roots.count())));
    m_spacingM =
        std::sqrt(static_cast<float>(roots.skin->areaM2() / static_cast<double>(std::max<std::size_t>(probes, 1))));

    glm::vec3 least(std::numeric_limits<float>::max());
    glm::vec3 most(-std::numeric_limits<float>::max());
    for (const glm::vec3& positionHd : roots.positionHd) {
        least = glm::min(least, positionHd);
        most = glm::max(most, positionHd);
    }
    const glm::vec3 extent = roots.count() > 0 ? most - least : glm::vec3(0.0F);
    const float reachM =
        m_softenM * (1.0F + kWavers + kRecedes + kRecedesUneven * m_uneven) + kBetweenProbes * m_spacingM;
    const float cellM = std::max(reachM, std::max({extent.x, extent.y, extent.z}) / kMostLineCellsAcross);
    m_perCell = 1.0F / cellM;
    m_originHd = least - 1.5F * cellM; // Positions stay inside the grid however their cells are rounded.
    m_size = glm::u64vec3(extent * m_perCell) + glm::u64vec3(4);

    m_cell.resize(roots.count());
    parallelFor(roots.count(), kChunkSlots, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin; slot < end; ++slot)
            m_cell[slot] = static_cast<std::uint32_t>(cellOf(roots.positionHd[slot]));
    });
    // Counted, summed up, filled in.
    const std::size_t cells = m_size.x * m_size.y * m_size.z;
    m_first.assign(cells + 1, 0);
    for (std::size_t rank = 0; rank < probes; ++rank)
        ++m_first[m_cell[roots.slotOfRank[rank]] + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_probe.resize(probes);
    m_open.resize(probes);
    m_openHd.resize(probes);
    std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t rank = 0; rank < probes; ++rank) {
        const std::uint32_t slot = roots.slotOfRank[rank];
        m_probe[next[m_cell[slot]]++] = slot;
    }
    m_isBare.assign(probes, 0);
    m_isOpen.assign(probes, 0);
    m_openIn.assign(cells, 0);
    m_openAround.assign(cells, 0);
}

std::size_t Hairline::cellOf(glm::vec3 positionHd) const
{
    const glm::u64vec3 at((positionHd - m_originHd) * m_perCell);
    return (at.z * m_size.y + at.y) * m_size.x + at.x;
}

template<typename Change>
void Hairline::aroundCell(std::size_t cell, const Change& change) const
{
    const std::size_t layer = m_size.x * m_size.y;
    for (std::size_t z = 0; z < 3; ++z)
        for (std::size_t y = 0; y < 3; ++y)
            for (std::size_t x = 0; x < 3; ++x)
                change(cell + z * layer + y * m_size.x + x - layer - m_size.x - 1);
}

void Hairline::readBare(const SlotSet& otherDensity, std::vector<std::uint8_t>& differs)
{
    for (std::size_t cell = 0; cell + 1 < m_first.size(); ++cell) {
        bool any = false;
        for (std::uint32_t probe = m_first[cell]; probe < m_first[cell + 1]; ++probe) {
            if (!otherDensity.contains(m_probe[probe]))
                continue;
            const std::uint8_t isBare = m_density[m_probe[probe]] < kBareBelow ? 1 : 0;
            any |= isBare != m_isBare[probe];
            m_isBare[probe] = isBare;
        }
        if (any)
            aroundCell(cell, [&](std::size_t around) { differs[around] = 1; });
    }
}

bool Hairline::isOpen(std::size_t cell, std::uint32_t probe) const
{
    const RootSet& roots = *m_roots;
    const glm::vec3 centreHd = roots.positionHd[m_probe[probe]];
    const glm::vec3 normalHd = roots.normalHd[m_probe[probe]];
    const float reachM = std::min(kOpenReach * m_spacingM, 1.0F / m_perCell);
    std::size_t bare = 0;
    std::size_t all = 0;
    aroundCell(cell, [&](std::size_t around) {
        for (std::uint32_t other = m_first[around]; other < m_first[around + 1]; ++other) {
            const glm::vec3 apart = roots.positionHd[m_probe[other]] - centreHd;
            if (glm::dot(apart, apart) > reachM * reachM ||
                !(glm::dot(roots.normalHd[m_probe[other]], normalHd) > 0.0F))
                continue;
            ++all;
            bare += m_isBare[other];
        }
    });
    return static_cast<float>(bare) > kOpenShare * static_cast<float>(all);
}

void Hairline::findOpen(const std::vector<std::uint8_t>& bareDiffers, std::vector<std::uint8_t>& differs)
{
    std::vector<std::uint8_t> openDiffers(bareDiffers.size(), 0);
    parallelFor(bareDiffers.size(), kCellsAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
            if (bareDiffers[cell] == 0)
                continue;
            for (std::uint32_t probe = m_first[cell]; probe < m_first[cell + 1]; ++probe) {
                const std::uint8_t open = m_isBare[probe] != 0 && isOpen(cell, probe) ? 1 : 0;
                if (open != m_isOpen[probe])
                    openDiffers[cell] = 1;
                m_isOpen[probe] = open;
            }
        }
    });
    for (std::size_t cell = 0; cell < openDiffers.size(); ++cell) {
        if (openDiffers[cell] == 0)
            continue;
        const std::uint32_t before = m_openIn[cell];
        m_openIn[cell] = 0;
        for (std::uint32_t probe = m_first[cell]; probe < m_first[cell + 1]; ++probe)
            if (m_isOpen[probe] != 0) {
                const std::uint32_t to = m_first[cell] + m_openIn[cell]++;
                m_open[to] = m_probe[probe];
                m_openHd[to] = m_roots->positionHd[m_probe[probe]];
            }
        const int more = (m_openIn[cell] != 0 ? 1 : 0) - (before != 0 ? 1 : 0);
        aroundCell(cell, [&](std::size_t around) {
            m_openAround[around] = static_cast<std::uint8_t>(m_openAround[around] + more);
            differs[around] = 1;
        });
    }
}

void Hairline::update(const MapRaster& density, SlotSet& dirty)
{
    if (isOff() || dirty.empty() || density == m_map)
        return;
    const MapRaster before = std::exchange(m_map, density);
    if (before && sameTexels(*before, *density))
        return;
    const MapSampler sampler(density);
    SlotSet otherDensity(m_density.size());
    parallelFor(dirty.chunkCount(), kChunksAtOnce, [&](std::size_t begin, std::size_t end) {
        for (std::size_t chunk = begin; chunk < end; ++chunk)
            dirty.forEachInChunk(chunk, [&](std::uint32_t slot) {
                const float value = sampler.scalar(m_roots->uv[slot]);
                if (value == m_density[slot])
                    return;
                m_density[slot] = value;
                otherDensity.insert(slot);
            });
    });
    std::vector<std::uint8_t> bareDiffers(m_openIn.size(), 0);
    readBare(otherDensity, bareDiffers);
    std::vector<std::uint8_t> differs(m_openIn.size(), 0);
    findOpen(bareDiffers, differs);
    parallelFor(dirty.chunkCount(), kChunksAtOnce, [&](std::size_t begin, std::size_t end) {
        const std::size_t last = std::min(end * kChunkSlots, m_depth.size());
        for (std::size_t i = begin * kChunkSlots; i < last; ++i) {
            const auto slot = static_cast<std::uint32_t>(i);
            if (differs[m_cell[slot]] == 0 && !otherDensity.contains(slot))
                continue;
            const float depth = depthAt(slot);
            if (depth != m_depth[slot])
                dirty.insert(slot);
            m_depth[slot] = depth;
        }
    });
}

float Hairline::depthAt(std::uint32_t slot) const
{
    const RootSet& roots = *m_roots;
    const std::size_t cell = m_cell[slot];
    if (m_openAround[cell] == 0 || !(roots.threshold(slot) < m_density[slot]))
        return 1.0F;
    const glm::vec3 rootHd = roots.positionHd[slot];
    const glm::vec3 normalHd = roots.normalHd[slot];
    const float widthM = m_softenM * (1.0F + kWavers * wavering(rootHd, kPhase));
    float insetM =
        kBetweenProbes * m_spacingM + m_softenM * kRecedes * std::max(wavering(rootHd * kFiner, kEdgePhase), 0.0F);
    if (m_uneven > 0.0F)
        insetM += m_softenM * kRecedesUneven * m_uneven * (0.5F + 0.5F * wavering(rootHd * kCoarser, kUnevenPhase));
    const float mostM2 = (widthM + insetM) * (widthM + insetM);
    float least = mostM2;
    // How far the cells before, the same and those after it are, on each axis.
    const float cellM = 1.0F / m_perCell;
    const glm::vec3 inCells = (rootHd - m_originHd) * m_perCell;
    const glm::vec3 beforeM = (inCells - glm::floor(inCells)) * cellM;
    const std::array<glm::vec3, 3> awayM{beforeM, glm::vec3(0.0F), cellM - beforeM};
    const std::size_t layer = m_size.x * m_size.y;
    for (const std::size_t z : kNearFirst)
        for (const std::size_t y : kNearFirst)
            for (const std::size_t x : kNearFirst) {
                const std::size_t other = cell + z * layer + y * m_size.x + x - layer - m_size.x - 1;
                const glm::vec3 away(awayM[x].x, awayM[y].y, awayM[z].z);
                if (m_openIn[other] == 0 || glm::dot(away, away) >= least)
                    continue;
                for (std::uint32_t i = m_first[other]; i < m_first[other] + m_openIn[other]; ++i) {
                    const glm::vec3 apart = m_openHd[i] - rootHd;
                    const float squared = glm::dot(apart, apart);
                    // Probes on the other side of an ear do not count.
                    if (squared < least && glm::dot(roots.normalHd[m_open[i]], normalHd) > 0.0F)
                        least = squared;
                }
            }
    return least == mostM2 ? 1.0F : std::clamp((std::sqrt(least) - insetM) / widthM, 0.0F, 1.0F);
}

float densityAtDepth(float depth)
{
    constexpr float kAtEdge = 0.1F;
    return kAtEdge + (1.0F - kAtEdge) * depth * (2.0F - depth);
}

HairVariation variationAt(const GroupSettings& settings, const RootSet& roots, const Hairline& hairline,
                          std::uint32_t slot, float lengthM)
{
    const std::uint32_t rank = roots.rankOfSlot[slot];
    HairVariation own = variationOf(settings.variation, roots.seed, rank);
    own.length = lengthLeft(settings.variation, own.length, lengthM, roots.positionHd[slot]);
    if (!hairline.isOff())
        thinAtDepth(settings.hairline.baby, hairline.depth(slot), roots.seed, rank, own);
    return own;
}

void thinAtDepth(float baby, float depth, std::uint64_t seed, std::uint32_t rank, HairVariation& own)
{
    if (depth >= 1.0F)
        return;
    constexpr float kShortest = 0.35F; // Least and greatest fraction of its length that a hair at the edge keeps,
    constexpr float kLongest = 0.85F;
    constexpr float kFinest = 0.5F; // and of its width.
    constexpr float kWidest = 0.8F;
    const std::uint64_t key = hash64(seed ^ kHairlineKey, rank);
    const std::uint64_t chances = hash64(key, 1);
    const float out = (1.0F - depth) * (1.0F - depth);
    own.length *= 1.0F - out * (1.0F - (kShortest + (kLongest - kShortest) * unitFloat(key)));
    own.width *= 1.0F - (1.0F - depth) * (1.0F - (kFinest + (kWidest - kFinest) * unitFloat(key << 32U)));
    if (!(unitFloat(chances) < baby * out))
        return;
    constexpr float kLeastM = 0.006F;
    constexpr float kMostM = 0.02F;
    constexpr float kFine = 0.75F;
    constexpr float kAcrossRad = 0.7F;
    constexpr float kLiftRad = 0.25F;
    const std::uint64_t more = hash64(key, 2);
    own.babyM = kLeastM + (kMostM - kLeastM) * unitFloat(chances << 32U);
    own.width *= kFine;
    own.acrossRad += kAcrossRad * (2.0F * unitFloat(more) - 1.0F);
    own.liftRad += kLiftRad * unitFloat(more << 32U);
    own.isFlyaway = true;
}

} // namespace hairpaint::sim
