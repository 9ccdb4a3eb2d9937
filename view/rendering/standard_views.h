// The views that pictures are taken from: front, back, left, right, top, three-quarter.
#pragma once

#include "view/rendering/scene.h"

#include <optional>
#include <string_view>

namespace hairpaint::rendering {

enum class StandardView
{
    Front,
    Back,
    Left,
    Right,
    Top,
    ThreeQuarter
};

/// "front", "back", "left", "right", "top", "three-quarter"; none for anything else. Left shows the head's own left
/// side.
[[nodiscard]] std::optional<StandardView> standardViewNamed(std::string_view name);

/// Frames the whole mesh with room for hair around it.
[[nodiscard]] Camera standardCamera(StandardView view, const sim::HeadMesh& head);

} // namespace hairpaint::rendering
