// What the 3D area's scene holds: head, hair, light, rings, and outlines over it.
#include "view/head_view.h"

#include "view/head/head_view_state.h"
#include "view/head/stage.h"
#include "view/scene_light.h"

#include <algorithm>

namespace hairpaint::view {

namespace {

rendering::Ring ringAt(const sim::SurfacePoint& point, float radiusM)
{
    return {.centreHd = point.positionHd, .normalHd = point.normalHd, .radiusM = radiusM};
}

/// Whether the hair has its roots on that head.
bool grownOn(const sim::StrandFrame& frame, const sim::Skin* skin)
{
    return std::ranges::all_of(frame.groups, [skin](const sim::GroupFrame& group) {
        return !group.groom || !group.groom->roots || !group.groom->roots->skin ||
               group.groom->roots->skin.get() == skin;
    });
}

} // namespace

void HeadView::setFrame(std::shared_ptr<const sim::StrandFrame> frame)
{
    if (frame && !grownOn(*frame, m_state->skin()))
        return; // Of the head before this one.
    const bool moved = m_state->stillness.moved(frame, m_state->scene.camera, size());
    if (m_state->still && !moved)
        return; // A picture that is being refined is worth more than a difference nobody sees.
    m_state->scene.hair = std::move(frame);
    if (moved)
        wake();
    else
        requestDraw();
}

void HeadView::onDocumentChanged(const model::Change& change)
{
    using Aspect = model::Change::Aspect;
    if (change.aspect == Aspect::Head || change.aspect == Aspect::Everything)
        refreshHead();
    if (change.aspect == Aspect::Environment || change.aspect == Aspect::Everything)
        refreshEnvironment();
}

void HeadView::refreshHead()
{
    const std::shared_ptr<const model::Head>& head = m_state->editor.document().project().head;
    const std::shared_ptr<const sim::HeadMesh> before = m_state->scene.head;
    m_state->scene.headInMotion.reset();
    if (head)
        m_state->scene.headInMotion = std::shared_ptr<const sim::HeadMesh>(head->skin, &head->skin->mesh());
    m_state->scene.head = head && head->shownMesh ? head->shownMesh : m_state->scene.headInMotion;
    if (m_state->scene.head == before)
        return;
    m_state->scene.hair.reset();
    if (before && m_state->scene.head)
        fit();
    wake();
}

void HeadView::refreshEnvironment()
{
    const model::Project& project = m_state->editor.document().project();
    m_state->scene.light = sceneLight(m_state->drag == State::Drag::Light ? m_state->light : project.light);
    m_state->scene.background = linearColour(project.background);
    m_state->weather->setValues(project.wind, project.light);
    wake();
}

void HeadView::refreshRings()
{
    rendering::Scene& scene = m_state->scene;
    const EditorState& editor = m_state->editor;
    const bool hadRing = scene.ring.has_value();
    scene.ring.reset();
    scene.mirroredRing.reset();
    if (const std::optional<Hover>& hover = editor.hover(); hover && hover->point && editor.activeTool().hasRing()) {
        const float radiusM = editor.toolSettings().brushSizeM / 2.0F;
        scene.ring = ringAt(*hover->point, radiusM);
        const sim::Skin* skin = m_state->skin();
        if (editor.mirror() && skin != nullptr) {
            if (const std::optional<sim::SurfacePoint> twin = skin->mirrored(*hover->point))
                scene.mirroredRing = ringAt(*twin, radiusM);
        }
    }
    if (editor.hover() && editor.hover()->point)
        m_state->brush = editor.hover()->point;
    refreshGhost();
    if (hadRing || scene.ring)
        wake();
    updateCursor();
}

void HeadView::refreshOverlay()
{
    std::vector<model::OverlayShape> shapes = m_state->editor.activeTool().overlay();
    for (QPolygonF& outline : m_state->editor.selection().outlines())
        shapes.push_back({.uvOutline = std::move(outline), .closed = true, .marching = true});
    m_state->overlay->setShapes(shapes, m_state->skin(), m_state->scene.camera, m_state->shownPose());
    refreshGhost();
}

void HeadView::refreshGhost()
{
    const State& state = *m_state;
    const std::optional<Hover>& hover = state.editor.hover();
    QPolygonF ring;
    if (hover && hover->area == model::Area::Paint && hover->point && state.editor.activeTool().hasRing() &&
        hidden(*hover->point, state.skin(), state.scene.camera, state.shownPose()))
        ring = ringSeen(*hover->point, state.editor.toolSettings().brushSizeM / 2.0F, state.scene.camera,
                        state.shownPose(), QSizeF(size()));
    state.overlay->setGhost(ring);
}

} // namespace hairpaint::view
