// How a mask lays a value onto a layer's tile, or takes coverage away.
#pragma once

#include "model/maps/texel_ops.h"
#include "sim/base/tiled_raster.h"

#include <array>
#include <cstdint>

namespace hairpaint::model {

/// How much of each texel of a tile is covered, 65535 wholly.
using MaskTile = std::array<std::uint16_t, sim::kTileTexels>;

/// `before` with `paint` through `mask`, where `fraction = mask * opacity`:
/// laid: coverage' = coverage + (1 - coverage) fraction, value' = value moved by fraction / coverage' toward the paint;
/// erased: coverage' = coverage (1 - fraction), and the default value where nothing is left.
/// An index is laid, or taken away, whole where the mask alone is 1/2 or more.
/// Returns `before` itself where no texel changes; a tile of equal texels comes back uniform.
[[nodiscard]] sim::RasterTilePtr paintTile(const MapSpec& spec, const sim::RasterTilePtr& before, const MaskTile& mask,
                                           const TilePaint& paint);

} // namespace hairpaint::model
