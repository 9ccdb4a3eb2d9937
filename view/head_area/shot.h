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
    std::uint64_t hairRevision = 0; ///< StrandFrame::revision; 0 without hair. What lies over it hangs not on that.
    friend bool operator==(const Sight& a, const Sight& b) { return a.camera == b.camera && a.pose == b.pose; }
};

/// What to draw next.
struct Shot
{
    rendering::Scene scene;
    std::size_t allHairs = 0;
    bool still = false; ///< Nothing moves: there is time for a finer picture.

    [[nodiscard]] Sight sight() const
    {
        return {.camera = scene.camera,
                .pose = scene.hair ? scene.hair->pose : sim::HeadPose(),
                .hairRevision = scene.hair ? scene.hair->revision : 0};
    }
};

} // namespace hairpaint::view
