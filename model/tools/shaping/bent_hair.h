// A hair bent by one of its points, and the course that it takes over the skin.
#pragma once

#include "model/tools/live_edit.h"
#include "model/tools/lying/comb_field.h"
#include "model/tools/strokes/skin_frames.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace hairpaint::model {

/// Nodes from root to tip, Hd.
using HairCourse = std::vector<glm::vec3>;

/// Finds the node at that distance along the hair, or inserts one; returns its index, never the root's.
[[nodiscard]] std::size_t nodeAlong(HairCourse& course, float alongM);
/// Moves the node to the target, or as near as the hair reaches. The root stays, nodes beyond the moved one follow, and
/// distances between neighbours are kept. (FABRIK: Aristidou and Lasenby, 2011.)
void bendHair(HairCourse& course, std::size_t node, glm::vec3 targetHd);

/// What laying hair along courses leaves on the direction map: as far as a course lies near the skin, from its root on,
/// hair below it is laid along, softly to the rim.
struct LaidHair
{
    StrokeBuffer masks;
    CombField field;
};
struct LayShape
{
    float radiusM = 0.015F; ///< Radius to either side of the course.
    float hardness = 1.0F;  ///< 0..1
};
[[nodiscard]] LaidHair layAlong(std::span<const HairCourse> courses, const LayShape& shape, SkinFrames& frames,
                                int mapSize, std::span<const sim::TexelRect> clips);

} // namespace hairpaint::model
