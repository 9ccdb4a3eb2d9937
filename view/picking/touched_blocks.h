// Segments of skeletons under a brush, block by block.
#pragma once

#include "view/picking/front_hair.h"
#include "view/picking/picture_brush.h"
#include "view/picking/picture_hair.h"

#include <span>
#include <vector>

namespace hairpaint::view {

/// A segment of a skeleton that lies under the brush.
struct Touch
{
    std::uint32_t slot;
    std::uint32_t node; ///< The node at the segment's end.
    float fraction;     ///< Fraction of the segment at which it is nearest to the brush's middle.
    float apartPx;      ///< Distance from the brush's middle there.
    float strayPx;      ///< How far the drawn curve may be from the skeleton there.
    float nearestM;     ///< No part of the curve there is nearer to the eye.
    glm::vec3 seen;     ///< That point as the picture shows it: px, and depth.
};

/// The touches of one brush. The same for any number of threads.
class TouchedBlocks
{
public:
    TouchedBlocks(const PictureHair& picture, const PictureBrush& brush);

    /// The touches block by block, in the order of slots, and in each strand root first.
    [[nodiscard]] std::vector<std::span<const Touch>> blocks() const;
    /// Whether other hair hides it.
    [[nodiscard]] bool hides(const Touch& touch) const
    {
        return touch.nearestM > m_deepestM || m_front.hides(touch.seen);
    }

private:
    /// What a task found in its blocks.
    struct Part
    {
        struct Run
        {
            std::uint32_t block;
            std::size_t end; ///< In `touches`; the run begins where the one before ends.
        };
        std::vector<Touch> touches;
        std::vector<Run> runs;
        FrontHair front;
    };

    FrontHair m_front;
    float m_deepestM; ///< What lies deeper is hidden wherever the brush is.
    std::vector<Part> m_parts;
};

} // namespace hairpaint::view
