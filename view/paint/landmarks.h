// Names of places on the built-in head, for the paint area.
#pragma once

#include "model/project.h"

#include <QString>

#include <vector>

namespace hairpaint::view {

struct Landmark
{
    QString name; ///< Translated.
    glm::vec2 uv{0.0F};
};

/// Places on the skin, so they follow the layout: the built-in head's named points, where "left ear" tells the sides
/// apart. Of imported heads, whose proportions nobody knows, the two sides where they are widest.
[[nodiscard]] std::vector<Landmark> landmarksOf(const model::Head& head);

} // namespace hairpaint::view
