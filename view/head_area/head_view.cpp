// The 3D area as a widget: its parts and children, its camera's flight, its drawing and its keys.
#include "view/head_area/head_view.h"

#include "view/editing/editor_state.h"
#include "view/head_area/falling_hair.h"
#include "view/head_area/frame_pacer.h"
#include "view/head_area/frame_presenter.h"
#include "view/head_area/gl_presenter.h"
#include "view/head_area/head_camera.h"
#include "view/head_area/head_overlay.h"
#include "view/head_area/head_pointer.h"
#include "view/head_area/head_scene.h"
#include "view/head_area/head_turn.h"
#include "view/head_area/shown_directions.h"
#include "view/head_area/view_signs.h"
#include "view/head_area/weather_overlay.h"
#include "view/head_area/worn_drag.h"
#include "view/head_area/worn_edit.h"
#include "view/rendering/card_set.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace hairpaint::view {

HeadView::HeadView(EditorState& state, const Theme& theme, PresenterChoice choice, QWidget* parent)
    : PaintedArea(state, parent), m_state(state), m_overlay(new HeadOverlay(theme, this)),
      m_weather(new WeatherOverlay(theme, this)), m_signs(new ViewSigns(this)), m_turn(new HeadTurn(this)),
      m_falling(new FallingHair(this)), m_scene(std::make_unique<HeadScene>(state, *m_turn, *this)),
      m_pointer(std::make_unique<HeadPointer>(state, *m_scene, *m_turn, *this)),
      m_pacer(std::make_unique<FramePacer>()),
      m_directions(std::make_unique<ShownDirections>(state, *m_overlay, [this] { return shown(); })),
      m_flight([this](const rendering::Camera& camera) {
          m_scene->setCamera(camera);
          m_pacer->wake();
      })
{
    setObjectName(QStringLiteral("headArea"));
    m_state.tools().setSeen(&m_scene->seen());
    setMinimumSize(160, 160);
    m_weather->hide();
    connectParts();

    refreshHead();
    refreshEnvironment();
    if (const std::optional<rendering::Camera> start = m_scene->cameraFor(rendering::StandardView::ThreeQuarter))
        setCamera(*start);
    makePresenter(choice);
}

HeadView::~HeadView()
{
    m_state.tools().setSeen(nullptr);
    // Its thread and its context end before what it reports to.
    delete m_presenter;
}

void HeadView::connectParts()
{
    connect(m_weather, &WeatherOverlay::windWanted, this, &HeadView::windWanted);
    connect(m_weather, &WeatherOverlay::lightWanted, this, &HeadView::lightWanted);
    connect(m_weather, &WeatherOverlay::leaveWanted, this, [this] { setWeatherShown(false); });

    connect(&m_state.document(), &model::Document::changed, this, &HeadView::onDocumentChanged);
    connect(&m_state.hover(), &Hover::changed, this, &HeadView::refreshRings);
    connect(&m_state.tools(), &ToolBox::settingsChanged, this, &HeadView::refreshRings);
    connect(&m_state.options(), &ViewOptions::changed, this, [this] {
        refreshRings();
        refreshOverlay();
    });
    connect(&m_state.tools(), &ToolBox::activeChanged, this, [this] {
        refreshRings();
        refreshOverlay();
    });
    connect(&m_state.tools(), &ToolBox::overlayChanged, this, &HeadView::refreshOverlay);

    connect(&m_state.tools(), &ToolBox::hairCutOff, m_falling, &FallingHair::start);
    connect(m_falling, &FallingHair::moved, this,
            [this] { m_overlay->setFalling(m_falling->seen(shown().camera, QSizeF(size()))); });

    connect(m_turn, &HeadTurn::poseWanted, this, &HeadView::poseWanted);
    connect(m_pointer.get(), &HeadPointer::cameraWanted, this, &HeadView::setCamera);
    connect(m_pointer.get(), &HeadPointer::lightDragged, this, &HeadView::refreshEnvironment);
    connect(m_pointer.get(), &HeadPointer::lightWanted, this, &HeadView::lightWanted);
    connect(m_pointer.get(), &HeadPointer::puffWanted, this, &HeadView::puffWanted);
    connect(m_pointer.get(), &HeadPointer::viewTurned, this, &HeadView::viewTurned);
    connect(m_pointer.get(), &HeadPointer::statusText, this, &HeadView::statusText);
    connect(m_pointer.get(), &HeadPointer::contextMenuWanted, this, &HeadView::contextMenuWanted);
    connect(m_pacer.get(), &FramePacer::drawDue, this, &HeadView::draw);
    connect(m_pacer.get(), &FramePacer::stillEnded, this, &HeadView::refreshSigns);
}

