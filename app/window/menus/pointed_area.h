// Which of both areas a command without a place of its own is for.
#pragma once

#include <QObject>

class QWidget;

namespace hairpaint::app {

/// The pointer's, or where it has left both, as for a menu or a panel, the one that it was over last. Belongs to
/// `head`; `paint` must live as long. GUI thread.
class PointedArea : public QObject
{
    Q_OBJECT
public:
    PointedArea(QWidget& head, QWidget& paint);
    /// Never an area that is not shown.
    [[nodiscard]] bool isHead() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_head;
    QWidget& m_paint;
    bool m_wasHead = false;
};

} // namespace hairpaint::app
