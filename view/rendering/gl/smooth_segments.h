// The number of segments in which the GPU draws the strands of a group.
#pragma once

#include "sim/motion/strand_frame.h"
#include "view/rendering/frame_constants.h"

namespace hairpaint::rendering {

inline constexpr int kSegmentsOfDyedHair = 28; ///< So that the tip colour can begin in a line.

struct SegmentsWanted
{
    int ofStraightHair = 1; ///< For the bends of the skeletons.
    int curlFactor = 1;     ///< Times sim::curveSegmentsOf.
    friend bool operator==(const SegmentsWanted&, const SegmentsWanted&) = default;
};
/// So that hardly a curve lies more than `toleranceSp` samples beside its chords; told from some of the strands, and in
/// coarse steps, so that lists of strands are not made anew all the time.
[[nodiscard]] SegmentsWanted segmentsWanted(const sim::GroupFrame& group, const FrameConstants& constants,
                                            float toleranceSp);

} // namespace hairpaint::rendering
