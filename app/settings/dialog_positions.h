// Where dialogs open: beside the head, not over it, and where the user left them.
#pragma once

#include "app/settings/settings.h"

#include <QObject>
#include <QPoint>
#include <QPointer>
#include <QRect>

#include <functional>
#include <map>

class QDialog;

namespace hairpaint::app {

/// Global, px, frames included.
struct DialogRoom
{
    QRect window;
    QRect head;   ///< The 3D area; empty where it is not shown.
    QRect screen; ///< What of the window's screen is free.
};

/// The top left corner at which a dialog of `size` hides least of the head: over what lies beside the 3D area, else at
/// the window's edge. Inside the screen; what is larger keeps its title there.
[[nodiscard]] QPoint positionBesideHead(QSize size, const DialogRoom& room);
/// The position nearest to `wanted` that is inside the screen.
[[nodiscard]] QPoint insideScreen(QPoint wanted, QSize size, const QRect& screen);

/// Moves the window's dialogs when they are shown, and keeps where the user moves them. Questions, file dialogs and
/// what tells of long work stay in the middle, where the system puts them. GUI thread.
class DialogPositions : public QObject
{
    Q_OBJECT
public:
    /// `head`: the 3D area as it lies now.
    DialogPositions(QWidget& window, Settings& settings, std::function<QRect()> head);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool isOurs(const QDialog& dialog) const;
    void position(QDialog& dialog);
    void keepInside(QDialog& dialog); ///< Moves it back into the screen after it has grown.
    [[nodiscard]] static bool isMoved(const QDialog& dialog, QPoint from); ///< By the user.
    void remember(QDialog& dialog);

    QWidget& m_window;
    Settings& m_settings;
    std::function<QRect()> m_head;
    std::map<const QDialog*, QPoint> m_positions; ///< Positions of the dialogs that are shown.
};

} // namespace hairpaint::app
