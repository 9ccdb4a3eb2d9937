// The thread that draws where there is no GPU.
#include "view/head_area/render_thread.h"

#include "sim/base/parallel.h"
#include "view/rendering/detail_governor.h"
#include "view/rendering/software/software_renderer.h"

#include <QThread>

#include <future>
#include <new>
#include <utility>
#include <vector>

namespace hairpaint::view {

namespace {

/// Time of a moving frame: thirty a second, when the hair's motion has its time, too.
constexpr double kWantedMs = 29.0;

struct Job
{
    Shot shot;
    QSize size;
};

struct Grab
{
    const rendering::Scene& scene;
    QSize size;
    std::promise<QImage> image;
};

/// Requests since the thread last looked.
struct Requests
{
    std::optional<Job> job;
    std::vector<Grab*> grabs; ///< Their callers wait.
    bool stop = false;
};

} // namespace

/// Both threads use it; private members belong to the drawing thread, which waits in a mailbox instead of an event loop
/// of Qt: the thread sanitizer sees through the first only.
class RenderThread::Worker : public QThread
{
public:
    explicit Worker(RenderThread& owner) : m_owner(owner)
    {
        setObjectName(QStringLiteral("render"));
        start();
    }

    ~Worker() override
    {
        m_requests.update([](Requests& requests) { requests.stop = true; });
        requestInterruption(); // For who is told of a piece just now.
        wait();
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    sim::Mailbox<Requests> m_requests;
    sim::Mailbox<Frame> m_frames;

protected:
    void run() override
    {
        const sim::ArenaScope arena(sim::Arena::Drawing);
        for (;;) {
            Requests requests = m_refines ? m_requests.take().value_or(Requests{}) : m_requests.waitAndTake();
            if (requests.stop)
                return;
            for (Grab* grab : requests.grabs)
                grab->image.set_value(grabbed(grab->scene, grab->size));
            if (requests.job)
                m_last = std::move(requests.job);
            else if (!m_refines)
                continue;
            m_refines = false;
            drawLast();
        }
    }

private:
    void drawLast()
    {
        const Shot& shot = m_last->shot;
        // A fine picture may take seconds: requests that come meanwhile stop it.
        rendering::Backend::Progress goesOn;
        if (shot.still)
            goesOn = [this](double fraction) {
                Q_EMIT m_owner.pieceDrawn(fraction);
                return !m_requests.waiting();
            };
        try {
            if (!m_renderer->drawPatiently(shot.scene, m_governor.begin(shot.still), m_last->size.width(),
                                           m_last->size.height(), goesOn)) {
                m_refines = m_requests.waiting(); // It begins anew after the requests, unless one is another picture.
                return;
            }
            m_governor.observe(m_renderer->statistics(), shot.allHairs);
            m_refines = shot.still && m_governor.wantsRefinement();
            m_frames.put({readImage(m_last->size), shot.sight(), m_renderer->statistics(), m_refines});
        } catch (const std::bad_alloc&) {
            m_refines = false;
            return; // The last picture stays until there is memory for another.
        }
        Q_EMIT m_owner.frameReady();
    }

    [[nodiscard]] QImage grabbed(const rendering::Scene& scene, QSize size)
    {
        try {
            m_renderer->draw(scene, rendering::pictureQuality(), size.width(), size.height());
            return readImage(size);
        } catch (const std::bad_alloc&) {
            return {};
        }
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
    std::unique_ptr<rendering::Backend> m_renderer = std::make_unique<rendering::SoftwareRenderer>();
    /// Begins with all hairs: those too thin to be told apart are not drawn anyway.
    rendering::DetailGovernor m_governor{kWantedMs, 1.0F};
    std::optional<Job> m_last;
    bool m_refines = false; ///< The last job's next and finer picture is due.
    std::vector<std::uint8_t> m_pixels;
};

RenderThread::RenderThread(QObject* parent) : QObject(parent), m_worker(std::make_unique<Worker>(*this)) {}

RenderThread::~RenderThread() = default;

void RenderThread::draw(const Shot& shot, QSize size)
{
    m_worker->m_requests.update([&](Requests& requests) { requests.job = Job{shot, size}; });
}

QImage RenderThread::grab(const rendering::Scene& scene, QSize size)
{
    Grab grab{.scene = scene, .size = size, .image = {}};
    std::future<QImage> image = grab.image.get_future();
    m_worker->m_requests.update([&](Requests& requests) { requests.grabs.push_back(&grab); });
    return image.get();
}

bool RenderThread::resting() const
{
    return m_worker->m_requests.awaited() && !m_worker->m_frames.waiting();
}

std::optional<RenderThread::Frame> RenderThread::takeFrame()
{
    return m_worker->m_frames.take();
}

} // namespace hairpaint::view
