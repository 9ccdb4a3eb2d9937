// How hair stands in a whorl.
#pragma once

#include "model/tools/strokes/dab_shape.h"
#include "sim/skin/skin_frame.h"

namespace hairpaint::model {

/// A spiral around a point of the skin, as at a crown: upright in the middle, and toward the ring ever flatter, more
/// outward and less around.
struct Whorl
{
    sim::SurfacePoint centre;
    float radiusM = 0.015F;
    float flatness = 0.9F; ///< 0..1 at the ring.
    bool clockwise = true; ///< Seen from outside.
    /// Where hair goes that has its root `offsetUv` from the centre, projected on the tangent plane there, Hd; its
    /// length is the cosine of the angle to the skin. Beyond the ring as at the ring.
    [[nodiscard]] glm::vec3 directionHd(glm::vec2 offsetUv) const;
};

} // namespace hairpaint::model
