// Small pictures of rasters as the paint area shows them.
#pragma once

#include "model/map_spec.h"

#include <QImage>

namespace hairpaint::view {

/// A resolved map.
[[nodiscard]] QImage mapThumbnail(const sim::TiledRaster& resolved, const model::MapSpec& spec, bool nightPaper,
                                  int side);
/// One layer; texels without coverage are transparent.
[[nodiscard]] QImage layerThumbnail(const sim::TiledRaster& layer, const model::MapSpec& spec, bool nightPaper,
                                    int side);

} // namespace hairpaint::view
