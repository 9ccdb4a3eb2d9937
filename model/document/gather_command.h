// Hair gathered by one click: into one tail, or two.
#pragma once

#include "model/document/command_ptr.h"
#include "model/document/document.h"

#include <QRectF>

#include <vector>

namespace hairpaint::model {

/// Gathers the group's hair that nothing gathers yet, inside what is selected (uv; empty: everywhere), into a thing of
/// that kind at the point; where hair there is gathered by one of the kind already, that goes there. Null where no hair
/// is left to gather, or no layer of the accessory map can be painted.
[[nodiscard]] CommandPtr gatherCommand(Document& document, Id group, const WornSpec& spec,
                                       const sim::SurfacePoint& point, const std::vector<QRectF>& selected);

/// The same into a thing of that kind at the point and one on the other side of the head, with a parting between them
/// along the middle of the head (painted in the density map, too); hair that one of the kind gathers already is parted
/// with it. From a point in the middle of the head they are put beside it. Null where a side has no hair or the sides
/// are no mirror images, or no layer of the accessory map or the density map can be painted.
[[nodiscard]] CommandPtr gatherTwinsCommand(Document& document, Id group, const WornSpec& spec,
                                            const sim::SurfacePoint& point, const std::vector<QRectF>& selected);

} // namespace hairpaint::model
