// The brush rings over a finished picture.
#pragma once

#include "view/rendering/frame_constants.h"
#include "view/rendering/software/head_picture.h"

#include <cstdint>

namespace hairpaint::rendering {

/// As ring.frag draws them: where the skin is as far from the centre as the radius, white with a dark edge outside;
/// inside, the hair fades so that the skin shows. `pixels`: RGBA8, row 0 on top.
void drawRings(const FrameConstants& constants, const HeadPicture& head, std::uint8_t* pixels);

} // namespace hairpaint::rendering
