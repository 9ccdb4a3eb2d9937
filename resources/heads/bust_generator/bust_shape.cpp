// Puts the bust's parts together: cranium first, then face, eyes, nose, mouth, ears, neck, trunk.
#include "bust_shape.h"

#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

MirroredPoint mirrored(const glm::vec3& p)
{
    constexpr float rounding = 0.003F;
    const float soft = std::sqrt(p.x * p.x + rounding * rounding) - 0.5F * rounding;
    return {p, {std::abs(p.x), p.y, p.z}, {soft, p.y, p.z}};
}

float cranium(const glm::vec3& p)
{
    const float back = ellipsoid(p, {0.0F, 0.0290F, -0.0200F}, {0.0760F, 0.0830F, 0.0775F});
    const float front = ellipsoid(p, {0.0F, 0.0300F, 0.0210F}, {0.0640F, 0.0745F, 0.0705F});
    return smoothMin(back, front, 0.050F);
}

} // namespace

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
