// The thread that draws where OpenGL is software.
#include "view/head/render_thread.h"

#include "view/gl_problem.h"
#include "view/rendering/detail_governor.h"
#include "view/rendering/offscreen_context.h"

#include <atomic>
#include <new>
#include <utility>

namespace hairpaint::view {

/// Lives on the thread.
class RenderThread::Worker : public QObject
{
public:
    struct Job
    {
        Shot shot;
        QSize size;
    };

    explicit Worker(RenderThread& owner) : m_owner(owner) {}

    [[nodiscard]] const RenderStart& start()
    {
        if (!m_start) {
            m_start = makeContext();
            // From the GUI thread's event loop, so that whoever made the thread has had time to listen.
            QMetaObject::invokeMethod(
                &m_owner, [&owner = m_owner, known = *m_start] { Q_EMIT owner.started(known); }, Qt::QueuedConnection);
        }
        return *m_start;
    }

    /// From any thread: a fine picture under way is given up.
    void hurry() { m_stopping = true; }

    /// Calls that still wait in the thread's queue find nothing to draw with.
    void stop()
    {
        m_start = RenderStart{};
        m_renderer.reset();
        if (m_context)
            m_context->doneCurrent();
        m_context.reset();
    }

    void drawLatest()
    {
        if (std::optional<Job> job = m_jobs.take())
            m_last = std::move(job);
        else if (!std::exchange(m_refines, false))
            return; // An earlier call has drawn it already.
        if (!m_last || !start().works)
            return;
        const Shot& shot = m_last->shot;
        // A fine picture may take seconds: whatever comes meanwhile goes first.
        rendering::Renderer::Progress goesOn;
        if (shot.still)
            goesOn = [this](double) { return !m_stopping && !m_jobs.waiting(); };
        try {
            if (!m_renderer->drawPatiently(shot.scene, m_governor.begin(shot.still), m_last->size.width(),
                                           m_last->size.height(), goesOn))
                return;
            m_governor.observe(m_renderer->statistics(), shot.allHairs);
            m_refines = shot.still && m_governor.wantsRefinement();
            m_frames.put({readImage(m_last->size), m_renderer->statistics(), m_refines});
        } catch (const std::bad_alloc&) {
            return; // The last picture stays until there is memory for another.
        }
        Q_EMIT m_owner.frameReady();
        if (m_refines)
            QMetaObject::invokeMethod(
                this, [this] { drawLatest(); }, Qt::QueuedConnection);
    }

    [[nodiscard]] QImage grab(const rendering::Scene& scene, QSize size)
    {
        if (!start().works)
            return {};
        m_renderer->draw(scene, rendering::pictureQuality(), size.width(), size.height());
        return readImage(size);
    }

    sim::Mailbox<Job> m_jobs;
    sim::Mailbox<Frame> m_frames;

private:
    [[nodiscard]] RenderStart makeContext()
    {
        tl::expected<std::unique_ptr<rendering::OffscreenContext>, std::string> context =
            rendering::OffscreenContext::create();
        if (!context)
            return {.works = false, .software = true, .text = glProblem(context.error())};
        if (!(*context)->makeCurrent())
            return {.works = false, .software = true, .text = glProblem("The OpenGL driver refuses to draw.")};
        tl::expected<std::unique_ptr<rendering::Renderer>, std::string> renderer = rendering::Renderer::create();
        if (!renderer) {
            (*context)->doneCurrent();
            return {.works = false, .software = true, .text = glProblem(renderer.error())};
        }
        m_context = std::move(*context);
        m_renderer = std::move(*renderer);
        return {.works = true,
                .software = m_renderer->software(),
                .text = QString::fromStdString(m_renderer->description())};
    }

    [[nodiscard]] QImage readImage(QSize size)
    {
        m_renderer->read(m_pixels);
        const auto wanted = static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()) * 4U;
        if (m_pixels.size() != wanted)
            return {};
        // Painted as it is by the raster engine; the copy detaches it from the pixels that are reused.
        return QImage(m_pixels.data(), size.width(), size.height(), size.width() * 4, QImage::Format_RGBX8888)
            .convertToFormat(QImage::Format_RGB32);
    }

    RenderThread& m_owner;
    std::optional<RenderStart> m_start;
    std::unique_ptr<rendering::OffscreenContext> m_context;
    std::unique_ptr<rendering::Renderer> m_renderer;
    rendering::DetailGovernor m_governor;
    std::optional<Job> m_last;
    bool m_refines = false;
    std::atomic<bool> m_stopping = false;
    std::vector<std::uint8_t> m_pixels;
};

RenderThread::RenderThread(QObject* parent) : QObject(parent), m_worker(std::make_unique<Worker>(*this))
{
    qRegisterMetaType<RenderStart>();
    m_thread.setObjectName(QStringLiteral("render"));
    m_worker->moveToThread(&m_thread);
    m_thread.start();
    QMetaObject::invokeMethod(
        m_worker.get(), [worker = m_worker.get()] { static_cast<void>(worker->start()); }, Qt::QueuedConnection);
}

RenderThread::~RenderThread()
{
    m_worker->hurry();
    QMetaObject::invokeMethod(
        m_worker.get(), [worker = m_worker.get()] { worker->stop(); }, Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
}

RenderStart RenderThread::waitForStart()
{
    RenderStart start;
    QMetaObject::invokeMethod(
        m_worker.get(), [&start, worker = m_worker.get()] { start = worker->start(); }, Qt::BlockingQueuedConnection);
    return start;
}

void RenderThread::draw(const Shot& shot, QSize size)
{
    m_worker->m_jobs.put({shot, size});
    QMetaObject::invokeMethod(
        m_worker.get(), [worker = m_worker.get()] { worker->drawLatest(); }, Qt::QueuedConnection);
}

QImage RenderThread::grab(const rendering::Scene& scene, QSize size)
{
    QImage image;
    QMetaObject::invokeMethod(
        m_worker.get(), [&, worker = m_worker.get()] { image = worker->grab(scene, size); },
        Qt::BlockingQueuedConnection);
    return image;
}

std::optional<RenderThread::Frame> RenderThread::takeFrame()
{
    return m_worker->m_frames.take();
}

} // namespace hairpaint::view
