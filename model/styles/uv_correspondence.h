// What lies where on two heads.
#pragma once

#include "model/project/project.h"
#include "sim/skin/head_warp.h"
#include "sim/skin/mesh_bounds.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// For each uv of one head's layout, the uv of the corresponding point on another head: the nearest there, once both
/// are brought together by their landmarks (sim::HeadWarp). Immutable; any thread.
class UvCorrespondence
{
public:
    /// Null where `goesOn`, told how far it is (0..1), returns false. Both heads have skin and landmarks. `size`: of
    /// the maps that it will serve most, texels a side; takes some microseconds a texel. Others are served by
    /// interpolation.
    [[nodiscard]] static std::shared_ptr<const UvCorrespondence> make(std::shared_ptr<const Head> from,
                                                                      std::shared_ptr<const Head> to, int size,
                                                                      const std::function<bool(double)>& goesOn = {});
    /// The same, kept until another pair of heads is asked for.
    [[nodiscard]] static std::shared_ptr<const UvCorrespondence>
    between(const std::shared_ptr<const Head>& from, const std::shared_ptr<const Head>& to, int size,
            const std::function<bool(double)>& goesOn = {});

    /// None where the layout of `to` has no skin.
    [[nodiscard]] std::optional<glm::vec2> at(glm::vec2 uvOfTo) const;
    /// A vector of a direction map, told in the frame at `uvOfFrom`, as it is told at `uvOfTo`, the corresponding
    /// point: it is carried as the heads are brought together and keeps its length.
    [[nodiscard]] glm::vec2 direction(glm::vec2 ofFrom, glm::vec2 uvOfFrom, glm::vec2 uvOfTo) const;

private:
    UvCorrespondence(std::shared_ptr<const Head> from, std::shared_ptr<const Head> to, int size);
    [[nodiscard]] std::optional<glm::vec2> measured(glm::vec2 uvOfTo) const;

    std::shared_ptr<const Head> m_from;
    std::shared_ptr<const Head> m_to;
    sim::HeadWarp m_warp;     ///< Positions on `to` to those on `from`.
    sim::MeshBounds m_bounds; ///< Bounds of `from`.
    int m_size;
    std::vector<glm::vec2> m_uvs; ///< [row][column] at texel centres, row 0 at v = 1; x < 0 where there is no skin.
};

} // namespace hairpaint::model
