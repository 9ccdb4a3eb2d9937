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

void clumpRest(std::span<const glm::vec3> basisHd, float clump, float segmentM, std::span<glm::vec3> nodesHd)
{
    const auto segments = static_cast<float>(nodesHd.size() - 1);
    glm::vec3 parentBefore = nodesHd[0];
    for (std::size_t i = 1; i < nodesHd.size(); ++i) {
        const float s = static_cast<float>(i) / segments;
        const float fraction = clump * s * (2.0F - s);
        const glm::vec3 drawn = nodesHd[i] + (basisHd[i] - nodesHd[i]) * fraction;
        const glm::vec3 away = drawn - nodesHd[i - 1];
        const float distance = std::sqrt(glm::dot(away, away));
        // Should a node fall on its parent, it goes where it was headed.
        const glm::vec3 segment = distance > 1e-12F ? away * (segmentM / distance) : nodesHd[i] - parentBefore;
        parentBefore = nodesHd[i];
        nodesHd[i] = nodesHd[i - 1] + segment;
    }
}

} // namespace hairpaint::sim
