// A disc on the skin as an ellipse of texels.
#pragma once

#include "model/tools/strokes/stroke_buffer.h"
#include "sim/skin/skin.h"

namespace hairpaint::model {

/// The first fundamental form of the uv map at one point: how long a step in uv is on the skin.
struct SkinMetric
{
    float e = 0.25F, f = 0.0F, g = 0.25F; ///< dP/du.dP/du, dP/du.dP/dv, dP/dv.dP/dv; m2 per uv unit squared.

    [[nodiscard]] static SkinMetric at(const sim::SurfacePoint& point);
    /// The same in every direction and everywhere, right on average; for uv off every island.
    [[nodiscard]] static SkinMetric average(const sim::Skin& skin);
    [[nodiscard]] float lengthM(glm::vec2 stepUv) const;
};

/// The dab whose rim is the circle of `radiusM` around `uv` on the skin. Its centre is rounded to 1/64 texel, so that
/// the same position reached by another sum of steps gives the same bytes. Never thinner than 0.7 texels, nor wider
/// than the map.
[[nodiscard]] Dab dabAt(const SkinMetric& metric, glm::vec2 uv, float radiusM, int mapSize);

/// The dab reflected at u = 1/2, to the bit.
[[nodiscard]] Dab mirroredInU(Dab dab, int mapSize);
/// The same disc on a map of another size.
[[nodiscard]] Dab onMapOf(Dab dab, int from, int to);

} // namespace hairpaint::model
