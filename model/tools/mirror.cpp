// Reflection through the built-in layout or through the skin.
#include "model/tools/mirror.h"

namespace hairpaint::model {

std::optional<glm::vec2> mirroredUv(const Head* head, glm::vec2 uv)
{
    if (head == nullptr || head->builtIn || head->skin == nullptr)
        return glm::vec2(1.0F - uv.x, uv.y);
    if (const std::optional<sim::SurfacePoint> point = head->skin->atUv(uv))
        if (const std::optional<sim::SurfacePoint> other = head->skin->mirrored(*point))
            return other->uv;
    return std::nullopt;
}

} // namespace hairpaint::model
