// The 3D area as a widget: its parts, its camera's flight, and what the document, the window and hands tell it.
#include "view/head_area/head_view.h"

#include "view/editing/editor_state.h"
#include "view/head_area/head_camera.h"
#include "view/head_area/head_cover.h"
#include "view/head_area/head_frames.h"
#include "view/head_area/head_pointer.h"
#include "view/head_area/head_scene.h"
#include "view/head_area/head_turn.h"
#include "view/head_area/weather_overlay.h"
#include "view/head_area/worn_edit.h"
#include "view/rendering/card_set.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace hairpaint::view {

HeadView::HeadView(EditorState& state, const Theme& theme, PresenterChoice choice, QWidget* parent)
    : PaintedArea(state, parent), m_state(state), m_turn(new HeadTurn(this)),
      m_scene(std::make_unique<HeadScene>(state, *m_turn, *this)),
      m_pointer(std::make_unique<HeadPointer>(state, *m_scene, *m_turn, *this)),
      m_cover(std::make_unique<HeadCover>(state, *m_scene, theme, *this)),
      m_frames(std::make_unique<HeadFrames>(*m_scene, *this, choice)),
      m_flight([this](const rendering::Camera& camera) {
          m_scene->setCamera(camera);
          m_frames->wake();
      })
{
    setObjectName(QStringLiteral("headArea"));
    m_state.tools().setSeen(&m_scene->seen());
    setMinimumSize(160, 160);
    connectParts();

    refreshHead();
    refreshEnvironment();
    if (const std::optional<rendering::Camera> start = m_scene->cameraFor(rendering::StandardView::ThreeQuarter))
        setCamera(*start);
    layOut();
}

HeadView::~HeadView()
{
    m_state.tools().setSeen(nullptr);
    // The frames report to members that must outlive them.
    m_frames.reset();
}

void HeadView::connectParts()
{
    const WeatherOverlay& weather = m_cover->weather();
    connect(&weather, &WeatherOverlay::windWanted, this, &HeadView::windWanted);
    connect(&weather, &WeatherOverlay::lightWanted, this, &HeadView::lightWanted);
    connect(&weather, &WeatherOverlay::leaveWanted, this, [this] { setWeatherShown(false); });

    const auto refreshAll = [this] {
        refreshRings();
        m_cover->refresh();
    };
    connect(&m_state.document(), &model::Document::changed, this, &HeadView::onDocumentChanged);
    connect(&m_state.hover(), &Hover::changed, this, &HeadView::refreshRings);
    connect(&m_state.tools(), &ToolBox::settingsChanged, this, &HeadView::refreshRings);
    connect(&m_state.options(), &ViewOptions::changed, this, refreshAll);
    connect(&m_state.tools(), &ToolBox::activeChanged, this, refreshAll);
    connect(&m_state.tools(), &ToolBox::overlayChanged, this, [this] { m_cover->refresh(); });

    connect(m_turn, &HeadTurn::poseWanted, this, &HeadView::poseWanted);
    connect(m_pointer.get(), &HeadPointer::cameraWanted, this, &HeadView::setCamera);
    connect(m_pointer.get(), &HeadPointer::lightDragged, this, &HeadView::refreshEnvironment);
    connect(m_pointer.get(), &HeadPointer::lightWanted, this, &HeadView::lightWanted);
    connect(m_pointer.get(), &HeadPointer::puffWanted, this, &HeadView::puffWanted);
    connect(m_pointer.get(), &HeadPointer::viewTurned, this, &HeadView::viewTurned);
    connect(m_pointer.get(), &HeadPointer::statusText, this, &HeadView::statusText);
    connect(m_pointer.get(), &HeadPointer::contextMenuWanted, this, &HeadView::contextMenuWanted);
    connect(m_frames.get(), &HeadFrames::shows, this, &HeadView::follow);
    connect(m_frames.get(), &HeadFrames::frameDrawn, this, &HeadView::frameDrawn);
    connect(m_frames.get(), &HeadFrames::finenessChanged, this, &HeadView::refreshSigns);
    connect(m_frames.get(), &HeadFrames::presenterChanged, this, &HeadView::layOut);
    connect(m_frames.get(), &HeadFrames::glUnavailable, this, &HeadView::glUnavailable);
}

