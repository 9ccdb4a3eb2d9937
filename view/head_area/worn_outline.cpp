// Ellipses, the ends of axes, and rays that meet the shape.
#include "view/head_area/worn_outline.h"

#include <cmath>
#include <numbers>

namespace hairpaint::view {

std::vector<QPolygonF> outlinesOf(const sim::Ellipsoid& shape, const HeadSight& sight)
{
    constexpr int kCorners = 64;
    std::vector<QPolygonF> outlines;
    for (int axis = 0; axis < 3; ++axis) {
        QPolygonF ellipse;
        for (int i = 0; i <= kCorners; ++i) {
            const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kCorners;
            glm::vec3 own(0.0F);
            own[(axis + 1) % 3] = std::cos(angle);
            own[(axis + 2) % 3] = std::sin(angle);
            const glm::vec3 positionHd = shape.centreHd + shape.rotation * (own * shape.semiAxesM);
            const std::optional<QPointF> at = project(sight.camera, inWorld(positionHd, sight.pose), sight.size);
            if (!at)
                break;
            ellipse.push_back(*at);
        }
        if (ellipse.size() > kCorners)
            outlines.push_back(std::move(ellipse));
    }
    return outlines;
}

glm::vec3 axisToEnd(const sim::Ellipsoid& shape, int end)
{
    glm::vec3 own(0.0F);
    own[end / 2] = end % 2 == 0 ? 1.0F : -1.0F;
    return shape.rotation * own;
}

glm::vec3 turnEndHd(const model::Worn& worn)
{
    constexpr float kOffM = 0.02F;
    const glm::vec3 z = glm::normalize(worn.shape.rotation) * glm::vec3(0.0F, 0.0F, 1.0F);
    return worn.shape.centreHd + z * (worn.shape.semiAxesM.z + kOffM);
}

std::vector<WornHandle> handlesOf(const model::Worn& worn, const HeadSight& sight)
{
    constexpr int kEnds = 6;
    constexpr float kAcross = 0.5F; // Squared sine; of three axes at least two lie as much across the view.
    const glm::vec3 eyeWo = sight.camera.eyeWo();
    const glm::vec3 view = glm::normalize(inWorld(worn.shape.centreHd, sight.pose) - eyeWo);
    std::vector<WornHandle> handles;
    for (int end = 0; end < kEnds; ++end) {
        const glm::vec3 axis = axisToEnd(worn.shape, end);
        const float cosine = glm::dot(sight.pose.rotation * axis, view);
        if (wornSpec(worn.kind).stands && end / 2 == 2)
            continue; // It is turned by that axis.
        if (wornSpec(worn.kind).drawn() && 1.0F - cosine * cosine < kAcross)
            continue;
        const glm::vec3 endHd = worn.shape.centreHd + axis * worn.shape.semiAxesM[end / 2];
        if (const auto at = project(sight.camera, inWorld(endHd, sight.pose), sight.size))
            handles.push_back({.end = end, .at = *at});
    }
    if (wornSpec(worn.kind).stands)
        if (const auto at = project(sight.camera, inWorld(turnEndHd(worn), sight.pose), sight.size))
            handles.push_back({.end = kTurnEnd, .at = *at});
    return handles;
}

std::optional<float> meetingAlong(const sim::RayHd& ray, const sim::Ellipsoid& shape, const sim::HeadMesh& mesh,
                                  bool open)
{
    const glm::quat back = glm::conjugate(glm::normalize(shape.rotation));
    const glm::vec3 origin = back * (ray.originHd - shape.centreHd) / shape.semiAxesM;
    const glm::vec3 direction = back * ray.directionHd / shape.semiAxesM;
    std::optional<float> nearest;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::vec3& a = mesh.positionsHd[triangle.x];
        const glm::vec3 ab = mesh.positionsHd[triangle.y] - a;
        const glm::vec3 ac = mesh.positionsHd[triangle.z] - a;
        const glm::vec3 across = glm::cross(direction, ac);
        const float facing = glm::dot(ab, across);
        if (facing == 0.0F || (facing < 0.0F && !open))
            continue; // Seen from behind.
        const float side = facing < 0.0F ? -1.0F : 1.0F;
        const float determinant = side * facing;
        const glm::vec3 from = side * (origin - a);
        const float u = glm::dot(from, across);
        const glm::vec3 other = glm::cross(from, ab);
        const float v = glm::dot(direction, other);
        if (u < 0.0F || v < 0.0F || u + v > determinant)
            continue;
        const float distanceM = glm::dot(ac, other) / determinant;
        if (distanceM > 0.0F && (!nearest || distanceM < *nearest))
            nearest = distanceM;
    }
    return nearest;
}

std::optional<float> entryAlong(const sim::RayHd& ray, const sim::Ellipsoid& shape)
{
    // In the space in which the shape is the unit ball; distances along the ray stay as they are.
    const glm::quat back = glm::conjugate(glm::normalize(shape.rotation));
    const glm::vec3 origin = back * (ray.originHd - shape.centreHd) / shape.semiAxesM;
    const glm::vec3 direction = back * ray.directionHd / shape.semiAxesM;
    const float a = glm::dot(direction, direction);
    const float b = glm::dot(origin, direction);
    const float discriminant = b * b - a * (glm::dot(origin, origin) - 1.0F);
    if (discriminant < 0.0F)
        return std::nullopt;
    const float distanceM = (-b - std::sqrt(discriminant)) / a;
    return distanceM > 0.0F ? std::optional(distanceM) : std::nullopt;
}

} // namespace hairpaint::view
