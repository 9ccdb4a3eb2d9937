// The signed distance to a head's skin, on a grid.
#pragma once

#include "sim/skin/head_mesh.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::sim {

/// Hd. Nodes lie at originHd + cellM * (x, y, z), 0 <= x < size.x and so on.
struct GridLayout
{
    glm::vec3 originHd{0.0F};
    float cellM = 0.0F;
    glm::ivec3 size{0};
    [[nodiscard]] std::size_t nodeCount() const
    {
        return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
    }
    friend bool operator==(const GridLayout&, const GridLayout&) = default;
};

/// Immutable; any thread.
class DistanceGrid
{
public:
    static constexpr float kUnitM = 0.0002F;          ///< Length of one unit of a stored value.
    static constexpr float kReachM = 127.0F * kUnitM; ///< Distances are cut off there, on both sides.
    static constexpr float kCellM = 0.003F;
    static constexpr std::size_t kMostNodes = 8'000'000;   ///< Larger heads get larger cells;
    static constexpr float kLargestCellM = kReachM / 3.0F; ///< those for which these are too large get no grid.
    /// Around all of the mesh, whose openings are taken as closed; negative inside. Right to half a unit at
    /// nodes within two cells of the skin, to a tenth of a cell further away. Takes about a second for a head, on
    /// several threads; null where `goesOn`, told how far it is (0..1), returns false, and for meshes of several
    /// metres.
    [[nodiscard]] static std::shared_ptr<const DistanceGrid> make(const HeadMesh& mesh,
                                                                  const std::function<bool(double)>& goesOn = {});

    /// `values`: one a node, [z][y][x], in units of kUnitM; none where there are not as many as the layout has nodes.
    [[nodiscard]] static std::shared_ptr<const DistanceGrid> of(const GridLayout& layout,
                                                                const std::vector<std::int8_t>& values);

    [[nodiscard]] const GridLayout& layout() const { return m_layout; }
    /// A node's value, and that of the next one up y; the last row has its own twice.
    struct Pair
    {
        std::int8_t value, above;
    };
    /// [z][y][x], and one more at the end: so whole words may be read from each, which hold what is at the next x too.
    [[nodiscard]] const std::vector<Pair>& pairs() const { return m_pairs; }

    /// Signed distance with its direction of steepest rise, between the nodes by their weighted mean; about a unit
    /// vector. Nothing outside the grid.
    struct Sample
    {
        float distanceM = kReachM;
        glm::vec3 gradient{0.0F};
    };
    [[nodiscard]] std::optional<Sample> at(const glm::vec3& positionHd) const;

private:
    DistanceGrid(const GridLayout& layout, const std::vector<std::int8_t>& values);

    GridLayout m_layout;
    std::vector<Pair> m_pairs;
};

} // namespace hairpaint::sim
