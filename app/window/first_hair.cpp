// From the session's first frame to the picture of it: see the header.
#include "app/window/first_hair.h"

#include "app/session/session.h"
#include "view/head_area/head_view.h"

#include <utility>

namespace hairpaint::app {

FirstHair::FirstHair(const Session& session)
{
    connect(&session, &Session::frameChanged, this, &FirstHair::onMade, Qt::SingleShotConnection);
    connect(&session, &Session::hairFailed, this, &FirstHair::onSeen, Qt::SingleShotConnection);
}

void FirstHair::then(QObject* receiver, std::function<void()> work)
{
    if (m_seen)
        return work();
    m_waiting.push_back({receiver, std::move(work)});
}

void FirstHair::onMade()
{
    if (m_head && m_head->isVisible())
        connect(m_head, &view::HeadView::frameDrawn, this, &FirstHair::onSeen, Qt::SingleShotConnection);
    else
        onSeen();
}

void FirstHair::onSeen()
{
    m_seen = true;
    for (const Waiting& one : std::exchange(m_waiting, {}))
        if (one.receiver)
            one.work();
}

} // namespace hairpaint::app
