// Draws the brush rings over the picture.
#pragma once

#include "view/rendering/frame_constants.h"
#include "view/rendering/gl/gl_objects.h"

#include <array>

namespace hairpaint::rendering {

class RingPass
{
public:
    [[nodiscard]] static tl::expected<RingPass, std::string> create();

    /// Into the framebuffer bound, with the constants bound to uniform buffer 0, the head's colour and depth to texture
    /// units 0 and 1, and an empty vertex array. Only the pixels around a ring are touched.
    void draw(const FrameConstants& constants) const;

private:
    std::array<Program, 3> m_programs; ///< For 1, 2 and 4 samples a pixel.
};

} // namespace hairpaint::rendering
