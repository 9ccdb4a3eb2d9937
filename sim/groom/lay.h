// How hairs lie by themselves: along the painted direction over the head, then free, long ones hanging.
#pragma once

#include "sim/groom/group_settings.h"
#include "sim/groom/lay_field.h"
#include "sim/groom/map_sampler.h"
#include "sim/skin/skin_frame.h"

#include <array>
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
    /// Offset from the root to the point whose direction it takes, see strayOf(); 0 for hair that may not cross a
    /// parting or a whorl.
    glm::vec3 strayHd{0.0F};
    float liftM = 0.0F; ///< Height added to that in the coat: the room below a coil's middle.
};

/// Whether a direction map lets every hair stand along its normal.
[[nodiscard]] bool isUpright(const MapSampler& direction);

/// What the hairs of one group are laid by.
struct LayInputs
{
    const MapSampler& direction;
    const MapSampler* natural = nullptr; ///< The head's stream; null where it has none.
    const LayField* field = nullptr;     ///< The field of `direction`; null where isUpright(direction).
    float coatM = 0.0F;                  ///< Thickness of the coat.
    float coatRiseM = 0.0F;              ///< Length along which the coat rises; see PhysicsSettings::volumeRiseM.
    float partGapM = 0.0F;               ///< See VariationSettings::partGapM; 0 for hairs that are solved.
    float partWaversM = 0.0F;            ///< Greatest distance by which the line of a parting wavers.
};

/// Lays up to kLanes hairs at once. How one lies does not depend on the others. One thread; must not outlive its
/// inputs.
class Lay
{
public:
    Lay(const LayInputs& inputs, int nodes) : m_inputs(inputs), m_nodes(nodes) {}

    void clear() { m_count = 0; }
    [[nodiscard]] bool isFull() const { return m_count == kLanes; }
    /// Must not be full. False where a parting bares the skin: the hair is laid as one without length.
    [[nodiscard]] bool add(const LayRoot& root, float lengthM);
    void lay(); ///< Lays all hairs added since clear().

    /// The skeletons in the order in which they were added, nodes evenly spaced: [nodes][3][kLanes], Hd. A direction of
    /// zero length gives a straight line along the normal. Whoever laid them may draw them on.
    [[nodiscard]] std::span<float> nodesHd() { return std::span(m_nodesHd).first(StrandBlocks(m_nodes).blockFloats()); }
    void read(std::size_t hair, std::span<glm::vec3> nodesHd) const
    {
        StrandBlocks(m_nodes).read(m_nodesHd, hair, nodesHd);
    }
    /// The field's cells that it depends on, beside its root's own direction; SkinBand::kNone behind them.
    [[nodiscard]] std::span<const std::int32_t> passed(std::size_t hair) const;

    /// How far from a root the field tells whether a parting bares it.
    [[nodiscard]] static float partingReachM(float partWaversM);

    /// The length of passed().
    [[nodiscard]] static std::size_t mostPassed(int nodes);

private:
    static constexpr std::size_t kMostPassed = 32;

    /// Replaces an upright hair's nodes by those of straightRest(), so that they agree with it to the last bit.
    void straighten(std::size_t hair);
    /// The direction of a hair that strays: that at root + strayHd where a parting lies between, else `growth`. Notes
    /// the cell that it depends on in m_strayedTo. There must be a field.
    [[nodiscard]] glm::vec3 strayed(const LayRoot& root, float falls, glm::vec3 growth);

    /// Whether a root whose hair grows along `growth` is on the line that a parting bares.
    [[nodiscard]] bool isBare(const LayRoot& root, float falls, glm::vec3 growth, float gapM) const;

    LayInputs m_inputs;
    int m_nodes;
    std::size_t m_count = 0;
    LayLanes m_lanes;
    std::array<bool, kLanes> m_isUpright{};
    std::array<std::int32_t, kLanes> m_strayedTo{};                                   ///< Cell, or SkinBand::kNone.
    std::array<float, std::size_t{kMostNodes} * StrandBlocks::kNodeStride> m_nodesHd; ///< Written where read.
    std::array<std::int32_t, std::size_t{kLanes} * kMostPassed> m_passed;
};

} // namespace hairpaint::sim
