// Where the camera stands to show a head with its hair.
#pragma once

#include "model/project/project.h"
#include "sim/motion/strand_frame.h"
#include "view/rendering/scene.h"
#include "view/rendering/standard_views.h"

namespace hairpaint::view {

/// A camera that shows a bust's head down to the shoulders, and all of other heads; further away where hair stands
/// above that. `hair` may be null. Takes about 5 ns a node.
[[nodiscard]] rendering::Camera stageCamera(rendering::StandardView view, const model::Head& head,
                                            const sim::HeadMesh& mesh, const sim::StrandFrame* hair);
/// The same as seen from the direction of another camera.
[[nodiscard]] rendering::Camera stageCamera(const rendering::Camera& from, const model::Head& head,
                                            const sim::HeadMesh& mesh, const sim::StrandFrame* hair);

/// The camera of a picture of `aspect` (width over height): see rendering::Fit. `hair` may be null.
[[nodiscard]] rendering::Camera pictureCamera(rendering::StandardView view, rendering::Fit fit, const model::Head& head,
                                              const sim::StrandFrame* hair, float aspect);
/// The same from any direction, that of `from`.
[[nodiscard]] rendering::Camera pictureCamera(const rendering::Camera& from, rendering::Fit fit,
                                              const model::Head& head, const sim::StrandFrame* hair, float aspect);

} // namespace hairpaint::view
