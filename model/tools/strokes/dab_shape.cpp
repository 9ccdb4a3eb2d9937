// From the uv map's derivatives to the quadratic form of a dab.
#include "model/tools/strokes/dab_shape.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

constexpr float kThinnestTx = 0.7F;
constexpr float kCentreSteps = 64.0F; ///< A texel.

float rounded(float tx)
{
    return std::round(tx * kCentreSteps) / kCentreSteps;
}

/// Keeps both semi-axes of the form between `least` and `most` texels.
void limitAxes(Dab& dab, float least, float most)
{
    const float mean = 0.5F * (dab.a + dab.c);
    const float spread = std::sqrt(0.25F * (dab.a - dab.c) * (dab.a - dab.c) + dab.b * dab.b);
    const float low = 1.0F / (most * most);
    const float high = 1.0F / (least * least);
    if (mean - spread >= low && mean + spread <= high)
        return;
    // Same axes, clamped eigenvalues: mean' + (spread'/spread) * deviation from the mean.
    const float large = std::clamp(mean + spread, low, high);
    const float small = std::clamp(mean - spread, low, high);
    const float newMean = 0.5F * (large + small);
    const float scale = spread > 0.0F ? 0.5F * (large - small) / spread : 0.0F;
    const float deviation = 0.5F * (dab.a - dab.c) * scale;
    dab.a = newMean + deviation;
    dab.c = newMean - deviation;
    dab.b *= scale;
}

} // namespace

SkinMetric SkinMetric::at(const sim::SurfacePoint& point)
{
    const SkinMetric metric{glm::dot(point.dPduHd, point.dPduHd), glm::dot(point.dPduHd, point.dPdvHd),
                            glm::dot(point.dPdvHd, point.dPdvHd)};
    // A face without area in uv has no derivatives.
    return std::isfinite(metric.e + metric.f + metric.g) ? metric : SkinMetric{};
}

SkinMetric SkinMetric::average(const sim::Skin& skin)
{
    const sim::HeadMesh& mesh = skin.mesh();
    double uvArea = 0.0;
    for (const glm::uvec3& face : mesh.triangles) {
        const glm::vec2 side = mesh.uvs[face.y] - mesh.uvs[face.x];
        const glm::vec2 other = mesh.uvs[face.z] - mesh.uvs[face.x];
        uvArea += 0.5 * std::abs(static_cast<double>(side.x * other.y - side.y * other.x));
    }
    const auto squared = static_cast<float>(skin.areaM2() / std::max(uvArea, 1e-6));
    return {squared, 0.0F, squared};
}

float SkinMetric::lengthM(glm::vec2 stepUv) const
{
    return std::sqrt(
        std::max(0.0F, e * stepUv.x * stepUv.x + 2.0F * f * stepUv.x * stepUv.y + g * stepUv.y * stepUv.y));
}

Dab dabAt(const SkinMetric& metric, glm::vec2 uv, float radiusM, int mapSize)
{
    const auto size = static_cast<float>(mapSize);
    const float scale = 1.0F / (radiusM * radiusM * size * size);
    // Rows grow downward, v upward: the mixed term changes its sign.
    Dab dab{.xTx = rounded(uv.x * size),
            .yTx = rounded((1.0F - uv.y) * size),
            .a = metric.e * scale,
            .b = -metric.f * scale,
            .c = metric.g * scale};
    limitAxes(dab, kThinnestTx, size);
    return dab;
}

Dab mirroredInU(Dab dab, int mapSize)
{
    dab.xTx = static_cast<float>(mapSize) - dab.xTx;
    dab.b = -dab.b;
    return dab;
}

Dab onMapOf(Dab dab, int from, int to)
{
    const float scale = static_cast<float>(to) / static_cast<float>(from);
    dab.xTx *= scale;
    dab.yTx *= scale;
    dab.a /= scale * scale;
    dab.b /= scale * scale;
    dab.c /= scale * scale;
    return dab;
}

} // namespace hairpaint::model
