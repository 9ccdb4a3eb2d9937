// Grips of worn things, and what dragging them does.
#include "view/head_area/worn_drag.h"

#include "view/editing/editor_state.h"
#include "view/head_area/head_scene.h"

#include <QWidget>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace hairpaint::view {

namespace {

constexpr double kGripPx = 6.0;
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

/// How far along a line from `from` lies the point that is nearest to the ray; none where it is seen from its end.
std::optional<float> alongLine(glm::vec3 from, glm::vec3 unit, const sim::RayHd& ray)
{
    const float cosine = glm::dot(unit, ray.directionHd);
    const float sine2 = 1.0F - cosine * cosine;
    if (sine2 < kSeenFromItsEnd)
        return std::nullopt;
    const glm::vec3 between = from - ray.originHd;
    return (cosine * glm::dot(ray.directionHd, between) - glm::dot(unit, between)) / sine2;
}

/// Where the ray first meets one of a thing's surfaces, m from its origin.
std::optional<float> firstMeeting(const sim::RayHd& ray, const sim::Ellipsoid& shape,
                                  std::span<const rendering::Solid> surfaces)
{
    constexpr float kNone = std::numeric_limits<float>::max();
    float firstM = kNone;
    for (const rendering::Solid& solid : surfaces)
        firstM = std::min(firstM, meetingAlong(ray, shape, *solid.mesh, solid.open).value_or(kNone));
    return firstM < kNone ? std::optional(firstM) : std::nullopt;
}

} // namespace

std::vector<model::Worn> outlinedWorn(const EditorState& editor)
{
    const model::Project& project = editor.document().project();
    if (editor.options().collidersShown())
        return project.worn;
    const model::Worn* chosen = project.wornThing(editor.options().chosenWorn());
    return chosen != nullptr ? std::vector{*chosen} : std::vector<model::Worn>();
}

bool isBehindHead(const model::Worn& worn, const HeadScene& scene, const HeadSight& sight)
{
    const std::optional<QPointF> at =
        wornSpec(worn.kind).drawn() ? scene.positionOf(worn.shape.centreHd) : std::nullopt;
    const std::optional<sim::SurfacePoint> skin = at ? scene.skinAt(*at) : std::nullopt;
    if (!skin)
        return false;
    const glm::vec3 eyeHd = inHead(rayThrough(sight.camera, *at, sight.size), sight.pose).originHd;
    const glm::vec3& semiAxesM = worn.shape.semiAxesM;
    const float reachM = wornSpec(worn.kind).reach * std::max({semiAxesM.x, semiAxesM.y, semiAxesM.z});
    return glm::distance(eyeHd, skin->positionHd) < glm::distance(eyeHd, worn.shape.centreHd) - reachM;
}

HeadSight WornDrag::sight() const
{
    return {.camera = m_scene.camera(), .pose = m_scene.shownPose(), .size = QSizeF(m_area.size())};
}

/// Ends of the chosen one's axes come first, then its outline, then the nearest of the other outlines, then bodies.
WornDrag::Grip WornDrag::gripAt(QPointF position) const
{
    const HeadSight now = sight();
    const model::Id chosen = m_editor.options().chosenWorn();
    const model::Worn* handled = m_editor.document().project().wornThing(chosen);
    if (handled != nullptr && !isBehindHead(*handled, m_scene, now))
        for (const auto& [end, at] : handlesOf(*handled, now))
            if (std::hypot(at.x() - position.x(), at.y() - position.y()) < kGripPx)
                return {.id = chosen, .end = end};
    model::Id outlined = 0;
    double nearest = kGripPx;
    for (const model::Worn& worn : outlinedWorn(m_editor)) {
        if (isBehindHead(worn, m_scene, now))
            continue;
        for (const QPolygonF& outline : outlinesOf(worn.shape, now)) {
            const double distance = distanceTo(outline, position);
            if (distance < kGripPx && chosen == worn.id)
                return {.id = worn.id};
            if (distance < nearest) {
                nearest = distance;
                outlined = worn.id;
            }
        }
    }
    return {.id = outlined != 0 ? outlined : bodyAt(position)};
}

