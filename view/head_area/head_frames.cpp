// Presenter and pacer brought together.
#include "view/head_area/head_frames.h"

#include "view/head_area/gl_presenter.h"
#include "view/head_area/head_scene.h"

#include <utility>

namespace hairpaint::view {

HeadFrames::HeadFrames(HeadScene& scene, QWidget& area, PresenterChoice choice)
    : QObject(&area), m_scene(scene), m_area(area)
{
    connect(&m_pacer, &FramePacer::drawDue, this, &HeadFrames::draw);
    connect(&m_pacer, &FramePacer::stillBegan, this, [this] {
        if (mayRefine())
            m_pacer.requestDraw();
    });
    connect(&m_pacer, &FramePacer::stillEnded, this, &HeadFrames::finenessChanged);
    makePresenter(choice);
}

HeadFrames::~HeadFrames()
{
    // Its thread and its context end before what it reports to.
    delete m_presenter;
}

void HeadFrames::makePresenter(PresenterChoice choice)
{
    m_presenter = FramePresenter::make(choice, &m_area);
    connect(m_presenter, &FramePresenter::shows, this, &HeadFrames::shows);
    connect(m_presenter, &FramePresenter::frameDrawn, this, &HeadFrames::frameDrawn);
    connect(m_presenter, &FramePresenter::refining, this, [this](bool on) {
        m_refining = on;
        Q_EMIT finenessChanged();
    });
    connect(m_presenter, &FramePresenter::failed, this, &HeadFrames::onFailed, Qt::QueuedConnection);
    m_presenter->widget().lower();
    m_presenter->widget().show();
}

void HeadFrames::onFailed(const QString& reason)
{
    // What comes from anything but OpenGL was sent by a presenter that is no more.
    if (qobject_cast<GlPresenter*>(m_presenter) == nullptr)
        return;
    QWidget* shown = &m_presenter->widget();
    delete std::exchange(m_presenter, nullptr);
    delete shown;
    makePresenter(PresenterChoice::Software);
    Q_EMIT presenterChanged();
    m_pacer.requestDraw();
    Q_EMIT glUnavailable(reason);
}

void HeadFrames::setHair(std::shared_ptr<const sim::StrandFrame> frame)
{
    const std::shared_ptr<const sim::StrandFrame>& shown = m_scene.scene().hair;
    // Cards stand still, but for the head that wears them.
    const bool unseen = m_scene.scene().cards && frame && shown && frame->pose == shown->pose;
    const bool isFirst = frame && !shown;
    const bool moved = (m_stillness.moved(frame, m_scene.camera(), m_area.size()) || isFirst) && !unseen;
    const bool finer = frame && shown && sim::frameDetail(*frame) > sim::frameDetail(*shown);
    if (m_pacer.still() && !moved && !finer)
        return; // A picture that is being refined is worth more than a difference nobody sees.
    m_scene.setHair(std::move(frame));
    if (moved)
        m_pacer.wake();
    else
        m_pacer.requestDraw();
}

bool HeadFrames::mayRefine() const
{
    // A finer picture of the bare head would only keep the hair waiting that is being made for it.
    return m_scene.scene().hair != nullptr;
}

void HeadFrames::draw()
{
    if (!m_area.isVisible())
        return; // Its showEvent asks again.
    m_pacer.drawing();
    const rendering::Scene& scene = m_scene.scene();
    m_presenter->present({.scene = scene,
                          .allHairs = scene.hair && !scene.cards ? scene.hair->hairCount : 0,
                          .still = m_pacer.still() && mayRefine()});
}

} // namespace hairpaint::view
