// Small pictures of maps and layers as the paint area shows them.
#pragma once

#include "model/project/project.h"

#include <QImage>

namespace hairpaint::view {

/// A resolved map, `side` pixels square.
[[nodiscard]] QImage mapThumbnail(const sim::TiledRaster& resolved, const model::MapSpec& spec, bool nightPaper,
                                  int side);
/// One layer; transparent where it covers nothing.
[[nodiscard]] QImage layerThumbnail(const model::Layer& layer, const model::MapSpec& spec, bool nightPaper, int side);

} // namespace hairpaint::view
