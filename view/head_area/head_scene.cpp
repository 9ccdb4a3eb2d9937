// The 3D area's scene, and what lies where in it.
#include "view/head_area/head_scene.h"

#include "view/editing/editor_state.h"
#include "view/head_area/head_camera.h"
#include "view/head_area/head_turn.h"
#include "view/head_area/scene_light.h"
#include "view/head_area/stage.h"
#include "view/picking/hair_pick.h"

#include <QWidget>

#include <QLineF>

#include <algorithm>
#include <limits>

namespace hairpaint::view {

namespace {

rendering::Ring ringAt(const sim::SurfacePoint& point, float radiusM)
{
    return {.centreHd = point.positionHd, .normalHd = point.normalHd, .radiusM = radiusM};
}

} // namespace

HeadScene::HeadScene(EditorState& editor, const HeadTurn& turn, const QWidget& area)
    : m_editor(editor), m_turn(turn), m_area(area), m_seen([this] { return pictureSource(); })
{}

rendering::Scene HeadScene::withoutRings() const
{
    rendering::Scene scene = m_scene;
    scene.ring.reset();
    scene.mirroredRing.reset();
    return scene;
}

std::optional<rendering::Camera> HeadScene::cameraFor(rendering::StandardView view) const
{
    if (!hasHead())
        return std::nullopt;
    return stageCamera(view, *m_editor.document().project().head, *m_scene.head, m_scene.hair.get());
}

std::optional<rendering::Camera> HeadScene::fittingCamera() const
{
    if (!hasHead())
        return std::nullopt;
    return stageCamera(m_scene.camera, *m_editor.document().project().head, *m_scene.head, m_scene.hair.get());
}

std::optional<rendering::Camera> HeadScene::cameraAtBrush() const
{
    if (!m_brush)
        return std::nullopt;
    const sim::HeadPose pose = shownPose();
    const glm::vec3 positionWo = inWorld(m_brush->positionHd, pose);
    return lookingAt(m_scene.camera, positionWo, pose.rotation * m_brush->normalHd);
}

const sim::Skin* HeadScene::skin() const
{
    const std::shared_ptr<const model::Head>& head = m_editor.document().project().head;
    return head ? head->skin.get() : nullptr;
}

bool HeadScene::refreshHead()
{
    const std::shared_ptr<const model::Head>& head = m_editor.document().project().head;
    const std::shared_ptr<const sim::HeadMesh> before = m_scene.head;
    m_scene.headInMotion.reset();
    if (head)
        m_scene.headInMotion = std::shared_ptr<const sim::HeadMesh>(head->skin, &head->skin->mesh());
    m_scene.head = head && head->shownMesh ? head->shownMesh : m_scene.headInMotion;
    if (m_scene.head == before)
        return false;
    m_scene.hair.reset();
    m_scene.cards.reset();
    return true;
}

bool HeadScene::isOnHead(const sim::StrandFrame& hair) const
{
    return std::ranges::all_of(hair.groups, [skin = skin()](const sim::GroupFrame& group) {
        return !group.groom || !group.groom->roots || !group.groom->roots->skin ||
               group.groom->roots->skin.get() == skin;
    });
}

sim::HeadPose HeadScene::shownPose() const
{
    return m_scene.hair ? m_scene.hair->pose : m_turn.pose();
}

void HeadScene::setEnvironment(const model::Project& project, const model::LightSettings& light)
{
    m_scene.light = sceneLight(light);
    m_scene.skin = sceneSkin(project.skin);
    m_scene.skinTexture = sceneSkinTexture(project);
    const std::shared_ptr<const sim::Skin> skin = project.head != nullptr ? project.head->skin : nullptr;
    const std::vector<rendering::Solid> before =
        skin == m_solidsOn.lock() ? m_scene.solids : decltype(m_scene.solids)();
    m_scene.solids = sceneSolids(project.worn, skin.get(), before);
    std::ranges::move(sceneParts(project.head.get()), std::back_inserter(m_scene.solids));
    m_solidsOn = skin;
    m_scene.background = linearColour(project.background);
}

bool HeadScene::refreshRings()
{
    const bool hadRing = m_scene.ring.has_value();
    m_scene.ring.reset();
    m_scene.mirroredRing.reset();
    const std::vector<sim::SurfacePoint> points = m_editor.hover().ringPoints();
    const float radiusM = m_editor.tools().settings().brushSizeM / 2.0F;
    if (!points.empty())
        m_scene.ring = ringAt(points[0], radiusM);
    if (points.size() > 1)
        m_scene.mirroredRing = ringAt(points[1], radiusM);
    if (const std::optional<HoverPoint>& hover = m_editor.hover().at(); hover && hover->point)
        m_brush = hover->point;
    return hadRing || m_scene.ring;
}

QPolygonF HeadScene::hiddenRing() const
{
    const std::optional<HoverPoint>& hover = m_editor.hover().at();
    if (!hover || hover->area != model::Area::Paint || !hover->point || !m_editor.tools().active().traits().hasRing ||
        !hidden(*hover->point, skin(), m_scene.camera, shownPose()))
        return {};
    return ringSeen(*hover->point, m_editor.tools().settings().brushSizeM / 2.0F, m_scene.camera, shownPose(),
                    QSizeF(m_area.size()));
}

std::optional<sim::SurfacePoint> HeadScene::skinAt(QPointF position) const
{
    if (skin() == nullptr)
        return std::nullopt;
    return skin()->pick(inHead(rayThrough(m_scene.camera, position, QSizeF(m_area.size())), shownPose()));
}

std::optional<sim::SurfacePoint> HeadScene::pointForWorn() const
{
    return m_brush ? m_brush : skinAt(QRectF(m_area.rect()).center());
}

float HeadScene::pixelAt(const sim::SurfacePoint& point) const
{
    constexpr float kLeastCosine = 0.35F;
    const rendering::Camera& camera = m_scene.camera;
    const sim::HeadPose pose = shownPose();
    const glm::vec3 toEye = camera.eyeWo() - inWorld(point.positionHd, pose);
    const float distanceM = std::max(glm::length(toEye), 1e-3F);
    const float cosine = glm::dot(pose.rotation * point.normalHd, toEye) / distanceM;
    return 2.0F * distanceM * std::tan(0.5F * camera.fieldOfViewRad) /
           (std::max(static_cast<float>(m_area.height()), 1.0F) * std::max(cosine, kLeastCosine));
}

std::optional<model::GrabbedHair> HeadScene::hairAt(QPointF position) const
{
    if (!m_scene.hair || !isOnHead(*m_scene.hair))
        return std::nullopt;
    float furthestM = std::numeric_limits<float>::max();
    const glm::vec3 eyeWo = m_scene.camera.eyeWo();
    if (const std::optional<sim::SurfacePoint> skin = skinAt(position))
        furthestM =
            glm::dot(inWorld(skin->positionHd, shownPose()) - eyeWo, glm::normalize(m_scene.camera.targetWo - eyeWo));
    return hairNear(position, *m_scene.hair, m_editor.target().group(), m_scene.camera, QSizeF(m_area.size()),
                    furthestM);
}

std::optional<model::GrabbedHair> HeadScene::guideNodeAt(QPointF position) const
{
    constexpr double kNodePx = 9.0;
    std::optional<model::GrabbedHair> found;
    double nearestPx = kNodePx;
    for (const model::GuideStrand& guide : m_editor.tools().guides()) {
        float alongM = 0.0F;
        for (std::size_t i = 1; i < guide.nodesHd.size(); ++i) {
            alongM += glm::distance(guide.nodesHd[i - 1], guide.nodesHd[i]);
            const std::optional<QPointF> at = positionOf(guide.nodesHd[i]);
            const double awayPx = at ? QLineF(*at, position).length() : kNodePx;
            if (awayPx >= nearestPx)
                continue;
            nearestPx = awayPx;
            found = {.root = guide.root, .positionHd = guide.nodesHd[i], .alongM = alongM};
        }
    }
    return found;
}

PictureSource HeadScene::pictureSource() const
{
    const std::shared_ptr<const model::Head>& head = m_editor.document().project().head;
    const bool shows = m_scene.hair && !m_scene.cards && isOnHead(*m_scene.hair);
    return {.frame = shows ? m_scene.hair : nullptr,
            .group = m_editor.target().group(),
            .camera = m_scene.camera,
            .size = m_area.size(),
            .skin = head ? head->skin : nullptr};
}

std::optional<model::OverHair> HeadScene::overHair(QPointF position, const std::optional<model::OverHair>& began) const
{
    constexpr double kPointerPx = 4.0;
    constexpr float kOwnHairM = 0.02F; ///< Hair so near to its root is painted as the skin below it is.
    const model::ToolTraits& tool = m_editor.tools().active().traits();
    const model::ToolSettings& settings = m_editor.tools().settings();
    if (tool.worksOnHair == nullptr || !tool.worksOnHair(settings) || settings.touch == model::TouchKind::Skin)
        return std::nullopt;
    const std::vector<model::SeenStrand> strands = m_seen.under(position, kPointerPx);
    const auto nearest = std::ranges::min_element(strands, {}, &model::SeenStrand::apart);
    const auto here = [&] {
        const glm::vec3 positionHd = besideHd(began ? began->positionHd : nearest->positionHd, position);
        const Lens lens(m_scene.camera, QSizeF(m_area.size()));
        return model::OverHair{.position = position,
                               .pxPerM = lens.pxPerM(lens.seen(inWorld(positionHd, shownPose())).z),
                               .positionHd = positionHd,
                               .root = nearest != strands.end()
                                           ? std::optional(m_seen.hair()->groom->roots->surfacePoint(nearest->slot))
                                           : std::nullopt};
    };
    // Between strands a stroke goes on.
    if (began && settings.touch == model::TouchKind::Hair)
        return here();
    if (strands.empty())
        return std::nullopt;
    if (settings.touch == model::TouchKind::Seen) {
        const std::optional<sim::SurfacePoint> skin = skinAt(position);
        const float ownM = std::max(kOwnHairM, settings.brushSizeM / 2.0F);
        const auto hanging = std::ranges::count_if(strands, [&](const model::SeenStrand& one) {
            return !skin || glm::distance(one.rootHd, skin->positionHd) > ownM;
        });
        if (2 * static_cast<std::size_t>(hanging) <= strands.size())
            return std::nullopt;
    }
    return here();
}

std::vector<QPolygonF> HeadScene::strandsUnder(const model::OverHair& hair) const
{
    constexpr std::size_t kMost = 80;
    const double radiusPx = 0.5 * m_editor.tools().settings().brushSizeM * hair.pxPerM;
    const std::vector<model::SeenStrand> strands = m_seen.under(hair.position, radiusPx);
    std::vector<QPolygonF> lines;
    for (std::size_t i = 0; i < std::min(kMost, strands.size()); ++i)
        lines.push_back(m_seen.picture().curve(strands[i * strands.size() / std::min(kMost, strands.size())].slot));
    return lines;
}

glm::vec3 HeadScene::besideHd(glm::vec3 positionHd, QPointF position) const
{
    const sim::RayHd ray = inHead(rayThrough(m_scene.camera, position, QSizeF(m_area.size())), shownPose());
    const glm::vec3 eyeWo = m_scene.camera.eyeWo();
    const glm::vec3 viewHd = glm::conjugate(shownPose().rotation) * glm::normalize(m_scene.camera.targetWo - eyeWo);
    const float depthM = glm::dot(positionHd - ray.originHd, viewHd);
    return ray.originHd + ray.directionHd * (depthM / glm::dot(ray.directionHd, viewHd));
}

std::optional<QPointF> HeadScene::positionOf(glm::vec3 positionHd) const
{
    return project(m_scene.camera, inWorld(positionHd, shownPose()), QSizeF(m_area.size()));
}

} // namespace hairpaint::view
