// Paints frames that the thread has drawn.
#include "view/head_area/software_presenter.h"

#include <QPainter>

#include <utility>

namespace hairpaint::view {

class SoftwarePresenter::Canvas : public QWidget
{
public:
    explicit Canvas(QWidget* parent) : QWidget(parent)
    {
        setAttribute(Qt::WA_OpaquePaintEvent);
        setAttribute(Qt::WA_TransparentForMouseEvents);
    }

    void show(QImage image)
    {
        m_image = std::move(image);
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        if (m_image.isNull()) {
            painter.fillRect(rect(), palette().window());
            return;
        }
        painter.setRenderHint(QPainter::SmoothPixmapTransform, m_image.size() != size() * devicePixelRatioF());
        painter.drawImage(rect(), m_image);
    }

private:
    QImage m_image;
};

SoftwarePresenter::SoftwarePresenter(std::unique_ptr<RenderThread> thread, QWidget* parent)
    : FramePresenter(parent), m_thread(std::move(thread)), m_canvas(new Canvas(parent))
{
    connect(m_thread.get(), &RenderThread::frameReady, this, &SoftwarePresenter::onFrameReady);
}

SoftwarePresenter::~SoftwarePresenter() = default;

QWidget& SoftwarePresenter::widget()
{
    return *m_canvas;
}

QString SoftwarePresenter::description() const
{
    return tr("Hair Paint itself, without a graphics card");
}

void SoftwarePresenter::present(const Shot& shot)
{
    if (!m_canvas->size().isEmpty())
        m_thread->draw(shot, m_canvas->size());
}

QImage SoftwarePresenter::grab(const rendering::Scene& scene, QSize size)
{
    return m_thread->grab(scene, size);
}

void SoftwarePresenter::onFrameReady()
{
    if (std::optional<RenderThread::Frame> frame = m_thread->takeFrame()) {
        m_canvas->show(std::move(frame->image));
        Q_EMIT shows(frame->sight);
        Q_EMIT refining(frame->refines);
        Q_EMIT frameDrawn(frame->statistics);
    }
}

} // namespace hairpaint::view
