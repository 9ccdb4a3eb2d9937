// The QOpenGLWidget of the 3D area.
#include "view/head_area/gl_presenter.h"

#include "view/head_area/gl_problem.h"
#include "view/rendering/detail_governor.h"
#include "view/rendering/gl/gl_renderer.h"

#include <QBasicTimer>
#include <QCoreApplication>
#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <QSurfaceFormat>
#include <QTimerEvent>

#include <new>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr double kStepMs = 8.0; ///< Time of a step of a fine picture in the GUI thread, for which input waits.

} // namespace

class GlPresenter::Canvas : public QOpenGLWidget
{
public:
    Canvas(GlPresenter& owner, QWidget* parent) : QOpenGLWidget(parent), m_owner(owner)
    {
        QSurfaceFormat format;
        format.setVersion(4, 3);
        format.setProfile(QSurfaceFormat::CoreProfile);
        format.setSamples(0); // Samples belong to the renderer's own targets.
        format.setOption(QSurfaceFormat::ResetNotification);
        setFormat(format);
        setAttribute(Qt::WA_TransparentForMouseEvents);
    }
    ~Canvas() override
    {
        dropRenderer();
        // The base class destroys the context after this, when there is no canvas left to tell.
        if (context() != nullptr)
            disconnect(context(), nullptr, this, nullptr);
    }

    void show(const Shot& shot)
    {
        const bool same = m_shot && m_shot->scene == shot.scene;
        if (same && shot.still && m_shot->still)
            return; // As fine as it gets, or being refined.
        dropFinePicture();
        m_shot = shot;
        if (same && shot.still && !m_outdated) {
            m_steps.start(0, this);
            return;
        }
        m_outdated = true;
        update();
        Q_EMIT m_owner.shows(shot.sight());
    }

    [[nodiscard]] QImage grab(const rendering::Scene& scene, QSize size)
    {
        if (!m_renderer)
            return {};
        dropFinePicture();
        makeCurrent();
        m_renderer->draw(scene, rendering::pictureQuality(), size.width(), size.height());
        m_renderer->read(m_pixels);
        doneCurrent();
        m_outdated = true; // The renderer's last picture is this one now.
        update();
        return QImage(m_pixels.data(), size.width(), size.height(), size.width() * 4, QImage::Format_RGBX8888)
            .convertToFormat(QImage::Format_RGB32);
    }

    [[nodiscard]] QString description() const
    {
        return m_renderer ? QString::fromStdString(m_renderer->description()) : QString();
    }

protected:
    void initializeGL() override
    {
        connect(
            context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { dropRenderer(); }, Qt::DirectConnection);
        tl::expected<std::unique_ptr<rendering::GlRenderer>, std::string> renderer = rendering::GlRenderer::create();
        if (renderer)
            m_renderer = std::move(*renderer);
        else
            Q_EMIT m_owner.failed(glProblem(renderer.error()));
    }

    void paintGL() override
    {
        if (!m_renderer || !m_shot || isLost())
            return;
        const QSize size = (QSizeF(this->size()) * devicePixelRatioF()).toSize();
        if (m_outdated || size != m_size)
            drawAtOnce(size);
        m_renderer->blitTo(defaultFramebufferObject(), size.width(), size.height());
    }

    void timerEvent(QTimerEvent* event) override
    {
        if (event->timerId() != m_steps.timerId()) {
            QOpenGLWidget::timerEvent(event);
            return;
        }
        makeCurrent();
        const bool finished = !isLost() && refine();
        doneCurrent();
        if (!finished)
            return;
        const bool refines = m_governor.wantsRefinement();
        if (!refines)
            m_steps.stop();
        update();
        Q_EMIT m_owner.refining(refines);
        Q_EMIT m_owner.frameDrawn(m_renderer->statistics());
    }

    void showEvent(QShowEvent* event) override
    {
        QOpenGLWidget::showEvent(event);
        // Without a context Qt never calls initializeGL.
        QMetaObject::invokeMethod(
            this,
            [this] {
                if (isVisible() && !isValid())
                    Q_EMIT m_owner.failed(QCoreApplication::translate("HeadView", "The window has no OpenGL context."));
            },
            Qt::QueuedConnection);
    }

private:
    /// Once the driver has reset itself nothing is drawn here any more, and the owner is told.
    bool isLost()
    {
        if (!m_lost && m_renderer->contextLost()) {
            m_lost = true;
            m_steps.stop();
            Q_EMIT m_owner.failed(QCoreApplication::translate(
                "HeadView", "The graphics driver was reset. Until the next start the hair is drawn without it."));
        }
        return m_lost;
    }

    /// Draws as coarsely as while something moves, also where the shot is still: that is refined afterwards.
    void drawAtOnce(QSize size)
    {
        dropFinePicture();
        try {
            m_renderer->draw(m_shot->scene, m_governor.begin(false), size.width(), size.height());
        } catch (const std::bad_alloc&) {
            return; // The last picture stays until there is memory for another.
        }
        m_size = size;
        m_outdated = false;
        m_governor.observe(m_renderer->statistics(), m_shot->allHairs);
        if (m_shot->still)
            m_steps.start(0, this);
        // Signals are sent later: Qt is painting now.
        QMetaObject::invokeMethod(
            this,
            [this, refines = m_shot->still, statistics = m_renderer->statistics()] {
                Q_EMIT m_owner.refining(refines);
                Q_EMIT m_owner.frameDrawn(statistics);
            },
            Qt::QueuedConnection);
    }

    /// Draws a step of a finer picture; returns whether that is finished.
    bool refine()
    {
        try {
            if (!std::exchange(m_begun, true)) {
                m_renderer->begin(m_shot->scene, m_governor.begin(true), m_size.width(), m_size.height());
                return false;
            }
            if (!m_renderer->step(kStepMs))
                return false;
        } catch (const std::bad_alloc&) {
            dropFinePicture();
            Q_EMIT m_owner.refining(false);
            return false;
        }
        m_begun = false;
        m_governor.observe(m_renderer->statistics(), m_shot->allHairs);
        return true;
    }

    void dropFinePicture()
    {
        m_steps.stop();
        m_begun = false;
    }

    void dropRenderer()
    {
        if (!m_renderer)
            return;
        dropFinePicture();
        m_outdated = true;
        makeCurrent();
        m_renderer.reset();
        doneCurrent();
    }

    GlPresenter& m_owner;
    std::unique_ptr<rendering::GlRenderer> m_renderer;
    rendering::DetailGovernor m_governor;
    std::optional<Shot> m_shot;
    bool m_outdated = true; ///< The renderer's last picture is not of this shot.
    QSize m_size;           ///< Size of the renderer's last picture, in pixels.
    QBasicTimer m_steps;    ///< Runs while a finer picture is drawn; other events come between its turns.
    bool m_lost = false;    ///< The driver was reset: nothing is drawn with the context any more.
    bool m_begun = false;   ///< Whether the renderer has begun a finer picture.
    std::vector<std::uint8_t> m_pixels;
};

GlPresenter::GlPresenter(QWidget* parent) : FramePresenter(parent), m_canvas(new Canvas(*this, parent)) {}

QWidget& GlPresenter::widget()
{
    return *m_canvas;
}

void GlPresenter::present(const Shot& shot)
{
    m_canvas->show(shot);
}

QImage GlPresenter::grab(const rendering::Scene& scene, QSize size)
{
    return m_canvas->grab(scene, size);
}

QString GlPresenter::description() const
{
    return m_canvas->description();
}

} // namespace hairpaint::view
