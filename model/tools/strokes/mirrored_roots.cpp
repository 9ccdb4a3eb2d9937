// Roots in cells of space, so that few are compared.
#include "model/tools/strokes/mirrored_roots.h"

#include "sim/base/parallel.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hairpaint::model {

namespace {

constexpr float kNearM = 0.005F;
constexpr float kSpacings = 3.0F; ///< Where hair is sparse roots are that near, at most.
constexpr int kMostCells = 64;    ///< Along an axis.

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

/// Cells over all roots.
struct RootCells
{
    glm::vec3 least{std::numeric_limits<float>::max()};
    float nearM = kNearM;
    float cellM = kNearM; ///< nearM or more.
    glm::ivec3 count{1};
    std::vector<std::uint32_t> first; ///< [cells + 1], into slots.
    std::vector<std::uint32_t> slots;

    explicit RootCells(const sim::GroupFrame& hair)
    {
        const std::vector<glm::vec3>& positions = hair.groom->roots->positionHd;
        glm::vec3 greatest(std::numeric_limits<float>::lowest());
        float positioned = 1.0F;
        for (std::size_t slot = 0; slot < positions.size(); ++slot)
            if (hair.isPositioned(slot)) {
                least = glm::min(least, positions[slot]);
                greatest = glm::max(greatest, positions[slot]);
                positioned += 1.0F;
            }
        const glm::vec3 extent = glm::max(greatest - least, 0.0F);
        const float sideM = std::max({extent.x, extent.y, extent.z});
        nearM = std::max(kNearM, kSpacings * sideM / std::sqrt(positioned));
        cellM = std::max(nearM, sideM / static_cast<float>(kMostCells));
        count = glm::ivec3(extent / cellM) + 1;
        first.assign(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
                             static_cast<std::size_t>(count.z) +
                         1,
                     0);
        for (std::size_t slot = 0; slot < positions.size(); ++slot)
            if (hair.isPositioned(slot))
                ++first[index(cell(positions[slot])) + 1];
        std::partial_sum(first.begin(), first.end(), first.begin());
        slots.resize(first.back());
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (std::size_t slot = 0; slot < positions.size(); ++slot)
            if (hair.isPositioned(slot))
                slots[next[index(cell(positions[slot]))]++] = static_cast<std::uint32_t>(slot);
    }
    [[nodiscard]] glm::ivec3 cell(glm::vec3 positionHd) const
    {
        return glm::ivec3(glm::floor((positionHd - least) / cellM));
    }
    [[nodiscard]] std::size_t index(glm::ivec3 at) const
    {
        const glm::ivec3 inside = glm::clamp(at, glm::ivec3(0), count - 1);
        return (static_cast<std::size_t>(inside.z) * static_cast<std::size_t>(count.y) +
                static_cast<std::size_t>(inside.y)) *
                   static_cast<std::size_t>(count.x) +
               static_cast<std::size_t>(inside.x);
    }
};

/// By slot: the slot that it goes with, or kNone.
std::vector<std::uint32_t> nearestToReflections(const sim::GroupFrame& hair)
{
    const std::vector<glm::vec3>& positions = hair.groom->roots->positionHd;
    std::vector<std::uint32_t> mirrored(positions.size(), kNone);
    const RootCells cells(hair);
    sim::parallelFor(positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            if (!hair.isPositioned(slot))
                continue;
            const glm::vec3 reflected = positions[slot] * glm::vec3(-1.0F, 1.0F, 1.0F);
            const glm::ivec3 low = glm::max(cells.cell(reflected) - 1, glm::ivec3(0));
            const glm::ivec3 high = glm::min(cells.cell(reflected) + 1, cells.count - 1);
            float nearest = cells.nearM * cells.nearM;
            for (int z = low.z; z <= high.z; ++z)
                for (int y = low.y; y <= high.y; ++y)
                    for (int x = low.x; x <= high.x; ++x) {
                        const std::size_t cell = cells.index({x, y, z});
                        for (std::uint32_t i = cells.first[cell]; i < cells.first[cell + 1]; ++i) {
                            const glm::vec3 apart = positions[cells.slots[i]] - reflected;
                            const float square = glm::dot(apart, apart);
                            if (square < nearest) {
                                nearest = square;
                                mirrored[slot] = cells.slots[i];
                            }
                        }
                    }
        }
    });
    return mirrored;
}

} // namespace

MirroredRoots::MirroredRoots(const sim::GroupFrame& hair)
{
    const std::vector<std::uint32_t> nearest = nearestToReflections(hair);
    m_first.assign(nearest.size() + 1, 0);
    for (const std::uint32_t with : nearest)
        if (with != kNone)
            ++m_first[with + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_slots.resize(m_first.back());
    std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (std::uint32_t slot = 0; slot < nearest.size(); ++slot)
        if (nearest[slot] != kNone)
            m_slots[next[nearest[slot]]++] = slot;
}

} // namespace hairpaint::model
