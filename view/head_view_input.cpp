// The 3D area's pointer, wheel and keys.
#include "view/head/head_view_state.h"
#include "view/head_view.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr double kZoomPerNotch = 1.15;
constexpr double kWheelNotch = 120.0;
constexpr float kLightRadPerPx = 0.01F;
constexpr double kClickPx = 4.0; ///< A press that moves less is a click.
constexpr double kProbePx = 3.0; ///< A gap in the skin narrower than this may be bridged by a stroke.
constexpr int kMostProbes = 400;
constexpr float kBehindM = 0.03F; ///< So much further at the next probe lies behind, or in front of, the last one.

model::ToolEvent toolEvent(const PointerSample& sample, const std::optional<sim::SurfacePoint>& point,
                           glm::vec2& lastUv)
{
    if (point)
        lastUv = point->uv;
    return {.area = model::Area::Head,
            .uv = lastUv,
            .point = point,
            .pressure = sample.pressure,
            .seconds = sample.seconds,
            .modifiers = sample.modifiers};
}

/// Whether a stroke breaks between two neighbouring places of the screen.
bool breaksBetween(const std::optional<sim::SurfacePoint>& a, const std::optional<sim::SurfacePoint>& b)
{
    return a.has_value() != b.has_value() || (a && b && glm::length(a->positionHd - b->positionHd) > kBehindM);
}

PointerSample between(const PointerSample& from, const PointerSample& to, double fraction)
{
    PointerSample sample = to;
    sample.position = from.position + (to.position - from.position) * fraction;
    sample.pressure = from.pressure + (to.pressure - from.pressure) * static_cast<float>(fraction);
    sample.seconds = from.seconds + (to.seconds - from.seconds) * fraction;
    return sample;
}

} // namespace

void HeadView::pointerPressed(const PointerSample& sample)
{
    State& state = *m_state;
    if (state.drag != State::Drag::None)
        return;
    state.turning.stop();
    state.puffs.interrupt();
    state.pressed = sample;
    state.cameraBefore = state.scene.camera;
    const bool left = sample.button == Qt::LeftButton;
    const bool shift = sample.modifiers.testFlag(Qt::ShiftModifier);
    const bool alt = sample.modifiers.testFlag(Qt::AltModifier);
    if (sample.button == Qt::MiddleButton || (left && state.keys.holds(Qt::Key_Space))) {
        state.drag = shift && left ? State::Drag::Orbit : State::Drag::Pan;
    } else if (sample.button == Qt::RightButton && shift) {
        state.drag = State::Drag::Light;
        state.lightBefore = state.light = state.editor.document().project().light;
    } else if (state.brushDrag.press(sample, state.keys)) {
        state.drag = State::Drag::Brush;
    } else if (sample.button == Qt::RightButton) {
        state.drag = State::Drag::Orbit;
    } else if (left && state.keys.holds(Qt::Key_H)) {
        state.drag = State::Drag::Turn;
        state.turningBack.stop();
        state.poseBefore = state.pose;
    } else if (left) {
        const std::optional<sim::SurfacePoint> point = alt ? std::nullopt : skinAt(sample.position);
        state.drag = point ? State::Drag::Stroke : State::Drag::Orbit;
        if (point) {
            hoverAt(sample);
            state.strokeAt = sample;
            state.editor.press(toolEvent(sample, point, state.lastUv));
        }
    }
    updateCursor();
}

void HeadView::pointerMoved(const PointerSample& sample)
{
    State& state = *m_state;
    const QPointF moved = sample.position - state.pressed.position;
    switch (state.drag) {
    case State::Drag::None:
        hoverAt(sample);
        if (sample.buttons == Qt::NoButton)
            blowAt(sample);
        break;
    case State::Drag::Stroke:
        hoverAt(sample);
        strokeTo(sample);
        break;
    case State::Drag::Orbit:
        setCamera(orbited(state.cameraBefore, moved));
        break;
    case State::Drag::Pan:
        setCamera(panned(state.cameraBefore, moved, QSizeF(size())));
        break;
    case State::Drag::Light:
        dragLight(moved);
        break;
    case State::Drag::Turn:
        state.pose = turned(state.poseBefore, state.scene.camera, moved);
        Q_EMIT poseWanted(state.pose);
        break;
    case State::Drag::Brush:
        state.brushDrag.move(sample);
        Q_EMIT statusText(brushText(state.editor.toolSettings()));
        break;
    }
}

void HeadView::pointerReleased(const PointerSample& sample)
{
    State& state = *m_state;
    if (state.drag == State::Drag::None || sample.button != state.pressed.button)
        return;
    const State::Drag drag = std::exchange(state.drag, State::Drag::None);
    const QPointF moved = sample.position - state.pressed.position;
    if (drag == State::Drag::Stroke) {
        PointerSample last = sample;
        last.pressure = state.strokeAt.pressure; // A pen that is lifted has none left.
        strokeTo(last);
        state.editor.release(toolEvent(sample, skinAt(sample.position), state.lastUv));
    } else if (drag == State::Drag::Light && state.light != state.lightBefore) {
        Q_EMIT lightWanted(state.light, true);
    } else if (drag == State::Drag::Orbit && sample.button == Qt::RightButton &&
               std::hypot(moved.x(), moved.y()) < kClickPx) {
        setCamera(state.cameraBefore);
        Q_EMIT contextMenuWanted(mapToGlobal(sample.position.toPoint()));
    }
    hoverAt(sample);
    updateCursor();
}

