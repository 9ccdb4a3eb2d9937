// Stacks of layers that are one texel each.
#pragma once

#include "model/project/project.h"

#include <vector>

namespace hairpaint::model {

inline MapStack stackOf(MapKind kind, const std::vector<sim::Texel>& layers)
{
    MapStack stack{.kind = kind, .size = 256, .layers = {}};
    Id id = 1;
    for (const sim::Texel& texel : layers)
        stack.layers.push_back(
            {.id = id++, .name = {}, .raster = sim::TiledRaster(256, mapSpec(kind).layerChannels(), texel)});
    return stack;
}

} // namespace hairpaint::model
