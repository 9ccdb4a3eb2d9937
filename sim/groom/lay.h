// How a hair lies without gravity: along the painted direction over the head, then free.
#pragma once

#include "sim/groom/lay_field.h"
#include "sim/groom/map_sampler.h"
#include "sim/skin/skin_frame.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace hairpaint::sim {

/// A hair's root as the lay sees it.
struct LayRoot
{
    glm::vec3 positionHd{0.0F};
    SkinFrame frame;
    glm::vec2 uv{0.0F};
    float chance = 0.5F; ///< 0..1, the hair's own: its height in the coat.
};

/// Whether a direction map lets every hair stand along its normal.
[[nodiscard]] bool isUpright(const MapSampler& direction);

/// Lays hairs by one group's direction map. Immutable; any thread. Must not outlive what it is made from.
class Lay
{
public:
    /// A hair lies along the head no further than this, m.
    static constexpr float kFurthestM = 0.16F;

    /// `natural`: the head's stream, null where it has none. `field`: of that map; null where isUpright(direction).
    /// `coatM`: thickness of the coat.
    Lay(const MapSampler& direction, const MapSampler* natural, const LayField* field, float coatM)
        : m_direction(direction), m_natural(natural), m_field(field), m_coatM(coatM)
    {}

    /// The skeleton of a hair of `lengthM`: nodes evenly spaced, root first. A direction of zero length gives a
    /// straight line along the normal. `passed` gets the cells of the field, by index, that this depends on beside the
    /// root's own direction, and kNone behind them; mostPassed() of them, or none where nobody asks.
    void lay(const LayRoot& root, float lengthM, std::span<glm::vec3> nodesHd,
             std::span<std::uint32_t> passed = {}) const;

    /// The most cells that a hair passes.
    [[nodiscard]] static std::size_t mostPassed(int nodes);

private:
    [[nodiscard]] Growth growthAt(const LayRoot& root, float falls) const;

    const MapSampler& m_direction;
    const MapSampler* m_natural;
    const LayField* m_field;
    float m_coatM;
};

} // namespace hairpaint::sim
