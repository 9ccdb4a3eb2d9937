// How far a point is from the skin: by the grid of distances, or by the skin itself until there is one.
#pragma once

#include "sim/skin/skin.h"
#include "sim/skin/skin_field.h"

#include <memory>

namespace hairpaint::sim {

/// Immutable; any thread. Without a grid a look-up costs a search for the nearest face.
class SkinDistance
{
public:
    SkinDistance() = default;
    /// `grid` may be null.
    SkinDistance(std::shared_ptr<const Skin> skin, std::shared_ptr<const DistanceGrid> grid)
        : m_skin(std::move(skin)), m_grid(std::move(grid)), m_field(m_grid ? skinFieldOf(*m_grid) : SkinField{})
    {}

    [[nodiscard]] const std::shared_ptr<const Skin>& skin() const { return m_skin; }
    /// Without pairs where there is no grid.
    [[nodiscard]] const SkinField& field() const { return m_field; }
    /// (For lanes: pushedOut() of skin_distance_inl.h.) `point` itself where it is at least
    /// `clearanceM` from the skin, else moved out so far, to first order; from deep inside away from `centreHd`.
    static constexpr float kLeastSlope2 = 0.04F; ///< Square of the least slope by which a point is moved.
    static constexpr int kMostStrides = 8;       ///< Moves of a point that is deeper than distances are known.
    [[nodiscard]] glm::vec3 pushedOut(glm::vec3 point, float clearanceM, glm::vec3 centreHd) const;

private:
    std::shared_ptr<const Skin> m_skin;
    std::shared_ptr<const DistanceGrid> m_grid;
    SkinField m_field;
};

} // namespace hairpaint::sim
