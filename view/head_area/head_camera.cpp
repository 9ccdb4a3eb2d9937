// Orbit, pan, zoom and picking rays.
#include "view/head_area/head_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hairpaint::view {

namespace {

constexpr float kOrbitRadPerPx = 0.0085F;
constexpr float kTurnRadPerPx = 0.008F;
constexpr float kNearestM = 0.06F;
constexpr float kFarthestM = 5.0F;

float aspectOf(QSizeF size)
{
    return static_cast<float>(size.width() / std::max(1.0, size.height()));
}

struct Axes
{
    glm::vec3 right, up;
};

Axes axesOf(const rendering::Camera& camera)
{
    const glm::mat4 view = camera.view();
    return {glm::vec3(view[0][0], view[1][0], view[2][0]), glm::vec3(view[0][1], view[1][1], view[2][1])};
}

/// World metres a pixel covers at the target's depth.
float metresPerPx(const rendering::Camera& camera, QSizeF size)
{
    return 2.0F * camera.distanceM * std::tan(camera.fieldOfViewRad / 2.0F) /
           static_cast<float>(std::max(1.0, size.height()));
}

} // namespace

RayWo rayThrough(const rendering::Camera& camera, QPointF position, QSizeF size)
{
    const auto x = static_cast<float>(2.0 * position.x() / std::max(1.0, size.width()) - 1.0);
    const auto y = static_cast<float>(1.0 - 2.0 * position.y() / std::max(1.0, size.height()));
    const Axes axes = axesOf(camera);
    const glm::vec3 eye = camera.eyeWo();
    const glm::vec3 forward = glm::normalize(camera.targetWo - eye);
    const float half = std::tan(camera.fieldOfViewRad / 2.0F);
    return {eye, glm::normalize(forward + axes.right * (x * half * aspectOf(size)) + axes.up * (y * half))};
}

sim::RayHd inHead(const RayWo& ray, const sim::HeadPose& pose)
{
    const glm::quat back = glm::conjugate(pose.rotation);
    return {back * (ray.originWo - pose.positionWo), back * ray.directionWo};
}

glm::vec3 inWorld(glm::vec3 positionHd, const sim::HeadPose& pose)
{
    return pose.rotation * positionHd + pose.positionWo;
}

std::optional<QPointF> project(const rendering::Camera& camera, glm::vec3 positionWo, QSizeF size)
{
    const glm::vec4 clip = camera.projection(aspectOf(size)) * camera.view() * glm::vec4(positionWo, 1.0F);
    if (clip.w <= 0.0F)
        return std::nullopt;
    return QPointF((static_cast<double>(clip.x / clip.w) * 0.5 + 0.5) * size.width(),
                   (0.5 - static_cast<double>(clip.y / clip.w) * 0.5) * size.height());
}

rendering::Camera orbited(const rendering::Camera& start, QPointF pixels)
{
    constexpr float kMost = std::numbers::pi_v<float> / 2.0F;
    rendering::Camera camera = start;
    camera.azimuthRad =
        std::remainder(start.azimuthRad - static_cast<float>(pixels.x()) * kOrbitRadPerPx, 4.0F * kMost);
    camera.elevationRad =
        std::clamp(start.elevationRad + static_cast<float>(pixels.y()) * kOrbitRadPerPx, -kMost, kMost);
    return camera;
}

rendering::Camera panned(const rendering::Camera& start, QPointF pixels, QSizeF size)
{
    const Axes axes = axesOf(start);
    const float scale = metresPerPx(start, size);
    rendering::Camera camera = start;
    camera.targetWo +=
        (-axes.right * static_cast<float>(pixels.x()) + axes.up * static_cast<float>(pixels.y())) * scale;
    // The head stays in reach.
    camera.targetWo = glm::clamp(camera.targetWo, glm::vec3(-1.0F), glm::vec3(1.0F));
    return camera;
}

rendering::Camera zoomed(const rendering::Camera& camera, double factor, QPointF position, QSizeF size)
{
    rendering::Camera nearer = camera;
    nearer.distanceM = std::clamp(camera.distanceM / static_cast<float>(factor), kNearestM, kFarthestM);
    const Axes axes = axesOf(camera);
    const auto x = static_cast<float>(position.x() - size.width() / 2.0);
    const auto y = static_cast<float>(size.height() / 2.0 - position.y());
    nearer.targetWo += (axes.right * x + axes.up * y) * (metresPerPx(camera, size) - metresPerPx(nearer, size));
    return nearer;
}

