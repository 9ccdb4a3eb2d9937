// Evenly spaced nodes.
#include "sim/groom/rest_shape.h"

#include <cstddef>

namespace hairpaint::sim {

void straightRest(const RootFrame& root, float lengthM, std::span<glm::vec3> nodesHd)
{
    const float segmentM = lengthM / static_cast<float>(nodesHd.size() - 1);
    for (std::size_t i = 0; i < nodesHd.size(); ++i)
        nodesHd[i] = root.positionHd + root.normalHd * (segmentM * static_cast<float>(i));
}

} // namespace hairpaint::sim
