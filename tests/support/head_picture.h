// What the 3D area shows, drawn once more for a test to look at.
#pragma once

#include "view/head_area/head_frames.h"
#include "view/head_area/head_view.h"

#include <QImage>

namespace hairpaint::test {

/// The present moment at full quality and of that size, without rings, by whoever draws the area; waits for it.
[[nodiscard]] inline QImage pictureOf(const view::HeadView& area, QSize size)
{
    return area.findChild<view::HeadFrames*>()->grab(area.pictureScene(), size);
}

} // namespace hairpaint::test
