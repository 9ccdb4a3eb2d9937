// Names of landmarks of the head, for the paint area.
#pragma once

#include "model/project/project.h"

#include <QString>

#include <vector>

namespace hairpaint::view {

struct Landmark
{
    QString name; ///< Translated.
    glm::vec2 uv{0.0F};
};

[[nodiscard]] QString landmarkName(sim::HeadLandmark landmark); ///< Translated.

/// Points on the skin, so they follow the layout: the head's landmarks, where "left ear" tells the sides apart. Of
/// heads whose landmarks are not known, the two sides where they are widest.
[[nodiscard]] std::vector<Landmark> landmarksOf(const model::Head& head);

} // namespace hairpaint::view
