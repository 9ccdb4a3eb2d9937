// Which strands of a picture lie under a brush.
#pragma once

#include "model/tools/seen_hair.h"
#include "view/picking/picture_hair.h"

namespace hairpaint::view {

/// A disc that is swept along a line, px of the view.
struct PictureBrush
{
    glm::vec2 from{0.0F}, to{0.0F};
    float radiusPx = 0.0F;
    PictureBox box; ///< All of it.

    PictureBrush(glm::vec2 begin, glm::vec2 end, float px) : from(begin), to(end), radiusPx(px)
    {
        box.add(from);
        box.add(to);
        box = box.widened(radiusPx);
    }
};

/// Those that neither skin nor other hair hides, where their skeleton is nearest to the brush's middle, by slot;
/// curled ones that strayed from it are met where their drawn curve is. The same for any number of threads. About 1 ms
/// for 100,000 hairs.
[[nodiscard]] std::vector<model::SeenStrand> brushedStrands(const PictureHair& picture, const PictureBrush& brush);

} // namespace hairpaint::view