model::Id WornDrag::bodyAt(QPointF position) const
{
    const std::vector<model::Worn>& all = m_editor.document().project().worn;
    if (std::ranges::none_of(all, [](const model::Worn& worn) { return wornSpec(worn.kind).drawn(); }))
        return 0;
    const HeadSight now = sight();
    const sim::RayHd ray = inHead(rayThrough(now.camera, position, now.size), now.pose);
    const std::optional<sim::SurfacePoint> skin = m_scene.skinAt(position);
    float nearestM = skin ? glm::distance(ray.originHd, skin->positionHd) : std::numeric_limits<float>::max();
    model::Id nearest = 0;
    std::span<const rendering::Solid> solids = m_scene.solids();
    for (const model::Worn& worn : all) {
        const model::WornSpec& spec = wornSpec(worn.kind);
        if (!spec.drawn())
            continue;
        const std::span<const rendering::Solid> own = solids.first(std::min(surfaceCount(worn), solids.size()));
        solids = solids.subspan(own.size());
        sim::Ellipsoid around = worn.shape;
        around.semiAxesM *= spec.reach;
        std::optional<float> entryM = entryAlong(ray, around);
        if (entryM && spec.stands && !own.empty())
            entryM = firstMeeting(ray, worn.shape, own);
        if (entryM && *entryM < nearestM) {
            nearestM = *entryM;
            nearest = worn.id;
        }
    }
    return nearest;
}

bool WornDrag::press(const PointerSample& sample)
{
    const Grip grip = gripAt(sample.position);
    const model::Project& project = m_editor.document().project();
    if (grip.id == 0) {
        const model::Worn* chosen = project.wornThing(m_editor.options().chosenWorn());
        if (chosen != nullptr && wornSpec(chosen->kind).drawn())
            m_editor.options().setChosenWorn(0);
        return false;
    }
    m_grip = grip;
    m_pressed = sample;
    m_over.reset();
    m_before = *project.wornThing(grip.id);
    m_editor.options().setChosenWorn(grip.id);
    return true;
}

void WornDrag::move(const PointerSample& sample)
{
    if (m_editor.document().project().wornThing(m_grip.id) == nullptr)
        return;
    const model::WornSpec& spec = wornSpec(m_before.kind);
    if (spec.stands && (m_grip.end == kTurnEnd || (m_grip.end == kNoEnd && !isShiftHeld()))) {
        show(spec.moveStep, m_grip.end == kTurnEnd ? turned(sample) : overSkin(sample));
        return;
    }
    const bool sizes = m_grip.end != kNoEnd || isShiftHeld();
    m_editor.document().show(
        m_edit, {.text = model::wornText(sizes ? spec.sizeStep : spec.moveStep)},
        {.aspect = model::Change::Aspect::Environment},
        [id = m_grip.id, sizes, now = sizes ? sized(sample) : moved(sample)](model::Project& project) {
            model::Worn* worn = project.wornThing(id);
            if (worn == nullptr)
                return;
            worn->shape = now;
            if (sizes)
                holdSize(*worn);
            else if (worn->patch)
                worn->patch->placedByHand = true;
            if (!sizes)
                anchorWorn(*worn, project.head ? project.head->skin.get() : nullptr);
        });
}

void WornDrag::show(const char* step, const model::Worn& now)
{
    m_editor.document().show(m_edit, {.text = model::wornText(step)}, {.aspect = model::Change::Aspect::Environment},
                             [now](model::Project& project) {
                                 if (model::Worn* worn = project.wornThing(now.id))
                                     *worn = now;
                             });
}

/// Under the pointer as it was gripped; where that leaves the head, as it was last.
model::Worn WornDrag::overSkin(const PointerSample& sample)
{
    const model::Project& shown = m_editor.document().project();
    model::Worn now = m_before;
    if (shown.head == nullptr || shown.head->skin == nullptr)
        return now;
    const sim::SurfacePoint from = anchorPoint(m_before, *shown.head->skin);
    const QPointF at = m_scene.positionOf(from.positionHd).value_or(m_pressed.position);
    if (const std::optional<sim::SurfacePoint> to = m_scene.skinAt(at + (sample.position - m_pressed.position)))
        m_over = to;
    if (m_over)
        carryTo(now, from, *m_over);
    return now;
}