/// Where the ray misses the skin between two events, or goes on behind, the stroke breaks: the tool gets the last place
/// before, then none, then the first place after.
void HeadView::strokeTo(const PointerSample& sample)
{
    State& state = *m_state;
    if (!state.editor.stroking())
        return;
    const PointerSample from = std::exchange(state.strokeAt, sample);
    const QPointF moved = sample.position - from.position;
    const int steps = std::clamp(static_cast<int>(std::hypot(moved.x(), moved.y()) / kProbePx), 1, kMostProbes);
    PointerSample last = from;
    std::optional<sim::SurfacePoint> lastPoint = skinAt(from.position);
    for (int i = 1; i <= steps; ++i) {
        const PointerSample probe = i == steps ? sample : between(from, sample, static_cast<double>(i) / steps);
        const std::optional<sim::SurfacePoint> point = skinAt(probe.position);
        if (breaksBetween(lastPoint, point)) {
            if (lastPoint)
                state.editor.move(toolEvent(last, lastPoint, state.lastUv));
            state.editor.move(toolEvent(probe, std::nullopt, state.lastUv));
            if (point)
                state.editor.move(toolEvent(probe, point, state.lastUv));
        }
        last = probe;
        lastPoint = point;
    }
    state.editor.move(toolEvent(sample, lastPoint, state.lastUv));
}

void HeadView::dragLight(QPointF pixels)
{
    constexpr float kMost = std::numbers::pi_v<float> / 2.0F;
    State& state = *m_state;
    state.light.azimuthRad =
        std::remainder(state.lightBefore.azimuthRad + static_cast<float>(pixels.x()) * kLightRadPerPx, 4.0F * kMost);
    state.light.elevationRad =
        std::clamp(state.lightBefore.elevationRad - static_cast<float>(pixels.y()) * kLightRadPerPx, -kMost, kMost);
    refreshEnvironment();
    Q_EMIT lightWanted(state.light, false);
}

void HeadView::hoverAt(const PointerSample& sample)
{
    const std::optional<sim::SurfacePoint> point = skinAt(sample.position);
    if (point)
        m_state->editor.setHover(Hover{.area = model::Area::Head, .uv = point->uv, .point = point});
    else
        m_state->editor.setHover(std::nullopt);
}

void HeadView::blowAt(const PointerSample& sample)
{
    const sim::HeadPose pose = m_state->shownPose();
    const RayWo ray = rayThrough(m_state->scene.camera, sample.position, QSizeF(size()));
    const std::optional<Hover>& hover = m_state->editor.hover();
    const std::optional<glm::vec3> positionWo = placeNearHair(ray, pose, hover ? hover->point : std::nullopt);
    if (!positionWo) {
        m_state->puffs.interrupt();
        return;
    }
    if (const std::optional<Puff> puff = m_state->puffs.moved(*positionWo, sample.seconds))
        Q_EMIT puffWanted(puff->centreWo, puff->velocity, puff->radiusM);
}

void HeadView::updateCursor()
{
    const State& state = *m_state;
    Qt::CursorShape shape = Qt::ArrowCursor;
    const std::optional<Hover>& hover = state.editor.hover();
    if (state.drag == State::Drag::Pan || state.drag == State::Drag::Orbit || state.drag == State::Drag::Turn)
        shape = Qt::ClosedHandCursor;
    else if (state.drag == State::Drag::Light)
        shape = Qt::SizeAllCursor;
    else if (state.keys.holds(Qt::Key_Space) || state.keys.holds(Qt::Key_H))
        shape = Qt::OpenHandCursor;
    else if (hover && hover->area == model::Area::Head)
        shape = Qt::CrossCursor; // Drawing may be slow, so the ring alone would lag behind the hand.
    if (cursor().shape() != shape)
        setCursor(shape);
}

void HeadView::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    m_state->puffs.interrupt();
    const std::optional<Hover>& hover = m_state->editor.hover();
    if (m_state->drag == State::Drag::None && hover && hover->area == model::Area::Head)
        m_state->editor.setHover(std::nullopt);
}

void HeadView::wheelEvent(QWheelEvent* event)
{
    const double notches = (event->angleDelta().y() + event->angleDelta().x()) / kWheelNotch;
    if (notches != 0.0)
        setCamera(zoomed(m_state->scene.camera, std::pow(kZoomPerNotch, notches), event->position(), QSizeF(size())));
    event->accept();
}

bool HeadView::event(QEvent* event)
{
    // With the Weather overlay open its keys are its own here too, also those that choose tools elsewhere.
    if (event->type() == QEvent::ShortcutOverride && weatherShown()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (WeatherOverlay::isOurKey(key->key()) &&
            (key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == 0) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void HeadView::keyPressEvent(QKeyEvent* event)
{
    State& state = *m_state;
    if (state.editor.toolKey(static_cast<Qt::Key>(event->key()), event->modifiers())) {
        if (state.drag == State::Drag::Stroke && !state.editor.stroking())
            state.drag = State::Drag::None;
    } else if (event->key() == Qt::Key_Escape && state.drag == State::Drag::Light) {
        state.drag = State::Drag::None;
        Q_EMIT lightWanted(state.lightBefore, true);
        refreshEnvironment();
    } else if (!weatherShown() || !state.weather->handleKey(event->key(), event->modifiers())) {
        QWidget::keyPressEvent(event);
    }
}

void HeadView::contextMenuEvent(QContextMenuEvent* event)
{
    // The right button orbits; a click without a drag opens the menu on release.
    if (event->reason() != QContextMenuEvent::Mouse)
        Q_EMIT contextMenuWanted(event->globalPos());
    event->accept();
}

} // namespace hairpaint::view
