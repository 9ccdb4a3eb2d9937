// The 3D area's scene, presenter and drawing.
#include "view/head_view.h"

#include "view/scene_light.h"

#include "view/head/gl_presenter.h"
#include "view/head/head_view_state.h"
#include "view/head/software_presenter.h"
#include "view/head/stage.h"

#include <QGuiApplication>
#include <QTimerEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kLeastMsBetweenDraws = 16;
constexpr int kSettleMs = 250;
constexpr int kTurnMs = 240;
constexpr int kTurnBackMs = 500;

/// Where a QOpenGLWidget can't work at all.
bool headless()
{
    const QString platform = QGuiApplication::platformName();
    return platform == QLatin1StringView("offscreen") || platform == QLatin1StringView("minimal");
}

} // namespace

HeadView::HeadView(EditorState& state, const Theme& theme, PresenterChoice choice, QWidget* parent)
    : PaintedArea(state, parent), m_state(std::make_unique<State>(state, theme, this))
{
    setObjectName(QStringLiteral("headArea"));
    setMinimumSize(160, 160);
    m_state->overlay = new HeadOverlay(theme, this);
    m_state->weather = new WeatherOverlay(theme, this);
    m_state->signs = new ViewSigns(this);
    m_state->weather->hide();
    connect(m_state->weather, &WeatherOverlay::windWanted, this, &HeadView::windWanted);
    connect(m_state->weather, &WeatherOverlay::lightWanted, this, &HeadView::lightWanted);
    connect(m_state->weather, &WeatherOverlay::leaveWanted, this, [this] { setWeatherShown(false); });

    connect(&state.document(), &model::Document::changed, this, &HeadView::onDocumentChanged);
    connect(&state, &EditorState::hoverChanged, this, &HeadView::refreshRings);
    connect(&state, &EditorState::toolSettingsChanged, this, &HeadView::refreshRings);
    connect(&state, &EditorState::viewOptionsChanged, this, &HeadView::refreshRings);
    connect(&state, &EditorState::activeToolChanged, this, [this] {
        refreshRings();
        refreshOverlay();
    });
    connect(&state, &EditorState::overlayChanged, this, &HeadView::refreshOverlay);
    connect(&m_state->keys, &HeldKeys::changed, this, &HeadView::updateCursor);

    m_state->turning.setDuration(kTurnMs);
    m_state->turning.setEasingCurve(QEasingCurve::OutCubic);
    m_state->turning.setStartValue(0.0F);
    m_state->turning.setEndValue(1.0F);
    m_state->turningBack.setDuration(kTurnBackMs);
    m_state->turningBack.setEasingCurve(QEasingCurve::InOutQuad);
    m_state->turningBack.setStartValue(0.0F);
    m_state->turningBack.setEndValue(1.0F);
    connect(&m_state->turningBack, &QVariantAnimation::valueChanged, this, [this](const QVariant& t) {
        m_state->pose.rotation =
            glm::slerp(m_state->poseBefore.rotation, glm::quat(1.0F, 0.0F, 0.0F, 0.0F), t.toFloat());
        Q_EMIT poseWanted(m_state->pose);
    });

    refreshHead();
    refreshEnvironment();
    if (m_state->scene.head)
        setCamera(stageCamera(rendering::StandardView::ThreeQuarter, *state.document().project().head,
                              *m_state->scene.head, nullptr));
    makePresenter(choice);
}

HeadView::~HeadView()
{
    // Its thread and its context end before the state it reports to.
    delete m_state->presenter;
}

void HeadView::makePresenter(PresenterChoice choice)
{
    bool usesGl = choice == PresenterChoice::Gl && !headless();
    std::unique_ptr<RenderThread> thread;
    if (!usesGl) {
        thread = std::make_unique<RenderThread>();
        if (choice == PresenterChoice::Automatic && !headless()) {
            const RenderStart start = thread->waitForStart();
            usesGl = start.works && !start.software;
        }
    }
    if (usesGl) {
        thread.reset();
        m_state->presenter = new GlPresenter(this);
    } else {
        m_state->presenter = new SoftwarePresenter(std::move(thread), this);
    }
    connect(m_state->presenter, &FramePresenter::frameDrawn, this, &HeadView::frameDrawn);
    connect(m_state->presenter, &FramePresenter::refining, this, [this](bool on) {
        m_state->refining = on;
        refreshSigns();
    });
    connect(m_state->presenter, &FramePresenter::failed, this, &HeadView::onPresenterFailed, Qt::QueuedConnection);
    m_state->presenter->widget().lower();
    m_state->presenter->widget().show();
    placeChildren();
}

void HeadView::onPresenterFailed(const QString& reason)
{
    if (qobject_cast<GlPresenter*>(m_state->presenter) != nullptr) {
        // The window's own context may lack what an off-screen one has.
        QWidget* shown = &m_state->presenter->widget();
        delete std::exchange(m_state->presenter, nullptr);
        delete shown;
        makePresenter(PresenterChoice::Software);
        requestDraw();
        return;
    }
    m_state->overlay->setMessage(
        tr("The hair can't be shown here: %1 Painting, saving and exporting work all the same.").arg(reason));
    Q_EMIT glUnavailable(reason);
}

QSize HeadView::sizeHint() const
{
    return {620, 560};
}

void HeadView::setTheme(const Theme& theme)
{
    m_state->theme = theme;
    m_state->overlay->setTheme(theme);
    m_state->weather->setTheme(theme);
}

const rendering::Camera& HeadView::camera() const
{
    return m_state->scene.camera;
}

void HeadView::setCamera(const rendering::Camera& camera)
{
    m_state->turning.stop();
    if (camera == m_state->scene.camera)
        return;
    m_state->scene.camera = camera;
    cameraMoved();
}

