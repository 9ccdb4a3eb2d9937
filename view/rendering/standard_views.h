// The views that pictures are taken from: front, back, left, right, top, bottom, three-quarter.
#pragma once

#include "view/rendering/scene.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace hairpaint::rendering {

enum class StandardView
{
    Front,
    Back,
    Left,
    Right,
    Top,
    Bottom,
    ThreeQuarter
};

/// "front", "back", "left", "right", "top", "bottom", "three-quarter"; none for anything else. Left shows the head's
/// own left side.
[[nodiscard]] std::optional<StandardView> standardViewNamed(std::string_view name);

/// All of those names, in the order of StandardView.
[[nodiscard]] std::vector<std::string_view> standardViewNames();

/// What a picture frames.
enum class Fit
{
    Hair, ///< Head and hair, without a bust's pedestal.
    Head,
    Bust ///< The whole mesh.
};

/// "hair", "head", "bust"; none for anything else.
[[nodiscard]] std::optional<Fit> fitNamed(std::string_view name);

/// The camera of that view that sees all points as large as they fit, with a margin, in a picture of `aspect` (width
/// over height). `pointsWo` is not empty.
[[nodiscard]] Camera fittedCamera(StandardView view, std::span<const glm::vec3> pointsWo, float aspect);
/// The same from any direction, that of `from`.
[[nodiscard]] Camera fittedCamera(const Camera& from, std::span<const glm::vec3> pointsWo, float aspect);

/// Frames the whole mesh with room for hair around it.
[[nodiscard]] Camera standardCamera(StandardView view, const sim::HeadMesh& head);

} // namespace hairpaint::rendering