void HeadView::makePresenter(PresenterChoice choice)
{
    m_presenter = FramePresenter::make(choice, this);
    connect(m_presenter, &FramePresenter::shows, this, &HeadView::follow);
    connect(m_presenter, &FramePresenter::frameDrawn, this, &HeadView::frameDrawn);
    connect(m_presenter, &FramePresenter::refining, this, [this](bool on) {
        m_refining = on;
        refreshSigns();
    });
    connect(m_presenter, &FramePresenter::failed, this, &HeadView::onPresenterFailed, Qt::QueuedConnection);
    m_presenter->widget().lower();
    m_presenter->widget().show();
    placeChildren();
}

void HeadView::onPresenterFailed(const QString& reason)
{
    // What comes from anything but OpenGL was sent by a presenter that is no more.
    if (qobject_cast<GlPresenter*>(m_presenter) == nullptr)
        return;
    QWidget* shown = &m_presenter->widget();
    delete std::exchange(m_presenter, nullptr);
    delete shown;
    makePresenter(PresenterChoice::Software);
    m_pacer->requestDraw();
    Q_EMIT glUnavailable(reason);
}

QSize HeadView::sizeHint() const
{
    return {620, 560};
}

void HeadView::setTheme(const Theme& theme)
{
    m_overlay->setTheme(theme);
    m_weather->setTheme(theme);
}

void HeadView::setFrame(std::shared_ptr<const sim::StrandFrame> frame)
{
    if (frame && (frame->revision < m_firstRevision || !m_scene->isOnHead(*frame)))
        return; // Of the project, or the head, before this one.
    const std::shared_ptr<const sim::StrandFrame>& shown = m_scene->scene().hair;
    // Cards stand still, but for the head that wears them.
    const bool unseen = cardsShown() && frame && shown && frame->pose == shown->pose;
    const bool isFirst = frame && !shown;
    const bool moved = (m_stillness.moved(frame, m_scene->camera(), size()) || isFirst) && !unseen;
    const bool finer = frame && shown && sim::placedDetail(*frame) > sim::placedDetail(*shown);
    if (m_pacer->still() && !moved && !finer)
        return; // A picture that is being refined is worth more than a difference nobody sees.
    m_scene->setHair(std::move(frame));
    if (moved)
        m_pacer->wake();
    else
        m_pacer->requestDraw();
}

void HeadView::showCards(std::shared_ptr<const rendering::CardSet> cards)
{
    if (cards == m_scene->scene().cards)
        return;
    m_scene->setCards(std::move(cards));
    refreshSigns();
    m_pacer->wake();
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
    m_pacer->wake();
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
    return !m_presenter->resting() || m_pacer->waiting() || m_flight.underWay() || m_turn->moving();
}

bool HeadView::refining() const
{
    return m_refining;
}

rendering::Scene HeadView::pictureScene() const
{
    return m_scene->withoutRings();
}

QImage HeadView::grabPicture(QSize size)
{
    return size.isEmpty() ? QImage() : m_presenter->grab(pictureScene(), size);
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
    return m_presenter->description();
}

bool HeadView::weatherShown() const
{
    return !m_weather->isHidden();
}

