// Where the strands of a block lie under a brush and are seen, sixteen strands at once.
#pragma once

#include "view/picking/block_kernel.h"
#include "view/picking/front_hair.h"
#include "view/picking/picture_brush.h"
#include "view/picking/skin_depths.h"

#include <cstdint>

namespace hairpaint::view {

/// What hides strands from a brush.
struct BrushCover
{
    const FrontHair& front;
    const SkinDepths& skin;
    float deepestM = kNoLimitM; ///< What lies deeper is hidden wherever the brush is.
};

/// For each strand of a block: of its segments whose curves may meet the brush and are not hidden, the one that is
/// nearest to the brush's middle, and the first from the root. Segments by the node at their end.
struct BlockTouches
{
    PickRow node;      ///< Of the nearest one.
    PickRow fraction;  ///< Fraction of that segment at which it is nearest.
    PickRow apartPx;   ///< Distance from the brush's middle there.
    PickRow strayPx;   ///< How far the drawn curve may be from the skeleton there.
    PickRow firstNode; ///< Of the first one,
    PickRow firstFraction;
    PickRow lastNode;      ///< Beyond it the strand is nowhere near the brush.
    std::uint32_t strands; ///< Bit a lane: strands that have such a segment; of others the rows tell nothing.
};

/// The same bytes on any machine.
void findTouches(const Lens& lens, const BlockQuestion& question, const PictureBrush& brush, const BrushCover& cover,
                 BlockTouches& touches);

} // namespace hairpaint::view
