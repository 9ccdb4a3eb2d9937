// How a patch lies on the skin, and what is worn there.
#pragma once

#include "model/project/worn.h"
#include "sim/groom/patch_labels.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

struct PatchShape
{
    std::vector<sim::SurfacePoint> points; ///< Some of the patch's texels, evenly spread.
    std::vector<float> areasM2;            ///< The area that each point stands for.
    float areaM2 = 0.0F;
    glm::vec3 middleHd{0.0F};     ///< Mean position over the patch's area; off the skin where the patch is bent.
    glm::vec3 meanNormalHd{0.0F}; ///< Mean normal over the patch's area; of length 1 where the patch is flat.
};

/// The shape of a patch; none where no texel of it lies on the skin.
[[nodiscard]] std::optional<PatchShape> shapeOf(const sim::PatchLabels& labels, std::size_t patch);
/// The point of the patch that is nearest to `positionHd`.
[[nodiscard]] const sim::SurfacePoint& pointNearest(const PatchShape& shape, glm::vec3 positionHd);

/// Sets position and size of a thing with such a patch, before anybody moves it. A tie sits where a hairdresser would
/// gather that hair: outward from the patch's middle, and the further up and back the more the patch goes around the
/// head.
void wearOnPatch(Worn& worn, const PatchShape& shape, const sim::Skin& skin);

} // namespace hairpaint::model
