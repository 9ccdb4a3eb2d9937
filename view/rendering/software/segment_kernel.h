// Which segments of a block are seen, and which tiles they touch.
#pragma once

#include "view/rendering/software/screen_segments.h"

namespace hairpaint::rendering {

/// Finds the segments that are seen, and what they touch.
void findBounds(const TileGrid& tiles, const StrandPoints& points, int segments, SegmentBounds& bounds);

} // namespace hairpaint::rendering