/// Its z goes where the pointer is, on a ball around it; with Shift it turns about its z.
model::Worn WornDrag::turned(const PointerSample& sample) const
{
    const HeadSight now = sight();
    model::Worn worn = m_before;
    const glm::vec3 centreHd = m_before.shape.centreHd;
    const glm::quat before = glm::normalize(m_before.shape.rotation);
    const glm::vec3 z = before * glm::vec3(0.0F, 0.0F, 1.0F);
    if (worn.patch)
        worn.patch->placedByHand = true;
    if (isShiftHeld()) {
        constexpr float kRadPerPx = 0.02F;
        const auto angle = static_cast<float>(sample.position.x() - m_pressed.position.x()) * kRadPerPx;
        worn.shape.rotation = glm::normalize(glm::angleAxis(angle, z) * before);
        return worn;
    }
    const float reachM = glm::distance(turnEndHd(m_before), centreHd);
    const sim::RayHd ray = inHead(rayThrough(now.camera, sample.position, now.size), now.pose);
    const float alongM = glm::dot(centreHd - ray.originHd, ray.directionHd);
    const glm::vec3 beside = ray.originHd + ray.directionHd * alongM - centreHd;
    const float rest = reachM * reachM - glm::dot(beside, beside);
    const glm::vec3 to = glm::normalize(beside - ray.directionHd * std::sqrt(std::max(rest, 0.0F)));
    worn.shape.rotation = glm::normalize(glm::quat(z, to) * before);
    return worn;
}

sim::Ellipsoid WornDrag::moved(const PointerSample& sample) const
{
    const HeadSight now = sight();
    const sim::Ellipsoid& before = m_before.shape;
    const glm::vec3 eyeWo = now.camera.eyeWo();
    const glm::vec3 forward = glm::normalize(now.camera.targetWo - eyeWo);
    const float depthM = glm::dot(inWorld(before.centreHd, now.pose) - eyeWo, forward);
    const auto inPlane = [&](QPointF position) {
        const glm::vec3 ray = rayThrough(now.camera, position, now.size).directionWo;
        return eyeWo + ray * (depthM / std::max(glm::dot(ray, forward), 1e-3F));
    };
    const glm::vec3 displacementWo = inPlane(sample.position) - inPlane(m_pressed.position);
    sim::Ellipsoid shape = before;
    shape.centreHd =
        glm::clamp(before.centreHd + glm::conjugate(now.pose.rotation) * displacementWo, -kFurthestM, kFurthestM);
    return shape;
}

sim::Ellipsoid WornDrag::sized(const PointerSample& sample) const
{
    const HeadSight now = sight();
    const sim::Ellipsoid& before = m_before.shape;
    const model::WornSpec& spec = wornSpec(m_before.kind);
    const auto bounded = [&spec](glm::vec3 semiAxesM) {
        return glm::clamp(semiAxesM, spec.leastRadiusM, spec.greatestRadiusM);
    };
    sim::Ellipsoid shape = before;
    if (m_grip.end == kNoEnd) {
        const QPointF centre =
            project(now.camera, inWorld(before.centreHd, now.pose), now.size).value_or(m_pressed.position);
        const auto from = [centre](QPointF at) { return std::hypot(at.x() - centre.x(), at.y() - centre.y()); };
        const double scale = from(sample.position) / std::max(from(m_pressed.position), 1.0);
        shape.semiAxesM = bounded(before.semiAxesM * static_cast<float>(scale));
        return shape;
    }
    const glm::vec3 axis = axisToEnd(before, m_grip.end);
    const auto along = [&](QPointF at) {
        return alongLine(before.centreHd, axis, inHead(rayThrough(now.camera, at, now.size), now.pose));
    };
    const std::optional<float> start = along(m_pressed.position);
    const std::optional<float> end = along(sample.position);
    if (!start || !end)
        return shape;
    const int own = m_grip.end / 2;
    const float radiusM = std::max(before.semiAxesM[own] + *end - *start, spec.leastRadiusM);
    if (spec.handles == model::WornHandles::Radius || m_pressed.modifiers.testFlag(Qt::ShiftModifier))
        shape.semiAxesM *= radiusM / before.semiAxesM[own];
    else
        shape.semiAxesM[own] = radiusM;
    shape.semiAxesM = bounded(shape.semiAxesM);
    return shape;
}

} // namespace hairpaint::view