void HeadView::setView(rendering::StandardView view)
{
    if (m_state->scene.head)
        animateTo(stageCamera(view, *m_state->editor.document().project().head, *m_state->scene.head,
                              m_state->scene.hair.get()));
}

void HeadView::resetCamera()
{
    setView(rendering::StandardView::ThreeQuarter);
    if (m_state->pose != sim::HeadPose{}) {
        m_state->poseBefore = m_state->pose;
        m_state->turningBack.start();
    }
}

void HeadView::fit()
{
    if (!m_state->scene.head)
        return;
    animateTo(stageCamera(m_state->scene.camera, *m_state->editor.document().project().head, *m_state->scene.head,
                          m_state->scene.hair.get()));
}

void HeadView::animateTo(const rendering::Camera& camera)
{
    m_state->turning.stop();
    disconnect(&m_state->turning, nullptr, this, nullptr);
    connect(&m_state->turning, &QVariantAnimation::valueChanged, this,
            [this, from = m_state->scene.camera, camera](const QVariant& t) {
                m_state->scene.camera = between(from, camera, t.toFloat());
                cameraMoved();
            });
    m_state->turning.start();
}

void HeadView::cameraMoved()
{
    refreshOverlay();
    wake();
}

void HeadView::wake()
{
    if (std::exchange(m_state->still, false))
        refreshSigns();
    m_state->settle.start(kSettleMs, this);
    requestDraw();
}

bool HeadView::awake() const
{
    return m_state->drawSoon.isActive() || m_state->settle.isActive() ||
           m_state->turning.state() == QAbstractAnimation::Running ||
           m_state->turningBack.state() == QAbstractAnimation::Running;
}

bool HeadView::refining() const
{
    return m_state->refining;
}

rendering::Scene HeadView::pictureScene() const
{
    rendering::Scene scene = m_state->scene;
    scene.ring.reset();
    scene.mirroredRing.reset();
    return scene;
}

QImage HeadView::grabPicture(QSize size)
{
    return size.isEmpty() ? QImage() : m_state->presenter->grab(pictureScene(), size);
}

std::optional<sim::SurfacePoint> HeadView::skinAt(QPointF position) const
{
    const sim::Skin* skin = m_state->skin();
    if (skin == nullptr)
        return std::nullopt;
    return skin->pick(inHead(rayThrough(m_state->scene.camera, position, QSizeF(size())), m_state->shownPose()));
}

std::optional<QPointF> HeadView::positionOf(glm::vec3 positionHd) const
{
    return project(m_state->scene.camera, inWorld(positionHd, m_state->shownPose()), QSizeF(size()));
}

QString HeadView::rendererDescription() const
{
    return m_state->presenter->description();
}

QString HeadView::missingText() const
{
    return m_state->overlay->message();
}

bool HeadView::weatherShown() const
{
    return !m_state->weather->isHidden();
}

void HeadView::setWeatherShown(bool shown)
{
    if (shown == weatherShown())
        return;
    m_state->weather->setVisible(shown);
    placeChildren();
    if (shown) {
        refreshEnvironment();
        m_state->weather->setFocus(Qt::OtherFocusReason);
    } else {
        setFocus(Qt::OtherFocusReason);
    }
    Q_EMIT weatherShownChanged(shown);
}

void HeadView::turnToBrush()
{
    if (!m_state->brush)
        return;
    const sim::HeadPose pose = m_state->shownPose();
    const glm::vec3 positionWo = inWorld(m_state->brush->positionHd, pose);
    animateTo(lookingAt(m_state->scene.camera, positionWo, pose.rotation * m_state->brush->normalHd));
}

void HeadView::setHairPaused(bool paused)
{
    m_state->paused = paused;
    refreshSigns();
}

void HeadView::requestDraw()
{
    if (m_state->drawSoon.isActive())
        return;
    const qint64 passed = m_state->sinceDraw.isValid() ? m_state->sinceDraw.elapsed() : kLeastMsBetweenDraws;
    m_state->drawSoon.start(static_cast<int>(std::max<qint64>(0, kLeastMsBetweenDraws - passed)), Qt::PreciseTimer,
                            this);
}

void HeadView::timerEvent(QTimerEvent* event)
{
    if (event->timerId() == m_state->settle.timerId()) {
        m_state->settle.stop();
        m_state->still = true;
        requestDraw();
    } else if (event->timerId() == m_state->drawSoon.timerId()) {
        m_state->drawSoon.stop();
        if (!isVisible())
            return; // showEvent asks again.
        m_state->sinceDraw.start();
        const std::shared_ptr<const sim::StrandFrame>& hair = m_state->scene.hair;
        m_state->presenter->present(
            {.scene = m_state->scene, .allHairs = hair ? hair->hairCount : 0, .still = m_state->still});
    } else {
        QWidget::timerEvent(event);
    }
}

void HeadView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    requestDraw();
}

void HeadView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    placeChildren();
    cameraMoved();
}

void HeadView::placeChildren()
{
    constexpr int kMargin = 12;
    if (m_state->presenter != nullptr)
        m_state->presenter->widget().setGeometry(rect());
    m_state->overlay->setGeometry(rect());
    const QSize panel = m_state->weather->sizeHint().boundedTo(size() - QSize(2 * kMargin, 2 * kMargin));
    m_state->weather->setGeometry(QRect(QPoint(kMargin, height() - kMargin - panel.height()), panel));
    m_state->weather->raise();
    m_state->signs->move(width() - kMargin - m_state->signs->width(), kMargin);
    m_state->signs->raise();
}

void HeadView::refreshSigns()
{
    // While something moves the last picture's word no longer holds.
    m_state->signs->show(m_state->paused, m_state->refining && m_state->still);
    placeChildren();
}

} // namespace hairpaint::view
