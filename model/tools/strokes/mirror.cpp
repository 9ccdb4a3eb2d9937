// Reflection through the built-in layout or through the skin.
#include "model/tools/strokes/mirror.h"

#include "sim/groom/direction_texel.h"
#include "sim/skin/skin_frame.h"

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

sim::Texel mirroredValue(const MapSpec& spec, const sim::Texel& value, const Head* head,
                         const std::optional<sim::SurfacePoint>& at)
{
    if (spec.texel != TexelKind::Vector)
        return value;
    const glm::vec2 direction = sim::directionOf(value);
    if (head != nullptr && !head->builtIn && head->skin != nullptr && at)
        if (const std::optional<sim::SurfacePoint> other = head->skin->mirrored(*at)) {
            const glm::vec3 acrossHd = sim::SkinFrame::at(*at).toHd(direction) * glm::vec3(-1.0F, 1.0F, 1.0F);
            const glm::vec2 there = sim::SkinFrame::at(*other).fromHd(acrossHd);
            const float length = glm::length(there);
            return sim::texelOfDirection(length > 0.0F ? there * (glm::length(direction) / length) : there);
        }
    return sim::texelOfDirection({-direction.x, direction.y});
}

} // namespace hairpaint::model
