// How a patch lies on the skin, and what is worn there.
#pragma once

#include "model/project/worn.h"
#include "sim/groom/patch_labels.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

struct PatchShape
{
    std::vector<sim::SurfacePoint> points; ///< Some of its texels, evenly.
    std::vector<float> areasM2;            ///< That each of them stands for.
    float areaM2 = 0.0F;
    glm::vec3 middleHd{0.0F};     ///< Mean over its area; not on the skin where it is bent.
    glm::vec3 meanNormalHd{0.0F}; ///< The same of the normals: 1 long where it is flat.
};

/// None where none of it lies on the skin.
[[nodiscard]] std::optional<PatchShape> shapeOf(const sim::PatchLabels& labels, std::size_t patch);
/// Of its points the one nearest to there.
[[nodiscard]] const sim::SurfacePoint& pointNearest(const PatchShape& shape, glm::vec3 positionHd);

/// Where and how large a thing of such a patch is before anybody moves it. A tie sits where a hairdresser gathers that
/// hair: outward from its middle, up and back the more the patch goes around the head.
void wearOnPatch(Worn& worn, const PatchShape& shape, const sim::Skin& skin);

} // namespace hairpaint::model
