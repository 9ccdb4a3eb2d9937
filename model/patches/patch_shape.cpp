// Sums over the texels of a patch.
#include "model/patches/patch_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numbers>

namespace hairpaint::model {

namespace {

constexpr int kTileSide = sim::TiledRaster::kTileSize;

/// The longest direction of the patch in the plane across `normal`: the greater eigenvector of its spread.
glm::vec3 longDirection(const PatchShape& shape, glm::vec3 middle, const glm::mat3& frame)
{
    float xx = 0.0F;
    float xy = 0.0F;
    float yy = 0.0F;
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const glm::vec3 from = shape.points[i].positionHd - middle;
        const float x = glm::dot(from, frame[0]);
        const float y = glm::dot(from, frame[1]);
        xx += shape.areasM2[i] * x * x;
        xy += shape.areasM2[i] * x * y;
        yy += shape.areasM2[i] * y * y;
    }
    const float half = 0.5F * (xx - yy);
    const float root = std::sqrt(half * half + xy * xy);
    if (root < 0.1F * (xx + yy))
        return frame[0]; // As wide as it is long.
    glm::vec2 along(half + root, xy);
    if (glm::dot(along, along) < 1e-3F * root * root)
        along = glm::vec2(0.0F, 1.0F);
    along = glm::normalize(along);
    return frame[0] * along.x + frame[1] * along.y;
}

/// How far the patch goes from its middle along a unit vector, to both sides.
float halfExtent(const PatchShape& shape, glm::vec3 middle, glm::vec3 along)
{
    float furthest = 0.0F;
    for (const sim::SurfacePoint& point : shape.points)
        furthest = std::max(furthest, std::abs(glm::dot(point.positionHd - middle, along)));
    return furthest;
}

void sizeTo(Worn& worn, float radiusM)
{
    const WornSpec& spec = wornSpec(worn.kind);
    worn.shape.semiAxesM = std::clamp(radiusM, spec.leastRadiusM, spec.greatestRadiusM) * spec.proportions;
}

void tieOnPatch(Worn& worn, const PatchShape& shape, const sim::Skin& skin)
{
    constexpr float kFarM = 0.5F;
    constexpr glm::vec3 kUpAndBack(0.0F, 0.3F, -0.5F);
    // A patch on one side is flat, and its normal decides; one around the head has next to no mean normal.
    const glm::vec3 out = glm::normalize(shape.meanNormalHd + kUpAndBack * (1.0F - glm::length(shape.meanNormalHd)));
    const std::optional<sim::SurfacePoint> hit =
        skin.pick({.originHd = shape.middleHd + out * kFarM, .directionHd = -out});
    standOn(worn, hit ? *hit : pointNearest(shape, shape.middleHd));
}

void bandOnPatch(Worn& worn, const PatchShape& shape)
{
    constexpr float kAside = 0.35F;
    sim::SurfacePoint top = pointNearest(shape, shape.middleHd + 0.1F * shape.meanNormalHd);
    // From ear to ear where it was painted over the middle.
    if (std::abs(top.normalHd.x) < kAside)
        top.normalHd = glm::normalize(glm::vec3(0.0F, top.normalHd.y, top.normalHd.z));
    standOn(worn, top);
    const glm::vec3 across = worn.shape.rotation * glm::vec3(0.0F, 1.0F, 0.0F);
    float spread = 0.0F;
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const float from = glm::dot(shape.points[i].positionHd - top.positionHd, across);
        spread += shape.areasM2[i] * from * from;
    }
    constexpr float kHalfWidthOfSpread = 1.7320508F; // Half width over standard deviation of an even strip: sqrt(3).
    worn.shape.semiAxesM.y = std::clamp(kHalfWidthOfSpread * std::sqrt(spread / shape.areaM2), 0.003F, 0.03F);
}

} // namespace

std::optional<PatchShape> shapeOf(const sim::PatchLabels& labels, std::size_t patch)
{
    constexpr std::uint32_t kMostPoints = 1200;
    const sim::Patch& of = labels.patches()[patch];
    const sim::SkinIslands& islands = *labels.islands();
    const std::uint32_t stride = std::max(1U, of.texels / kMostPoints);
    const float texelUv = 1.0F / static_cast<float>(islands.size());
    const int across = islands.size() / kTileSide;
    PatchShape shape;
    std::uint32_t seen = 0;
    for (const auto& [index, part] : of.parts) {
        const std::vector<std::uint16_t>& parts = labels.tile(index).parts;
        for (std::size_t texel = 0; texel < parts.size(); ++texel) {
            if (parts[texel] != part || seen++ % stride != 0)
                continue;
            const int column = index % across * kTileSide + static_cast<int>(texel) % kTileSide;
            const int row = index / across * kTileSide + static_cast<int>(texel) / kTileSide;
            const auto x = static_cast<float>(column);
            const auto y = static_cast<float>(row);
            const auto point = islands.skin()->atUv({(x + 0.5F) * texelUv, 1.0F - (y + 0.5F) * texelUv});
            if (!point)
                continue;
            const float areaM2 =
                glm::length(glm::cross(point->dPduHd, point->dPdvHd)) * texelUv * texelUv * static_cast<float>(stride);
            if (!(areaM2 > 0.0F))
                continue;
            shape.points.push_back(*point);
            shape.areasM2.push_back(areaM2);
            shape.areaM2 += areaM2;
            shape.middleHd += areaM2 * point->positionHd;
            shape.meanNormalHd += areaM2 * point->normalHd;
        }
    }
    if (shape.points.empty())
        return std::nullopt;
    shape.middleHd /= shape.areaM2;
    shape.meanNormalHd /= shape.areaM2;
    return shape;
}

const sim::SurfacePoint& pointNearest(const PatchShape& shape, glm::vec3 positionHd)
{
    std::size_t nearest = 0;
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const glm::vec3 from = shape.points[i].positionHd - positionHd;
        if (glm::dot(from, from) < least) {
            least = glm::dot(from, from);
            nearest = i;
        }
    }
    return shape.points[nearest];
}

void wearOnPatch(Worn& worn, const PatchShape& shape, const sim::Skin& skin)
{
    const WornSpec& spec = wornSpec(worn.kind);
    if (spec.tie) {
        tieOnPatch(worn, shape, skin);
        return;
    }
    if (spec.fitted != nullptr) {
        bandOnPatch(worn, shape);
        return;
    }
    const sim::SurfacePoint& middle = pointNearest(shape, shape.middleHd);
    if (!spec.alongPatch) {
        sizeTo(worn, std::sqrt(shape.areaM2 / std::numbers::pi_v<float>));
        standOn(worn, middle);
        return;
    }
    standOn(worn, middle);
    const glm::mat3 frame = glm::mat3_cast(worn.shape.rotation);
    const glm::vec3 along = longDirection(shape, middle.positionHd, frame);
    sizeTo(worn, halfExtent(shape, middle.positionHd, along));
    standOn(worn, middle);
    worn.shape.rotation = glm::normalize(glm::quat_cast(glm::mat3(along, glm::cross(frame[2], along), frame[2])));
}

} // namespace hairpaint::model
