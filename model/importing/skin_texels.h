// The texels of a map that lie on the skin, as positions there.
#pragma once

#include "model/importing/position_grid.h"
#include "model/values/progress.h"
#include "sim/skin/skin_frame.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

/// All arrays: by texel on the skin, those near each other on the head near each other here. Immutable.
struct SkinTexels
{
    int size = 0;                     ///< Side of the map, texels.
    std::vector<std::uint32_t> texel; ///< Number of the texel in the map, row by row.
    std::vector<glm::vec3> positionsHd;
    std::vector<sim::SkinFrame> frame;
    std::vector<float> areaM2;
    float sideM = 0.0F;               ///< Median side of a texel on the skin.
    std::optional<PositionGrid> grid; ///< Over positionsHd.

    [[nodiscard]] std::size_t count() const { return texel.size(); }
    /// None where `progress` cancels. Half a second for a map of 1024; uses parallelFor.
    [[nodiscard]] static std::optional<SkinTexels> of(const sim::Skin& skin, int size, const Progress& progress = {});

private:
    void sortByPosition();
};

} // namespace hairpaint::model
