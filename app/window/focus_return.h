// Gives the keyboard focus to a dialog that opens over the window, and back to the window when it closes.
#pragma once

#include <QObject>

namespace hairpaint::app {

/// Watches every dialog while it lives: a modal one that is shown while the program has the keys becomes active, so
/// that Esc leaves it; one that was active and is hidden makes the window beneath it active. Most window managers do so
/// by themselves; where there is none (a kiosk, a remote display) keys would be dead.
class FocusReturn : public QObject
{
public:
    explicit FocusReturn(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace hairpaint::app