QSize HeadView::sizeHint() const
{
    return {620, 560};
}

void HeadView::setTheme(const Theme& theme)
{
    m_cover->setTheme(theme);
}

void HeadView::setFrame(std::shared_ptr<const sim::StrandFrame> frame)
{
    if (frame && (frame->revision < m_firstRevision || !m_scene->isOnHead(*frame)))
        return; // It belongs to the project or the head before this one.
    m_frames->setHair(std::move(frame));
}

void HeadView::showCards(std::shared_ptr<const rendering::CardSet> cards)
{
    if (cards == m_scene->scene().cards)
        return;
    m_scene->setCards(std::move(cards));
    refreshSigns();
    m_frames->wake();
    Q_EMIT cardsShownChanged(cardsShown());
}

bool HeadView::cardsShown() const
{
    return m_scene->scene().cards != nullptr;
}

const rendering::Camera& HeadView::camera() const
{
    return m_scene->camera();
}

void HeadView::setCamera(const rendering::Camera& camera)
{
    m_flight.stop();
    if (camera == m_scene->camera())
        return;
    m_scene->setCamera(camera);
    m_frames->wake();
}

void HeadView::setView(rendering::StandardView view)
{
    animateTo(m_scene->cameraFor(view));
}

void HeadView::resetCamera()
{
    setView(rendering::StandardView::ThreeQuarter);
    m_turn->turnBack();
}

void HeadView::moveHead(sim::NeckMotion motion)
{
    m_turn->play(motion);
}

void HeadView::fit()
{
    animateTo(m_scene->fittingCamera());
}

void HeadView::turnToBrush()
{
    animateTo(m_scene->cameraAtBrush());
}

void HeadView::addWorn(model::WornKind kind)
{
    if (const std::optional<sim::SurfacePoint> point = m_scene->pointForWorn())
        addWornAt(m_state, kind, *point);
}

std::optional<sim::SurfacePoint> HeadView::pointForWorn() const
{
    return m_scene->pointForWorn();
}

void HeadView::addWornThing(const model::Worn& worn)
{
    view::addWornThing(m_state, worn);
}

void HeadView::mirrorWorn()
{
    mirrorChosenWorn(m_state);
}

void HeadView::addTwinTails()
{
    if (const std::optional<sim::SurfacePoint> point = m_scene->pointForWorn())
        addTwinTailsAt(m_state, *point);
}

void HeadView::removeWorn()
{
    removeChosenWorn(m_state);
}

void HeadView::animateTo(const std::optional<rendering::Camera>& camera)
{
    if (camera)
        m_flight.start(m_scene->camera(), *camera);
}

bool HeadView::awake() const
{
    return m_frames->awake() || m_flight.underWay() || m_turn->moving();
}

bool HeadView::refining() const
{
    return m_frames->refining();
}

rendering::Scene HeadView::pictureScene() const
{
    return m_scene->withoutRings();
}

std::optional<sim::SurfacePoint> HeadView::skinAt(QPointF position) const
{
    return m_scene->skinAt(position);
}

std::optional<QPointF> HeadView::positionOf(glm::vec3 positionHd) const
{
    return m_scene->positionOf(positionHd);
}

QString HeadView::rendererDescription() const
{
    return m_frames->description();
}

bool HeadView::weatherShown() const
{
    return !m_cover->weather().isHidden();
}

void HeadView::setWeatherShown(bool shown)
{
    if (shown == weatherShown())
        return;
    m_cover->weather().setVisible(shown);
    m_cover->layOut();
    if (shown) {
        refreshEnvironment();
        m_cover->weather().setFocus(Qt::OtherFocusReason);
    } else {
        setFocus(Qt::OtherFocusReason);
    }
    Q_EMIT weatherShownChanged(shown);
}

void HeadView::setHairPaused(bool paused)
{
    m_paused = paused;
    m_turn->setPaused(paused);
    refreshSigns();
}

