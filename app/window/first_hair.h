// What waits until the program's first hair is seen.
#pragma once

#include <QObject>
#include <QPointer>

#include <functional>
#include <vector>

namespace hairpaint::view {
class HeadView;
}

namespace hairpaint::app {

class Session;

/// The first hair takes all processors for a second. What can come after it (lists, pictures, the map's backdrop) would
/// only keep it waiting. GUI thread.
class FirstHair : public QObject
{
public:
    explicit FirstHair(const Session& session);

    /// Where the hair is drawn; a hidden area draws nothing, so that nothing waits for it.
    void showIn(view::HeadView& head) { m_head = &head; }

    /// Calls it once: after the first hair was drawn, or could not be made; at once where that is so already. Not where
    /// `receiver` is gone by then.
    void then(QObject* receiver, std::function<void()> work);

private:
    void onMade();
    void onSeen();

    struct Waiting
    {
        QPointer<QObject> receiver;
        std::function<void()> work;
    };
    QPointer<view::HeadView> m_head;
    std::vector<Waiting> m_waiting;
    bool m_seen = false;
};

} // namespace hairpaint::app
