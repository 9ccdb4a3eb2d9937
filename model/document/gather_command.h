// Hair gathered into two tails by one click; into one: gatherCommand() in commands.h.
#pragma once

#include "model/document/commands.h"

namespace hairpaint::model {

/// Gathers the group's hair that nothing gathers yet, inside what is selected (uv; empty: everywhere), into a thing of
/// that kind at the point and one on the other side of the head, with a parting between them along the middle of the
/// head (painted in the density map, too); hair that one of the kind gathers already is parted with it. From a point in
/// the middle of the head they are put beside it. Null where a side has no hair or the sides are no mirror images, or
/// no layer of the accessory map or the density map can be painted.
[[nodiscard]] CommandPtr gatherTwinsCommand(Document& document, Id group, const WornSpec& spec,
                                            const sim::SurfacePoint& point, const std::vector<QRectF>& selected);

} // namespace hairpaint::model