rendering::Camera between(const rendering::Camera& from, const rendering::Camera& to, float t)
{
    constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
    rendering::Camera camera;
    camera.targetWo = glm::mix(from.targetWo, to.targetWo, t);
    camera.distanceM = from.distanceM * std::pow(to.distanceM / from.distanceM, t);
    camera.azimuthRad = from.azimuthRad + std::remainder(to.azimuthRad - from.azimuthRad, kTurn) * t;
    camera.elevationRad = glm::mix(from.elevationRad, to.elevationRad, t);
    camera.fieldOfViewRad = glm::mix(from.fieldOfViewRad, to.fieldOfViewRad, t);
    return t >= 1.0F ? to : camera;
}

rendering::Camera lookingAt(const rendering::Camera& camera, glm::vec3 positionWo, glm::vec3 normalWo)
{
    constexpr float kSteepestRad = 1.3F;
    rendering::Camera turned = camera;
    const glm::vec3 normal = glm::normalize(normalWo);
    turned.elevationRad = std::clamp(std::asin(std::clamp(normal.y, -1.0F, 1.0F)), -kSteepestRad, kSteepestRad);
    if (std::hypot(normal.x, normal.z) > 0.05F) // Straight up or down every side is as good.
        turned.azimuthRad = std::atan2(normal.x, normal.z);
    const std::optional<QPointF> seen = project(turned, positionWo, QSizeF(1.0, 1.0));
    if (!seen || !QRectF(0.1, 0.1, 0.8, 0.8).contains(*seen))
        turned.targetWo = positionWo;
    return turned;
}

bool hidden(const sim::SurfacePoint& point, const sim::Skin* skin, const rendering::Camera& camera,
            const sim::HeadPose& pose)
{
    constexpr float kNearM = 0.004F; // The picked point lies on the same part of the skin.
    const glm::vec3 positionWo = inWorld(point.positionHd, pose);
    const glm::vec3 towardPoint = positionWo - camera.eyeWo();
    if (glm::dot(pose.rotation * point.normalHd, towardPoint) >= 0.0F || skin == nullptr)
        return true;
    const std::optional<sim::SurfacePoint> first =
        skin->pick(inHead({camera.eyeWo(), glm::normalize(towardPoint)}, pose));
    return first && glm::distance(first->positionHd, point.positionHd) > kNearM;
}

QPolygonF ringSeen(const sim::SurfacePoint& point, float radiusM, const rendering::Camera& camera,
                   const sim::HeadPose& pose, QSizeF size)
{
    constexpr int kCorners = 48;
    const glm::vec3 normal = glm::normalize(point.normalHd);
    const glm::vec3 aside = std::abs(normal.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::vec3(1.0F, 0.0F, 0.0F);
    const glm::vec3 across = glm::normalize(glm::cross(aside, normal)) * radiusM;
    const glm::vec3 along = glm::cross(normal, across);
    QPolygonF ring;
    for (int i = 0; i < kCorners; ++i) {
        const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / kCorners;
        const glm::vec3 cornerHd = point.positionHd + across * std::cos(angle) + along * std::sin(angle);
        const std::optional<QPointF> corner = project(camera, inWorld(cornerHd, pose), size);
        if (!corner)
            return {};
        ring.push_back(*corner);
    }
    return ring;
}

sim::NeckAngles turned(const sim::NeckAngles& start, const sim::Neck& neck, const rendering::Camera& camera,
                       QPointF pixels)
{
    // What is seen goes with the pointer, so from behind the face goes the opposite direction; from the side it goes as
    // in front.
    constexpr float kFromBehind = -0.1F;
    const float ahead = glm::dot(axesOf(camera).right, neck.acrossHd) < kFromBehind ? -1.0F : 1.0F;
    return sim::withinReach({start.yawRad + static_cast<float>(pixels.x()) * kTurnRadPerPx,
                             start.pitchRad + static_cast<float>(pixels.y()) * kTurnRadPerPx * ahead});
}

} // namespace hairpaint::view
