// What the 3D area has drawn, and from where it is seen.
#pragma once

#include "view/rendering/scene.h"

#include <cstddef>

namespace hairpaint::view {

/// From where a picture is seen, and how the head is turned in it.
struct Sight
{
    rendering::Camera camera;
    sim::HeadPose pose;
    friend bool operator==(const Sight&, const Sight&) = default;
};

/// What to draw next.
struct Shot
{
    rendering::Scene scene;
    std::size_t allHairs = 0;
    bool still = false; ///< Nothing moves: there is time for a finer picture.

    [[nodiscard]] Sight sight() const
    {
        return {.camera = scene.camera, .pose = scene.hair ? scene.hair->pose : sim::HeadPose()};
    }
};

} // namespace hairpaint::view
