// The thread that draws where there is no GPU.
#include "view/head/render_thread.h"

#include "sim/base/parallel.h"
#include "view/rendering/detail_governor.h"
#include "view/rendering/software/software_renderer.h"

#include <new>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr double kWantedMs = 29.0; ///< Of a moving frame: thirty a second, when the hair's motion has its time, too.

} // namespace

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

    void drawLatest()
    {
        if (std::optional<Job> job = m_jobs.take())
            m_last = std::move(job);
        else if (!std::exchange(m_refines, false))
            return; // An earlier call has drawn it already.
        if (!m_last || isToEnd())
            return;
        const sim::ArenaScope arena(sim::Arena::Drawing);
        const Shot& shot = m_last->shot;
        // A fine picture may take seconds: whatever comes meanwhile goes first.
        rendering::Backend::Progress goesOn;
        if (shot.still)
            goesOn = [this](double fraction) {
                Q_EMIT m_owner.pieceDrawn(fraction);
                return !isToEnd() && !m_jobs.waiting();
            };
        try {
            if (!m_renderer.drawPatiently(shot.scene, m_governor.begin(shot.still), m_last->size.width(),
                                          m_last->size.height(), goesOn))
                return;
            m_governor.observe(m_renderer.statistics(), shot.allHairs);
            m_refines = shot.still && m_governor.wantsRefinement();
            m_frames.put({readImage(m_last->size), shot.sight(), m_renderer.statistics(), m_refines});
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
        const sim::ArenaScope arena(sim::Arena::Drawing);
        m_renderer.draw(scene, rendering::pictureQuality(), size.width(), size.height());
        return readImage(size);
    }

    sim::Mailbox<Job> m_jobs;
    sim::Mailbox<Frame> m_frames;

private:
    [[nodiscard]] static bool isToEnd() { return QThread::currentThread()->isInterruptionRequested(); }

    [[nodiscard]] QImage readImage(QSize size)
    {
        m_renderer.read(m_pixels);
        const auto wanted = static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()) * 4U;
        if (m_pixels.size() != wanted)
            return {};
        // Painted as it is by the raster engine; the copy detaches it from the pixels that are reused.
        return QImage(m_pixels.data(), size.width(), size.height(), size.width() * 4, QImage::Format_RGBX8888)
            .convertToFormat(QImage::Format_RGB32);
    }

    RenderThread& m_owner;
    rendering::SoftwareRenderer m_renderer;
    /// All hairs at first: those that can't be told apart are not drawn anyhow.
    rendering::DetailGovernor m_governor{kWantedMs, 1.0F};
    std::optional<Job> m_last;
    bool m_refines = false;
    std::vector<std::uint8_t> m_pixels;
};

RenderThread::RenderThread(QObject* parent) : QObject(parent), m_worker(std::make_unique<Worker>(*this))
{
    m_thread.setObjectName(QStringLiteral("render"));
    m_worker->moveToThread(&m_thread);
    m_thread.start();
}

RenderThread::~RenderThread()
{
    m_thread.requestInterruption(); // A fine picture under way is given up.
    m_thread.quit();
    m_thread.wait();
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
