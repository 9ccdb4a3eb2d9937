// The built-in styles, each as functions of a place on the head of new projects.
#pragma once

#include "model/map_spec.h"
#include "sim/groom/group_settings.h"
#include "sim/skin/skin_frame.h"

#include <QColor>
#include <QStringList>

#include <glm/glm.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace hairpaint::presets {

/// A place on the skin as styles see it. Hd, m.
struct SkinPoint
{
    glm::vec3 positionHd;
    glm::vec3 normalHd;
    float scalpM; ///< Distance inside the natural hairline; negative outside.
    sim::SkinFrame frame;
};

using ScalarField = std::function<float(const SkinPoint&)>; ///< 0..1
/// Along the skin, as long as the cosine of the angle to it; none where hair lies naturally.
using DirectionField = std::function<std::optional<glm::vec3>(const SkinPoint&)>;
using ColourField = std::function<QColor(const SkinPoint&)>;

struct Style
{
    const char* id; ///< File name.
    QString name;
    QStringList tags;
    sim::GroupSettings settings;
    ScalarField density, length, curl, clump, gel;
    ScalarField braid; ///< The palette's index; none where null.
    ColourField colour;
    DirectionField direction = {}; ///< Naturally everywhere where null.
};

[[nodiscard]] std::vector<Style> builtInStyles(); ///< In the strip's order.

} // namespace hairpaint::presets
