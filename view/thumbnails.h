// Small pictures of maps and layers for the panels.
#pragma once

#include "model/project.h"

#include <QImage>

namespace hairpaint::view {

/// A resolved map in its scale, `sidePx` square.
[[nodiscard]] QImage mapThumbnail(const sim::TiledRaster& resolved, const model::MapSpec& spec, bool nightPaper,
                                  int sidePx);
/// A layer alone: transparent where it covers nothing.
[[nodiscard]] QImage layerThumbnail(const model::Layer& layer, const model::MapSpec& spec, bool nightPaper, int sidePx);

} // namespace hairpaint::view
