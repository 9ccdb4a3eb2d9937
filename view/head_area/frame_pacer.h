// When the 3D area's pictures are drawn, and whether what they show is still.
#pragma once

#include <QBasicTimer>
#include <QElapsedTimer>
#include <QObject>

namespace hairpaint::view {

/// GUI thread.
class FramePacer : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    void requestDraw();                     ///< Soon, at most once in 16 ms.
    void wake();                            ///< What is shown changes: draws fast until it is still again.
    void drawing() { m_sinceDraw.start(); } ///< To be called when a picture is begun.

    /// What is shown stays as it is for a moment now, though hair may go on moving by less than a pixel: it is refined.
    [[nodiscard]] bool still() const { return m_still; }
    /// Whether a picture is asked for, or what is shown counts as still in a moment.
    [[nodiscard]] bool waiting() const { return m_drawSoon.isActive() || m_settle.isActive(); }

Q_SIGNALS:
    void drawDue();    ///< The slot calls drawing() before it draws.
    void stillBegan(); ///< The slot asks for a finer picture, if one is wanted.
    void stillEnded();

protected:
    void timerEvent(QTimerEvent* event) override;

private:
    QBasicTimer m_drawSoon;
    QElapsedTimer m_sinceDraw;
    QBasicTimer m_settle; ///< Runs out when nothing woke this for a moment.
    bool m_still = false;
};

} // namespace hairpaint::view
