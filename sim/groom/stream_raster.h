// A head's natural stream as a direction map.
#pragma once

#include "sim/base/tiled_raster.h"
#include "sim/skin/skin.h"

#include <memory>
#include <vector>

namespace hairpaint::sim {

inline constexpr int kStreamRasterSize = 512; ///< Texels a side.

/// `directionsHd`, one a vertex as naturalStream() gives them, in each texel's own frame (direction_texel.h); drawn
/// over the borders of islands by some texels. Any thread.
[[nodiscard]] std::shared_ptr<const TiledRaster> streamRaster(const Skin& skin,
                                                              const std::vector<glm::vec3>& directionsHd);

} // namespace hairpaint::sim
