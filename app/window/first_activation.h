// Runs the first action of the program once its window has the keyboard focus.
#pragma once

#include <QObject>
#include <QTimer>

#include <functional>

class QWidget;

namespace hairpaint::app {

/// Calls `begin` once, from the event loop: as soon as `window` is active, or a while after it was not, as where it
/// came up behind another program's. GUI thread.
class FirstActivation : public QObject
{
public:
    FirstActivation(QWidget& window, std::function<void()> begin);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QTimer m_timer;
};

} // namespace hairpaint::app
