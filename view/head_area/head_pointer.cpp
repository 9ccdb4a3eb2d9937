// The drags of the 3D area's pointer.
#include "view/head_area/head_pointer.h"

#include "view/editing/editor_state.h"
#include "view/head_area/head_camera.h"
#include "view/head_area/head_scene.h"
#include "view/head_area/head_turn.h"

#include <QWidget>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace hairpaint::view {

namespace {

model::PictureEvent pictureEvent(const PointerSample& sample)
{
    return {.position = sample.position, .modifiers = sample.modifiers};
}

} // namespace

HeadPointer::HeadPointer(EditorState& editor, const HeadScene& scene, HeadTurn& turn, QWidget& area)
    : m_editor(editor), m_scene(scene), m_turn(turn), m_area(area), m_keys({Qt::Key_Space, Qt::Key_H, Qt::Key_O}),
      m_stroke(editor, scene), m_brushDrag(editor), m_wornDrag(editor, scene, area)
{
    connect(&m_keys, &HeldKeys::changed, this, &HeadPointer::updateCursor);
}

HeadPointer::Drag HeadPointer::dragOf(const PointerSample& pressed)
{
    const bool left = pressed.button == Qt::LeftButton;
    const bool right = pressed.button == Qt::RightButton;
    const bool shift = pressed.modifiers.testFlag(Qt::ShiftModifier);
    if (pressed.button == Qt::MiddleButton || (left && m_keys.holds(Qt::Key_Space)))
        return shift && left ? Drag::Orbit : Drag::Pan;
    if (right && shift)
        return Drag::Light;
    if (m_brushDrag.press(pressed, m_keys))
        return Drag::Brush;
    if (right)
        return Drag::Orbit;
    if (!left)
        return Drag::None;
    if (m_keys.holds(Qt::Key_H))
        return Drag::Turn;
    const bool alt = pressed.modifiers.testFlag(Qt::AltModifier);
    if (!alt && m_wornDrag.press(pressed))
        return Drag::Worn;
    // With Ctrl the value at the skin is taken.
    if (!alt && !pressed.modifiers.testFlag(Qt::ControlModifier) &&
        m_editor.tools().active().pictureHandler() != nullptr)
        return Drag::Picture;
    if (!alt && grabs()) {
        m_grabbed = m_scene.guideNodeAt(pressed.position);
        if (!m_grabbed)
            m_grabbed = m_scene.hairAt(pressed.position);
        return m_grabbed ? Drag::Stroke : Drag::Orbit;
    }
    const bool meets = m_scene.skinAt(pressed.position) || m_scene.overHair(pressed.position);
    return !alt && meets ? Drag::Stroke : Drag::Orbit;
}

void HeadPointer::press(const PointerSample& sample)
{
    if (dragging())
        return;
    m_puffs.interrupt();
    m_pressed = sample;
    m_cameraBefore = m_scene.camera();
    m_grabbed.reset();
    m_drag = dragOf(sample);
    if (m_drag == Drag::Light) {
        m_lightBefore = m_light = m_editor.document().project().light;
    } else if (m_drag == Drag::Turn) {
        m_turn.press();
    } else if (m_drag == Drag::Picture) {
        m_editor.tools().press(pictureEvent(sample));
    } else if (m_drag == Drag::Stroke) {
        hoverAt(sample);
        m_stroke.press(sample, m_grabbed);
    }
    updateCursor();
}

void HeadPointer::move(const PointerSample& sample)
{
    const QPointF moved = sample.position - m_pressed.position;
    switch (m_drag) {
    case Drag::None:
        hoverAt(sample);
        // Hair that is to be grabbed or cut is not blown away.
        if (sample.buttons == Qt::NoButton && !grabs() && m_editor.tools().active().pictureHandler() == nullptr)
            blowAt(sample);
        break;
    case Drag::Stroke:
        hoverAt(sample);
        m_stroke.move(sample);
        break;
    case Drag::Picture:
        m_editor.tools().move(pictureEvent(sample));
        break;
    case Drag::Orbit:
        Q_EMIT cameraWanted(orbited(m_cameraBefore, moved));
        break;
    case Drag::Pan:
        Q_EMIT cameraWanted(panned(m_cameraBefore, moved, QSizeF(m_area.size())));
        break;
    case Drag::Light:
        dragLight(moved);
        break;
    case Drag::Turn:
        m_turn.drag(m_scene.camera(), moved);
        break;
    case Drag::Brush:
        m_brushDrag.move(sample);
        Q_EMIT statusText(brushText(m_editor.tools().settings()));
        break;
    case Drag::Worn:
        m_wornDrag.move(sample);
        break;
    }
}

void HeadPointer::release(const PointerSample& sample)
{
    constexpr double kClickPx = 4.0; // A press that moves less is a click.
    if (!dragging() || sample.button != m_pressed.button)
        return;
    const Drag drag = std::exchange(m_drag, Drag::None);
    const QPointF moved = sample.position - m_pressed.position;
    if (drag == Drag::Stroke) {
        m_stroke.release(sample);
    } else if (drag == Drag::Picture) {
        m_editor.tools().release(pictureEvent(sample));
    } else if (drag == Drag::Worn) {
        m_wornDrag.release();
    } else if (drag == Drag::Turn) {
        m_turn.release();
    } else if (drag == Drag::Light && m_light != m_lightBefore) {
        Q_EMIT lightWanted(m_light, true);
    } else if (drag == Drag::Orbit && sample.button == Qt::RightButton && std::hypot(moved.x(), moved.y()) < kClickPx) {
        Q_EMIT cameraWanted(m_cameraBefore);
        Q_EMIT contextMenuWanted(m_area.mapToGlobal(sample.position.toPoint()));
    }
    if (drag == Drag::Orbit && std::hypot(moved.x(), moved.y()) >= kClickPx)
        Q_EMIT viewTurned();
    hoverAt(sample);
    updateCursor();
}

