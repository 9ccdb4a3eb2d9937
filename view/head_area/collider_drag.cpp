// Grips of ellipsoids, and what dragging them does.
#include "view/head_area/collider_drag.h"

#include "view/editing/editor_state.h"
#include "view/head_area/head_scene.h"

#include <QCoreApplication>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hairpaint::view {

namespace {

constexpr double kGripPx = 6.0;
constexpr float kLeastRadiusM = 0.005F;
constexpr float kGreatestRadiusM = 0.5F;
constexpr float kFurthestM = 1.0F;
constexpr float kSeenFromItsEnd = 0.05F; ///< Squared sine: such an axis has no length on the screen.

double distanceTo(const QPolygonF& line, QPointF position)
{
    double nearest = std::numeric_limits<double>::max();
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        const QPointF edge = line[i + 1] - line[i];
        const QPointF from = position - line[i];
        const double t =
            std::clamp(QPointF::dotProduct(from, edge) / std::max(QPointF::dotProduct(edge, edge), 1e-9), 0.0, 1.0);
        const QPointF away = from - edge * t;
        nearest = std::min(nearest, std::hypot(away.x(), away.y()));
    }
    return nearest;
}

/// How far along a line from `from` lies the place that is nearest to the ray; none where it is seen from its end.
std::optional<float> alongLine(glm::vec3 from, glm::vec3 unit, const sim::RayHd& ray)
{
    const float cosine = glm::dot(unit, ray.directionHd);
    const float sine2 = 1.0F - cosine * cosine;
    if (sine2 < kSeenFromItsEnd)
        return std::nullopt;
    const glm::vec3 between = from - ray.originHd;
    return (cosine * glm::dot(ray.directionHd, between) - glm::dot(unit, between)) / sine2;
}

glm::vec3 bounded(glm::vec3 semiAxesM)
{
    return glm::clamp(semiAxesM, kLeastRadiusM, kGreatestRadiusM);
}

} // namespace

HeadSight ColliderDrag::sight() const
{
    return {.camera = m_scene.camera(), .pose = m_scene.shownPose(), .size = QSizeF(m_area.size())};
}

/// Ends of the chosen one's axes come first, then its outline, then the nearest of the others.
std::optional<ColliderDrag::Grip> ColliderDrag::gripAt(QPointF position) const
{
    if (!m_editor.options().collidersShown())
        return std::nullopt;
    const std::vector<sim::Ellipsoid>& all = m_editor.document().project().ellipsoids;
    const HeadSight now = sight();
    const std::optional<std::size_t> chosen = m_editor.options().chosenCollider();
    for (int end = 0; chosen && end < kColliderEnds; ++end) {
        const std::optional<QPointF> at =
            project(now.camera, inWorld(colliderEnd(all[*chosen], end), now.pose), now.size);
        if (at && std::hypot(at->x() - position.x(), at->y() - position.y()) < kGripPx)
            return Grip{.index = *chosen, .end = end};
    }
    std::optional<Grip> grip;
    double nearest = kGripPx;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const QPolygonF& outline : colliderOutlines(all[i], now)) {
            const double distance = distanceTo(outline, position);
            if (distance < kGripPx && chosen == i)
                return Grip{.index = i};
            if (distance < nearest) {
                nearest = distance;
                grip = Grip{.index = i};
            }
        }
    return grip;
}

bool ColliderDrag::press(const PointerSample& sample)
{
    const std::optional<Grip> grip = gripAt(sample.position);
    if (!grip)
        return false;
    m_grip = *grip;
    m_pressed = sample;
    m_before = m_editor.document().project().ellipsoids[grip->index];
    m_editor.options().setChosenCollider(grip->index);
    return true;
}

void ColliderDrag::move(const PointerSample& sample)
{
    if (m_grip.index >= m_editor.document().project().ellipsoids.size())
        return;
    const bool sizes = m_grip.end || m_pressed.modifiers.testFlag(Qt::ShiftModifier);
    const QString text = sizes ? QCoreApplication::translate("ColliderDrag", "Size collider")
                               : QCoreApplication::translate("ColliderDrag", "Move collider");
    m_editor.document().show(m_edit, {.text = text}, {.aspect = model::Change::Aspect::Environment},
                             [index = m_grip.index, now = sizes ? sized(sample) : moved(sample)](
                                 model::Project& project) { project.ellipsoids.at(index) = now; });
}

sim::Ellipsoid ColliderDrag::moved(const PointerSample& sample) const
{
    const HeadSight now = sight();
    const glm::vec3 eyeWo = now.camera.eyeWo();
    const glm::vec3 forward = glm::normalize(now.camera.targetWo - eyeWo);
    const float depthM = glm::dot(inWorld(m_before.centreHd, now.pose) - eyeWo, forward);
    const auto inPlane = [&](QPointF position) {
        const glm::vec3 ray = rayThrough(now.camera, position, now.size).directionWo;
        return eyeWo + ray * (depthM / std::max(glm::dot(ray, forward), 1e-3F));
    };
    const glm::vec3 displacementWo = inPlane(sample.position) - inPlane(m_pressed.position);
    sim::Ellipsoid ellipsoid = m_before;
    ellipsoid.centreHd =
        glm::clamp(m_before.centreHd + glm::conjugate(now.pose.rotation) * displacementWo, -kFurthestM, kFurthestM);
    return ellipsoid;
}

sim::Ellipsoid ColliderDrag::sized(const PointerSample& sample) const
{
    const HeadSight now = sight();
    const bool all = m_pressed.modifiers.testFlag(Qt::ShiftModifier);
    sim::Ellipsoid ellipsoid = m_before;
    if (!m_grip.end) {
        const QPointF centre =
            project(now.camera, inWorld(m_before.centreHd, now.pose), now.size).value_or(m_pressed.position);
        const auto from = [centre](QPointF at) { return std::hypot(at.x() - centre.x(), at.y() - centre.y()); };
        const double scale = from(sample.position) / std::max(from(m_pressed.position), 1.0);
        ellipsoid.semiAxesM = bounded(m_before.semiAxesM * static_cast<float>(scale));
        return ellipsoid;
    }
    const glm::vec3 axis = colliderAxis(m_before, *m_grip.end);
    const auto along = [&](QPointF at) {
        return alongLine(m_before.centreHd, axis, inHead(rayThrough(now.camera, at, now.size), now.pose));
    };
    const std::optional<float> start = along(m_pressed.position);
    const std::optional<float> end = along(sample.position);
    if (!start || !end)
        return ellipsoid;
    const int own = *m_grip.end / 2;
    const float radiusM = std::max(m_before.semiAxesM[own] + *end - *start, kLeastRadiusM);
    if (all)
        ellipsoid.semiAxesM *= radiusM / m_before.semiAxesM[own];
    else
        ellipsoid.semiAxesM[own] = radiusM;
    ellipsoid.semiAxesM = bounded(ellipsoid.semiAxesM);
    return ellipsoid;
}

} // namespace hairpaint::view
