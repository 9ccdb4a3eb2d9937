// Strands become points of the picture: curve, projection, light.
#pragma once

#include "view/rendering/software/strand_block.h"

namespace hairpaint::rendering {

/// Segments that the bend of the block's strands needs at this size.
[[nodiscard]] SpanSegments segmentsFor(const StrandView& view, const StrandBlock& block);
/// Fills `points` with segments + 1 of each strand.
void drawnPoints(const StrandView& view, const StrandBlock& block, const SpanSegments& segments, StrandPoints& points);

/// The curves alone: writes segments + 1 points, [point][3][kBlockLanes], Wo.
void drawnCurves(const StrandBlock& block, const SpanSegments& segments, float* pointsWo);

} // namespace hairpaint::rendering