void HeadPointer::leave()
{
    m_puffs.interrupt();
    m_hovering.reset();
    const std::optional<HoverPoint>& hover = m_editor.hover().at();
    if (!dragging() && hover && hover->area == model::Area::Head)
        m_editor.hover().set(std::nullopt);
}

void HeadPointer::follow(const rendering::Camera& camera)
{
    if (camera == m_shownCamera)
        return;
    m_shownCamera = camera;
    if (!dragging() && m_hovering)
        hoverAt(*m_hovering);
}

bool HeadPointer::handleKey(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
    if (key == Qt::Key_Escape && m_drag == Drag::Worn) {
        m_drag = Drag::None;
        m_wornDrag.cancel();
        return true;
    }
    if (m_editor.tools().key(key, modifiers)) {
        if ((m_drag == Drag::Stroke || m_drag == Drag::Picture) && !m_editor.tools().stroking())
            m_drag = Drag::None;
        return true;
    }
    if (key != Qt::Key_Escape || m_drag != Drag::Light)
        return false;
    m_drag = Drag::None;
    Q_EMIT lightWanted(m_lightBefore, true);
    Q_EMIT lightDragged();
    return true;
}

std::optional<model::LightSettings> HeadPointer::draggedLight() const
{
    return m_drag == Drag::Light ? std::optional(m_light) : std::nullopt;
}

void HeadPointer::dragLight(QPointF pixels)
{
    constexpr float kRadPerPx = 0.01F;
    constexpr float kMost = std::numbers::pi_v<float> / 2.0F;
    m_light.azimuthRad =
        std::remainder(m_lightBefore.azimuthRad + static_cast<float>(pixels.x()) * kRadPerPx, 4.0F * kMost);
    m_light.elevationRad =
        std::clamp(m_lightBefore.elevationRad - static_cast<float>(pixels.y()) * kRadPerPx, -kMost, kMost);
    Q_EMIT lightDragged();
    Q_EMIT lightWanted(m_light, false);
}

bool HeadPointer::grabs() const
{
    return m_editor.tools().active().hairHandler() != nullptr;
}

void HeadPointer::hoverAt(const PointerSample& sample)
{
    m_hovering = sample;
    m_overWorn = m_wornDrag.reaches(sample.position);
    updateCursor();
    // Where hair is grabbed, or can be, the ring says which roots go along.
    std::optional<sim::SurfacePoint> point;
    if (m_drag == Drag::Stroke && m_grabbed)
        point = m_grabbed->root;
    else if (const auto node = grabs() ? m_scene.guideNodeAt(sample.position) : std::nullopt)
        point = node->root; // The hairs that are offered stay while one of their nodes is under the pointer.
    else if (const auto hair = grabs() ? m_scene.hairAt(sample.position) : std::nullopt) {
        point = hair->root;
        m_editor.tools().hover(hair);
    } else
        point = m_scene.skinAt(sample.position);
    if (const std::optional<model::OverHair> hair = m_scene.overHair(sample.position))
        m_editor.hover().set(HoverPoint{.area = model::Area::Head,
                                        .uv = hair->root ? hair->root->uv : glm::vec2(0.0F),
                                        .point = hair->root,
                                        .hair = hair});
    else if (point)
        m_editor.hover().set(
            HoverPoint{.area = model::Area::Head, .uv = point->uv, .point = point, .pixelM = m_scene.pixelAt(*point)});
    else
        m_editor.hover().set(std::nullopt);
}

void HeadPointer::blowAt(const PointerSample& sample)
{
    const RayWo ray = rayThrough(m_scene.camera(), sample.position, QSizeF(m_area.size()));
    const std::optional<HoverPoint>& hover = m_editor.hover().at();
    const std::optional<glm::vec3> positionWo =
        pointNearHair(ray, m_scene.shownPose(), hover ? hover->point : std::nullopt);
    if (!positionWo) {
        m_puffs.interrupt();
        return;
    }
    if (const std::optional<Puff> puff = m_puffs.moved(*positionWo, sample.seconds))
        Q_EMIT puffWanted(puff->centreWo, puff->velocity, puff->radiusM);
}

void HeadPointer::updateCursor()
{
    Qt::CursorShape shape = Qt::ArrowCursor;
    const std::optional<HoverPoint>& hover = m_editor.hover().at();
    const bool isKeyHeld = m_keys.holds(Qt::Key_Space) || m_keys.holds(Qt::Key_H);
    const bool isOnWorn = m_overWorn || m_drag == Drag::Worn;
    if (m_drag == Drag::Pan || m_drag == Drag::Orbit || m_drag == Drag::Turn)
        shape = Qt::ClosedHandCursor;
    else if (m_drag == Drag::Light || (isOnWorn && !isKeyHeld))
        shape = Qt::SizeAllCursor;
    else if (isKeyHeld)
        shape = Qt::OpenHandCursor;
    else if ((hover && hover->area == model::Area::Head) || m_editor.tools().active().pictureHandler() != nullptr)
        shape = Qt::CrossCursor; // Drawing may be slow, so the ring alone would lag behind the hand.
    if (m_area.cursor().shape() != shape)
        m_area.setCursor(shape);
}

} // namespace hairpaint::view
