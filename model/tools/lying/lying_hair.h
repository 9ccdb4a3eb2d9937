// How the hair that is drawn lies at its roots, told as a direction map tells it.
#pragma once

#include "model/values/progress.h"
#include "sim/motion/strand_frame.h"
#include "sim/skin/distance_grid.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hairpaint::model {

/// What keeps a hair as it lies.
enum class HeldBy : std::uint8_t
{
    Direction, ///< Gel, once it grows in the direction in which it lies.
    Gel,       ///< Gel alone: it lies as it grows.
    Weight     ///< It hangs, and gel would lift it.
};

/// One hair. `direction`: in the frame of its root, its length the cosine of the angle to the skin.
struct LyingHair
{
    glm::vec2 uv{0.0F};
    glm::vec2 direction{0.0F};
    HeldBy heldBy = HeldBy::Direction;
};

/// Every drawn hair of a group in that moment: the direction from the root to the point 2 cm along it, of hair shorter
/// than 6 cm a third along. Empty where the group is hidden. `atRest`: nothing moves, so that hair which does not lie
/// as it grows is held by its weight. About 10 ms for 100,000 hairs; any thread.
[[nodiscard]] std::vector<LyingHair> lyingHairs(const sim::GroupFrame& group, const sim::HeadPose& pose,
                                                bool atRest = false);

/// The same where hair lies on skin further on, as over the neck: of about `most` hairs of the group, for those nodes
/// that are close over the skin; about 15 ms for a thousand. `distances`: of that skin, which spares most nodes a
/// search; null where there are none. Uses parallelFor.
[[nodiscard]] std::vector<LyingHair> hairsFurtherOn(const sim::GroupFrame& group, const sim::HeadPose& pose,
                                                    const sim::DistanceGrid* distances, std::size_t most = 4000);

/// The direction of hair at every point near it: the mean of the nearest hairs, within a few millimetres where they are
/// dense, and more where they are sparse. Immutable.
class LyingField
{
public:
    static constexpr int kNearCells = 64; ///< Number of cells a side in which it is told where hair is near.

    /// `further`: hairsFurtherOn(), or none.
    explicit LyingField(std::span<const LyingHair> hairs, std::span<const LyingHair> further = {});

    /// None far from every hair, where nearness() is 0, too.
    [[nodiscard]] std::optional<glm::vec2> at(glm::vec2 uv) const;
    /// 1 where there is hair that is held by its direction, falling to 0 over 1/64 of the layout's side around it.
    [[nodiscard]] float nearness(glm::vec2 uv) const;
    /// The same for roots of hair that gel holds.
    [[nodiscard]] float nearnessOfRoots(glm::vec2 uv) const;

private:
    static constexpr int kCells = 512; ///< Number of cells a side.
    [[nodiscard]] static float softly(const std::vector<float>& cells, glm::vec2 uv);

    /// [kNearCells][kNearCells]: 1 where a hair, or a root, is in the cell or in one beside it, and few there hang.
    std::vector<float> m_near, m_nearRoots;
    std::vector<glm::vec3> m_cells; ///< Mean direction and mean length; a length below 0: no hair is near.
};

} // namespace hairpaint::model