void HeadView::onDocumentChanged(const model::Change& change)
{
    using Aspect = model::Change::Aspect;
    if (change.aspect != Aspect::Environment)
        showCards(nullptr);
    if (change.aspect == Aspect::Everything) {
        m_firstRevision = m_state.document().revision();
        m_ownHairAwaited = true;
        m_scene->setHair(nullptr);
        m_frames->wake();
    }
    if (change.aspect == Aspect::Head || change.aspect == Aspect::Everything) {
        refreshHead();
        m_cover->refresh(); // Its ellipsoids may be others while its mesh is the same.
    }
    if (change.aspect == Aspect::Environment || change.aspect == Aspect::Everything) {
        refreshEnvironment();
        m_cover->refreshWorn();
    }
}

void HeadView::refreshHead()
{
    if (const std::shared_ptr<const model::Head>& head = m_state.document().project().head)
        m_turn->setNeck(sim::neckOf(head->landmarks, head->skin->mesh()));
    const bool hadHead = m_scene->hasHead();
    if (!m_scene->refreshHead())
        return;
    if (hadHead)
        fit();
    m_frames->wake();
}

void HeadView::refreshEnvironment()
{
    const model::Project& project = m_state.document().project();
    m_scene->setEnvironment(project, m_pointer->draggedLight().value_or(project.light));
    m_cover->weather().setValues(project.wind, project.light);
    m_frames->wake();
}

void HeadView::refreshRings()
{
    const bool ringDiffers = m_scene->refreshRings();
    m_cover->refreshRing();
    if (ringDiffers)
        m_frames->wake();
    m_pointer->updateCursor();
}

void HeadView::follow(const Sight& sight)
{
    if (m_ownHairAwaited && sight.hairRevision >= m_firstRevision) {
        m_ownHairAwaited = false;
        Q_EMIT ownHairShown();
    }
    m_cover->follow(sight);
    m_pointer->follow(sight.camera);
}

void HeadView::setLookedAt(std::optional<model::MapKind> map)
{
    m_cover->setLookedAt(map);
}

void HeadView::refreshSigns()
{
    // While something moves, whether the last picture was being refined no longer counts.
    const std::shared_ptr<const rendering::CardSet>& cards = m_scene->scene().cards;
    m_cover->showSigns(m_paused, m_frames->refining() && m_frames->still(), cards ? cards->triangles.size() : 0);
}

void HeadView::layOut()
{
    m_frames->setGeometry(rect());
    m_cover->layOut();
}

void HeadView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_frames->requestDraw();
}

void HeadView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    layOut();
    m_cover->refresh();
    m_frames->wake();
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
    return PaintedArea::event(event);
}

void HeadView::keyPressEvent(QKeyEvent* event)
{
    if (!m_pointer->handleKey(static_cast<Qt::Key>(event->key()), event->modifiers()) &&
        (!weatherShown() || !m_cover->weather().handleKey(event->key(), event->modifiers())))
        QWidget::keyPressEvent(event);
}

void HeadView::pointerPressed(const PointerSample& sample)
{
    if (!m_pointer->dragging())
        m_flight.stop();
    m_pointer->press(sample);
}

void HeadView::pointerMoved(const PointerSample& sample)
{
    m_pointer->move(sample);
}

void HeadView::pointerReleased(const PointerSample& sample)
{
    m_pointer->release(sample);
}

void HeadView::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    m_pointer->leave();
}

void HeadView::wheelEvent(QWheelEvent* event)
{
    constexpr double kZoomPerNotch = 1.15;
    constexpr double kNotch = 120.0;
    const double notches = (event->angleDelta().y() + event->angleDelta().x()) / kNotch;
    if (notches != 0.0)
        setCamera(zoomed(camera(), std::pow(kZoomPerNotch, notches), event->position(), QSizeF(size())));
    event->accept();
}

void HeadView::contextMenuEvent(QContextMenuEvent* event)
{
    // The right button orbits; a click without a drag opens the menu on release.
    if (event->reason() != QContextMenuEvent::Mouse)
        Q_EMIT contextMenuWanted(event->globalPos());
    event->accept();
}

} // namespace hairpaint::view
