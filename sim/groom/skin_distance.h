// How far a point is from the skin: by the grid of distances, or by the skin itself until there is one.
#pragma once

#include "sim/skin/distance_grid.h"
#include "sim/skin/skin.h"

#include <memory>

namespace hairpaint::sim {

/// Immutable; any thread. Without a grid a look-up costs a search for the nearest face.
class SkinDistance
{
public:
    SkinDistance() = default;
    /// `grid` may be null.
    SkinDistance(std::shared_ptr<const Skin> skin, std::shared_ptr<const DistanceGrid> grid)
        : m_skin(std::move(skin)), m_grid(std::move(grid))
    {}

    [[nodiscard]] const std::shared_ptr<const Skin>& skin() const { return m_skin; }
    [[nodiscard]] bool isOf(const std::shared_ptr<const Skin>& skin,
                            const std::shared_ptr<const DistanceGrid>& grid) const
    {
        return m_skin == skin && m_grid == grid;
    }
    /// `point` itself where it is at least `clearanceM` from the skin, else moved out so far, to first order; from deep
    /// inside away from `centreHd`.
    [[nodiscard]] glm::vec3 pushedOut(glm::vec3 point, float clearanceM, glm::vec3 centreHd) const;

private:
    std::shared_ptr<const Skin> m_skin;
    std::shared_ptr<const DistanceGrid> m_grid;
};

} // namespace hairpaint::sim
