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
    std::uint32_t node; ///< At its end.
    float fraction;     ///< Of the segment, where it is nearest.
    float apartPx;      ///< From the brush's middle there,
    float strayPx;      ///< and how far the curve may be from it.
    float nearestM;     ///< No part of the curve there is nearer to the eye.
    glm::vec3 seen;     ///< px, depth.
};

/// Those of a brush. The same for any number of threads.
class TouchedBlocks
{
public:
    TouchedBlocks(const PictureHair& picture, const PictureBrush& brush);

    /// By slot, and in each strand root first.
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
