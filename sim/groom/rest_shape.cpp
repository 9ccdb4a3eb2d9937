// Straight and clumped rest shapes.
#include "sim/groom/rest_shape.h"

#include <cmath>
#include <cstddef>

namespace hairpaint::sim {

void straightRest(const RootFrame& root, float lengthM, std::span<glm::vec3> nodesHd)
{
    const float segmentM = lengthM / static_cast<float>(nodesHd.size() - 1);
    for (std::size_t i = 0; i < nodesHd.size(); ++i)
        nodesHd[i] = root.positionHd + root.normalHd * (segmentM * static_cast<float>(i));
}

void clumpRest(std::span<const glm::vec3> basisHd, float basisSegmentM, float clump, float segmentM,
               std::span<glm::vec3> nodesHd)
{
    const std::size_t last = nodesHd.size() - 1;
    const float perBasisSegment = segmentM / basisSegmentM;
    const auto basisEnd = static_cast<float>(basisHd.size() - 1);
    glm::vec3 parentBefore = nodesHd[0];
    glm::vec3 toBasis(0.0F);
    for (std::size_t i = 1; i <= last; ++i) {
        const float along = static_cast<float>(i) * perBasisSegment;
        if (along < basisEnd) {
            const auto from = static_cast<std::size_t>(along);
            toBasis = glm::mix(basisHd[from], basisHd[from + 1], along - static_cast<float>(from)) - nodesHd[i];
        } else if (along < basisEnd + perBasisSegment) {
            toBasis = basisHd.back() - glm::mix(parentBefore, nodesHd[i], (basisEnd - along) / perBasisSegment + 1.0F);
        }
        const float s = static_cast<float>(i) / static_cast<float>(last);
        const glm::vec3 drawn = nodesHd[i] + toBasis * (clump * s * (2.0F - s));
        const glm::vec3 away = drawn - nodesHd[i - 1];
        const float distance = std::sqrt(glm::dot(away, away));
        // Should a node fall on its parent, it goes where it was headed.
        const glm::vec3 segment = distance > 1e-12F ? away * (segmentM / distance) : nodesHd[i] - parentBefore;
        parentBefore = nodesHd[i];
        nodesHd[i] = nodesHd[i - 1] + segment;
    }
}

} // namespace hairpaint::sim