void HeadView::setWeatherShown(bool shown)
{
    if (shown == weatherShown())
        return;
    m_weather->setVisible(shown);
    placeChildren();
    if (shown) {
        refreshEnvironment();
        m_weather->setFocus(Qt::OtherFocusReason);
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
        m_pacer->wake();
    }
    if (change.aspect == Aspect::Head || change.aspect == Aspect::Everything) {
        refreshHead();
        refreshOverlay(); // Its ellipsoids may be others while its mesh is the same.
    }
    if (change.aspect == Aspect::Environment || change.aspect == Aspect::Everything) {
        refreshEnvironment();
        if (m_state.options().collidersShown() || m_state.options().chosenWorn() != 0 ||
            !m_overlay->wornOutlines().empty())
            refreshOverlay();
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
    m_pacer->wake();
}

void HeadView::refreshEnvironment()
{
    const model::Project& project = m_state.document().project();
    m_scene->setEnvironment(project, m_pointer->draggedLight().value_or(project.light));
    m_weather->setValues(project.wind, project.light);
    m_pacer->wake();
}

void HeadView::refreshRings()
{
    const bool ringDiffers = m_scene->refreshRings();
    m_overlay->setGhost(m_scene->hiddenRing());
    refreshStrands();
    if (ringDiffers)
        m_pacer->wake();
    m_pointer->updateCursor();
}

void HeadView::refreshStrands()
{
    const std::optional<HoverPoint>& hover = m_state.hover().at();
    if (!hover || !hover->hair || !m_state.tools().active().traits().hasRing)
        return m_overlay->setStrands({}, {});
    const model::OverHair& hair = *hover->hair;
    const double radiusPx = 0.5 * m_state.tools().settings().brushSizeM * hair.pxPerM;
    m_overlay->setStrands(m_scene->strandsUnder(hair),
                          {hair.position - QPointF(radiusPx, radiusPx), QSizeF(2.0 * radiusPx, 2.0 * radiusPx)});
}

/// What lies over the picture moves with it, not with the camera or the hair, which may be pictures ahead.
void HeadView::follow(const Sight& sight)
{
    if (m_ownHairAwaited && sight.hairRevision >= m_firstRevision) {
        m_ownHairAwaited = false;
        Q_EMIT ownHairShown();
    }
    if (std::exchange(m_shown, sight) == sight)
        return;
    refreshOverlay();
    m_directions->refresh();
}

Sight HeadView::shown() const
{
    return m_shown.value_or(Sight{.camera = m_scene->camera(), .pose = m_scene->shownPose()});
}

void HeadView::refreshOverlay()
{
    const Sight sight = shown();
    m_overlay->setShapes(m_state.tools().overlay(), m_scene->skin(), sight.camera, sight.pose);
    m_overlay->setPictureLine(m_state.tools().active().pictureLine());
    m_overlay->setWorn(outlinedWorn(m_state), m_state.options().chosenWorn(), sight.camera, sight.pose);
    m_overlay->setGhost(m_scene->hiddenRing());
    m_directions->refreshSoon();
}

void HeadView::setLookedAt(std::optional<model::MapKind> map)
{
    m_directions->setLookedAt(map);
}

void HeadView::refreshSigns()
{
    // While something moves the last picture's word no longer holds.
    const std::shared_ptr<const rendering::CardSet>& cards = m_scene->scene().cards;
    m_signs->show(m_paused, m_refining && m_pacer->still(), cards ? cards->triangles.size() : 0);
    placeChildren();
}

void HeadView::draw()
{
    if (!isVisible())
        return; // showEvent asks again.
    m_pacer->drawing();
    const rendering::Scene& scene = m_scene->scene();
    m_presenter->present({.scene = scene,
                          .allHairs = scene.hair && !scene.cards ? scene.hair->hairCount : 0,
                          .still = m_pacer->still()});
}

void HeadView::placeChildren()
{
    constexpr int kMargin = 12;
    if (m_presenter != nullptr)
        m_presenter->widget().setGeometry(rect());
    m_overlay->setGeometry(rect());
    const QSize panel = m_weather->sizeHint().boundedTo(size() - QSize(2 * kMargin, 2 * kMargin));
    m_weather->setGeometry(QRect(QPoint(kMargin, height() - kMargin - panel.height()), panel));
    m_weather->raise();
    m_signs->move(width() - kMargin - m_signs->width(), kMargin);
    m_signs->raise();
}

void HeadView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_pacer->requestDraw();
}

void HeadView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    placeChildren();
    refreshOverlay();
    m_pacer->wake();
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
        (!weatherShown() || !m_weather->handleKey(event->key(), event->modifiers())))
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
