// The neck by a head's landmarks.
#include "sim/skin/neck.h"

#include "sim/skin/mesh_bounds.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::sim {

Neck neckOf(const std::optional<HeadLandmarks>& landmarks, const HeadMesh& mesh)
{
    constexpr float kTopToNeckM = 0.27F;
    constexpr float kLeastAcrossM = 1e-4F;
    Neck neck;
    if (!landmarks) {
        const MeshBounds bounds = boundsOf(mesh);
        neck.pivotHd = 0.5F * (bounds.least + bounds.greatest);
        neck.pivotHd.y = std::max(bounds.least.y, bounds.greatest.y - kTopToNeckM);
        return neck;
    }
    const glm::vec3& left = (*landmarks)[HeadLandmark::EarLeft];
    const glm::vec3& right = (*landmarks)[HeadLandmark::EarRight];
    const glm::vec3 ears = 0.5F * (left + right);
    const float chinY = (*landmarks)[HeadLandmark::Chin].y;
    // Halfway to the nape the spine comes down; the shoulders begin as far below the chin as half the distance from the
    // ears.
    neck.pivotHd = 0.5F * (ears + (*landmarks)[HeadLandmark::Nape]);
    const float faceM = std::max(ears.y - chinY, 0.0F);
    neck.pivotHd.y = chinY - 0.5F * faceM;
    neck.headY = chinY - 0.12F * faceM;
    neck.shouldersY = chinY - 0.8F * faceM;
    const glm::vec3 across(left.x - right.x, 0.0F, left.z - right.z);
    const float length = std::sqrt(glm::dot(across, across));
    if (length > kLeastAcrossM)
        neck.acrossHd = across / length;
    return neck;
}

} // namespace hairpaint::sim
