// Puts the bust's parts together: cranium first, then face, eyes, nose, mouth, ears, neck, trunk.
#include "bust_shape.h"

#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

float cranium(const glm::vec3& p)
{
    const float back = ellipsoid(p, {0.0F, 0.0310F, -0.0300F}, {0.0735F, 0.0750F, 0.0735F});
    const float front = ellipsoid(p, {0.0F, 0.0310F, 0.0230F}, {0.0600F, 0.0700F, 0.0640F});
    float d = smoothMin(back, front, 0.055F);
    d = smoothMin(d, ellipsoid(p, {0.0F, 0.0390F, -0.0100F}, {0.0660F, 0.0690F, 0.0690F}), 0.030F);
    // Below the bump at the back, over which the neck's muscles start.
    return smoothMin(d, ellipsoid(p, {0.0F, -0.0180F, -0.0380F}, {0.0580F, 0.0460F, 0.0540F}), 0.036F);
}

} // namespace

MirroredPoint mirrored(const glm::vec3& p)
{
    constexpr float rounding = 0.003F;
    const float soft = std::sqrt(p.x * p.x + rounding * rounding) - 0.5F * rounding;
    return {p, {std::abs(p.x), p.y, p.z}, {soft, p.y, p.z}};
}

float bustDistance(const glm::vec3& p, const ShapeOptions& options)
{
    const MirroredPoint m = mirrored(p);
    float d = cranium(p);
    d = joinFace(d, m);
    d = joinEyes(d, m);
    d = joinNose(d, m);
    d = joinMouth(d, m);
    d = joinEar(d, m, options.earGrowth);
    d = joinNeck(d, m);
    return joinTrunk(d, m);
}

glm::vec3 bustGradient(const glm::vec3& p, const ShapeOptions& options, float step)
{
    const glm::vec3 a(1.0F, -1.0F, -1.0F);
    const glm::vec3 b(-1.0F, -1.0F, 1.0F);
    const glm::vec3 c(-1.0F, 1.0F, -1.0F);
    const glm::vec3 d(1.0F, 1.0F, 1.0F);
    const glm::vec3 sum = a * bustDistance(p + a * step, options) + b * bustDistance(p + b * step, options) +
                          c * bustDistance(p + c * step, options) + d * bustDistance(p + d * step, options);
    return sum / (4.0F * step);
}

} // namespace hairpaint::heads
