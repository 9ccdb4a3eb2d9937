// Which hair lies under the pointer.
#pragma once

#include "model/tools/tool.h"
#include "sim/motion/strand_frame.h"
#include "view/rendering/scene.h"

#include <QPointF>
#include <QSizeF>

#include <optional>

namespace hairpaint::view {

inline constexpr double kHairReachPx = 20.0; ///< Hair no further from the pointer can be taken hold of.

/// The point of a drawn hair of that group that is nearest to a position of the view, and to the eye: 10 px aside count
/// as 1 cm behind. `furthestM` from the eye: where skin hides what lies behind it. About 10 ms for 100,000 hairs on one
/// core, less on several.
[[nodiscard]] std::optional<model::GrabbedHair> hairNear(QPointF position, const sim::StrandFrame& frame, int group,
                                                         const rendering::Camera& camera, QSizeF size, float furthestM);

} // namespace hairpaint::view
