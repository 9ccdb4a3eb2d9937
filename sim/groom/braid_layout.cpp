// Regions by union of near basis hairs, centres by greedy spacing and a few steps of Lloyd's method.
#include "sim/groom/braid_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace hairpaint::sim {

namespace {

/// So many hairs of one kind in a cell of that size are compared with those around. On an even skin there are three;
/// where a mesh folds into thousands of layers, comparing all of them with all would never end.
constexpr std::size_t kMostCompared = 32;
constexpr float kLeastReachM = 1e-9F;     ///< Keeps cells apart from nothing where a skin has next to no area.
constexpr std::size_t kMostCentres = 256; ///< A region; bounds the time that a tiny spacing would take.
constexpr int kLloydSteps = 4;
constexpr std::size_t kBraidKinds = static_cast<std::size_t>(BraidKind::Loc) + 1;

float squaredDistance(glm::vec3 a, glm::vec3 b)
{
    const glm::vec3 away = a - b;
    return glm::dot(away, away);
}

/// Sets of basis hairs; a set is named by its lowest member.
class UnionOfHairs
{
public:
    explicit UnionOfHairs(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0U); }
    std::uint32_t find(std::uint32_t hair)
    {
        while (m_parent[hair] != hair) {
            m_parent[hair] = m_parent[m_parent[hair]];
            hair = m_parent[hair];
        }
        return hair;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        m_parent[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> m_parent;
};

/// Points sorted by the cell of a grid, for searches within the size of a cell.
class CellGrid
{
public:
    explicit CellGrid(float cellM) : m_cellM(cellM) {}
    void add(glm::vec3 position, std::uint32_t item) { m_items.emplace_back(keyOf(cellOf(position)), item); }
    void sort() { std::sort(m_items.begin(), m_items.end()); }
    /// Of each cell the first `most` items that are lower than `end`.
    template<typename Visit>
    void forEachNear(glm::vec3 position, std::uint32_t end, std::size_t most, const Visit& visit) const
    {
        const glm::ivec3 cell = cellOf(position);
        for (int z = -1; z <= 1; ++z) {
            for (int y = -1; y <= 1; ++y) {
                for (int x = -1; x <= 1; ++x) {
                    const std::uint64_t key = keyOf(cell + glm::ivec3(x, y, z));
                    auto at = std::lower_bound(m_items.begin(), m_items.end(), std::pair{key, 0U});
                    for (std::size_t visited = 0;
                         visited < most && at != m_items.end() && at->first == key && at->second < end; ++at, ++visited)
                        visit(at->second);
                }
            }
        }
    }

private:
    [[nodiscard]] glm::ivec3 cellOf(glm::vec3 position) const
    {
        return glm::ivec3(glm::clamp(glm::floor(position / m_cellM), -1e6F, 1e6F));
    }
    static std::uint64_t keyOf(glm::ivec3 cell)
    {
        constexpr std::uint64_t kBias = 1U << 20U;
        const auto part = [](int i) { return static_cast<std::uint64_t>(i) + kBias; };
        return (part(cell.z) << 42U) | (part(cell.y) << 21U) | part(cell.x);
    }

    float m_cellM;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> m_items;
};

} // namespace

BraidLayout::BraidLayout(const RootSet& roots, std::vector<std::uint8_t> kindOfBasis, float spacingM)
    : m_kindOfBasis(std::move(kindOfBasis))
{
    m_regionOfBasis.assign(m_kindOfBasis.size(), kNoCentre);
    if (std::all_of(m_kindOfBasis.begin(), m_kindOfBasis.end(), [](std::uint8_t kind) { return kind == 0; }))
        return;
    findRegions(roots);
    chooseCentres(roots, spacingM);
    moveCentresToTheMiddle(roots);
}

void BraidLayout::findRegions(const RootSet& roots)
{
    const auto count = static_cast<std::uint32_t>(m_kindOfBasis.size());
    const float reachM =
        std::max(kBraidReachSpacings * std::sqrt(static_cast<float>(roots.skin->areaM2()) / static_cast<float>(count)),
                 kLeastReachM);
    std::array<std::vector<std::uint32_t>, kBraidKinds> ofKind;
    for (std::uint32_t basis = 0; basis < count; ++basis)
        ofKind.at(m_kindOfBasis[basis]).push_back(basis);
    UnionOfHairs sets(count);
    for (std::size_t kind = 1; kind < ofKind.size(); ++kind) {
        CellGrid grid(reachM);
        for (const std::uint32_t basis : ofKind[kind])
            grid.add(roots.positionHd[roots.basisSlot[basis]], basis);
        grid.sort();
        for (const std::uint32_t basis : ofKind[kind]) {
            const std::uint32_t slot = roots.basisSlot[basis];
            grid.forEachNear(roots.positionHd[slot], basis, kMostCompared, [&](std::uint32_t other) {
                const std::uint32_t otherSlot = roots.basisSlot[other];
                ++m_compared;
                if (squaredDistance(roots.positionHd[slot], roots.positionHd[otherSlot]) <= reachM * reachM &&
                    glm::dot(roots.normalHd[slot], roots.normalHd[otherSlot]) > 0.0F)
                    sets.join(basis, other);
            });
        }
    }
    std::vector<std::uint32_t> numberOfSet(count, kNoCentre);
    std::uint32_t regions = 0;
    for (std::uint32_t basis = 0; basis < count; ++basis) {
        if (m_kindOfBasis[basis] == 0)
            continue;
        std::uint32_t& number = numberOfSet[sets.find(basis)];
        if (number == kNoCentre)
            number = regions++;
        m_regionOfBasis[basis] = number;
    }
    m_regionStart.assign(regions + 1, 0);
}

void BraidLayout::chooseCentres(const RootSet& roots, float spacingM)
{
    // In the order of ranks, each prefix of which is an even cover.
    std::vector<std::vector<std::uint32_t>> chosen(m_regionStart.size() - 1);
    for (std::uint32_t rank = 0; rank < m_kindOfBasis.size(); ++rank) {
        const std::uint32_t slot = roots.slotOfRank[rank];
        const std::uint32_t basis = roots.neighbours[slot][0];
        if (m_regionOfBasis[basis] == kNoCentre)
            continue;
        std::vector<std::uint32_t>& centres = chosen[m_regionOfBasis[basis]];
        const bool isFar = std::all_of(centres.begin(), centres.end(), [&](std::uint32_t centre) {
            return squaredDistance(roots.positionHd[roots.basisSlot[centre]], roots.positionHd[slot]) >=
                   spacingM * spacingM;
        });
        if (isFar && centres.size() < kMostCentres)
            centres.push_back(basis);
    }
    for (std::size_t region = 0; region < chosen.size(); ++region) {
        m_centres.insert(m_centres.end(), chosen[region].begin(), chosen[region].end());
        m_regionStart[region + 1] = static_cast<std::uint32_t>(m_centres.size());
    }
}

void BraidLayout::moveCentresToTheMiddle(const RootSet& roots)
{
    constexpr float kFar = std::numeric_limits<float>::max();
    const auto positionOf = [&](std::uint32_t basis) { return roots.positionHd[roots.basisSlot[basis]]; };
    const auto count = static_cast<std::uint32_t>(m_kindOfBasis.size());
    std::vector<std::uint32_t> cellOf(count, 0);
    for (int step = 0; step < kLloydSteps; ++step) {
        std::vector<glm::vec3> sums(m_centres.size(), glm::vec3(0.0F));
        std::vector<float> members(m_centres.size(), 0.0F);
        for (std::uint32_t basis = 0; basis < count; ++basis) {
            const std::uint32_t region = m_regionOfBasis[basis];
            if (region == kNoCentre)
                continue;
            float nearest = kFar;
            for (std::uint32_t i = m_regionStart[region]; i < m_regionStart[region + 1]; ++i) {
                const float squared = squaredDistance(positionOf(m_centres[i]), positionOf(basis));
                if (squared < nearest) {
                    nearest = squared;
                    cellOf[basis] = i;
                }
            }
            sums[cellOf[basis]] += positionOf(basis);
            members[cellOf[basis]] += 1.0F;
        }
        std::vector<float> nearest(m_centres.size(), kFar);
        std::vector<std::uint32_t> moved = m_centres;
        for (std::uint32_t basis = 0; basis < count; ++basis) {
            if (m_regionOfBasis[basis] == kNoCentre)
                continue;
            const std::uint32_t cell = cellOf[basis];
            const float squared = squaredDistance(sums[cell] / members[cell], positionOf(basis));
            if (squared < nearest[cell]) {
                nearest[cell] = squared;
                moved[cell] = basis;
            }
        }
        m_centres = std::move(moved);
    }
}

std::uint32_t BraidLayout::centreOf(const RootSet& roots, std::uint32_t slot, std::uint8_t kind) const
{
    if (kind == 0 || m_centres.empty())
        return kNoCentre;
    for (const std::uint32_t neighbour : roots.neighbours[slot]) {
        if (m_kindOfBasis[neighbour] != kind)
            continue;
        std::uint32_t best = kNoCentre;
        float nearest = std::numeric_limits<float>::max();
        for (const std::uint32_t centre : centresOfRegion(m_regionOfBasis[neighbour])) {
            const float squared = squaredDistance(roots.positionHd[roots.basisSlot[centre]], roots.positionHd[slot]);
            if (squared < nearest) {
                nearest = squared;
                best = centre;
            }
        }
        return best;
    }
    return kNoCentre;
}

} // namespace hairpaint::sim
