// Which texels of a map lie on the skin.
#pragma once

#include "sim/base/tiled_raster.h"
#include "sim/skin/head_mesh.h"

#include <cstdint>
#include <vector>

namespace hairpaint::model {

/// One byte a texel of a map of `size`, row 0 at v = 1: 1 where the texel's centre lies in a face's uv. A mesh of many
/// faces costs one pass over their texels.
[[nodiscard]] std::vector<std::uint8_t> uvCover(const sim::HeadMesh& mesh, int size);

/// Sets the texels within `rings` steps of a set one to 2, so that bilinear samples at a border find no gap.
void bleed(std::vector<std::uint8_t>& texels, int size, int rings);

} // namespace hairpaint::model
