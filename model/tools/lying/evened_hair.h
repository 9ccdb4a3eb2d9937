// Hair as its neighbours are: means of maps around a point.
#pragma once

#include "model/tools/lying/fallen_hair.h"
#include "model/tools/strokes/skin_frames.h"
#include "model/tools/strokes/stroke_buffer.h"
#include "sim/base/tiled_raster.h"

#include <glm/glm.hpp>

namespace hairpaint::model {

/// The distance between a point and its neighbours, uv: a fraction of the radius of `brush`, the brush's whole dab.
[[nodiscard]] glm::vec2 eveningReachUv(const Dab& brush, int mapSize);
/// The mean direction with the mean flatness, in the frame of the point: where hair turns, it is not raised.
[[nodiscard]] glm::vec2 evenedDirection(SkinFrames& frames, FallenHair& before, glm::vec2 uv, glm::vec2 reachUv);
/// The mean of a scalar map, 0..1, over the neighbours that have hair.
[[nodiscard]] float evenedScalar(const sim::TiledRaster& map, const sim::TiledRaster& density, glm::vec2 uv,
                                 glm::vec2 reachUv);

} // namespace hairpaint::model
