// Bringing a row-wise readable image to the size of a map.
// Any thread; rows are asked for on the caller's. Errors: none but std::bad_alloc.
#pragma once

#include "sim/base/tiled_raster.h"

#include <functional>
#include <span>

namespace hairpaint::model {

/// Fills `texels` with row `y` of a source, value channels then coverage.
using TexelRowReader = std::function<void(int y, std::span<sim::Texel> texels)>;

/// Bilinear where it enlarges, the triangle filter of the same name where it shrinks; weighted by coverage, edges
/// repeated. `empty` is what stands where nothing covers.
[[nodiscard]] sim::TiledRaster resampleBilinear(int width, int height, const TexelRowReader& readRow, int size,
                                                int channels, sim::Texel empty);
[[nodiscard]] sim::TiledRaster resampleNearest(int width, int height, const TexelRowReader& readRow, int size,
                                               int channels);

} // namespace hairpaint::model
