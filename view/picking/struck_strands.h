// Which strands of a picture cross a line or go into an outline.
#pragma once

#include "model/tools/strokes/seen_hair.h"
#include "view/picking/line_rows.h"
#include "view/picking/picture_hair.h"

namespace hairpaint::view {

/// Where the drawn curve of each first meets the line or, with `inside`, is inside it, from its root on, by slot; what
/// skin hides only with `throughSkin`. The same for any number of threads.
[[nodiscard]] std::vector<model::SeenStrand> struckStrands(const PictureHair& picture, const LineRows& line,
                                                           bool inside, bool throughSkin);

} // namespace hairpaint::view
