// Keys go to the window again when a dialog over it has closed.
#pragma once

#include <QObject>

namespace hairpaint::app {

/// Watches every dialog while it lives: one that was active and is hidden makes the window beneath it active. Most
/// window managers do so by themselves; where there is none (a kiosk, a remote display) shortcuts would be dead.
class FocusReturn : public QObject
{
public:
    explicit FocusReturn(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace hairpaint::app
