// The QOpenGLWidget of the 3D area.
#include "view/head/gl_presenter.h"

#include "view/gl_problem.h"

#include <QCoreApplication>
#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <QSurfaceFormat>

#include <utility>

namespace hairpaint::view {

namespace {

constexpr double kMostRefinedMs = 250.0; ///< The next step may take four times as long.

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
        m_shot = shot;
        update();
    }

    [[nodiscard]] QImage grab(const rendering::Scene& scene, QSize size)
    {
        if (!m_renderer)
            return {};
        makeCurrent();
        m_renderer->draw(scene, rendering::pictureQuality(), size.width(), size.height());
        m_renderer->read(m_pixels);
        doneCurrent();
        update(); // The renderer's target has another size now.
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
        tl::expected<std::unique_ptr<rendering::Renderer>, std::string> renderer = rendering::Renderer::create();
        if (renderer)
            m_renderer = std::move(*renderer);
        else
            Q_EMIT m_owner.failed(glProblem(renderer.error()));
    }

    void paintGL() override
    {
        if (!m_renderer || !m_shot)
            return;
        const QSize size = (QSizeF(this->size()) * devicePixelRatioF()).toSize();
        m_renderer->draw(m_shot->scene, m_governor.begin(m_shot->still), size.width(), size.height());
        m_renderer->blitTo(defaultFramebufferObject(), size.width(), size.height());
        m_governor.observe(m_renderer->statistics(), m_shot->allHairs);
        // This is the GUI thread: a GPU that is slow already is not asked for more.
        const bool refines =
            m_shot->still && m_governor.wantsRefinement() && m_renderer->statistics().milliseconds < kMostRefinedMs;
        QMetaObject::invokeMethod(
            this,
            [this, refines, statistics = m_renderer->statistics()] {
                Q_EMIT m_owner.refining(refines);
                Q_EMIT m_owner.frameDrawn(statistics);
                if (refines)
                    update();
            },
            Qt::QueuedConnection);
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
    void dropRenderer()
    {
        if (!m_renderer)
            return;
        makeCurrent();
        m_renderer.reset();
        doneCurrent();
    }

    GlPresenter& m_owner;
    std::unique_ptr<rendering::Renderer> m_renderer;
    rendering::DetailGovernor m_governor;
    std::optional<Shot> m_shot;
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
