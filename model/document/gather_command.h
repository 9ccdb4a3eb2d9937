// Hair gathered by one click.
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

} // namespace hairpaint::model
