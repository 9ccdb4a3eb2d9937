// The built-in styles, each as functions of a place on the head of new projects.
#pragma once

#include "model/map_spec.h"
#include "sim/groom/group_settings.h"

#include <QColor>
#include <QStringList>

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace hairpaint::presets {

/// A place on the skin as styles see it. Hd, m.
struct SkinPoint
{
    glm::vec3 positionHd;
    glm::vec3 normalHd;
    float scalpM; ///< Distance inside the natural hairline; negative outside.
};

using ScalarField = std::function<float(const SkinPoint&)>; ///< 0..1
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
};

[[nodiscard]] std::vector<Style> builtInStyles(); ///< In the strip's order.

} // namespace hairpaint::presets
