// The frame around an area of the window that the keyboard has brought the focus to.
#pragma once

#include <QWidget>

namespace hairpaint::view {

/// Lies over the edge of the widget it is a child of, from when that gets the focus by a key until it loses it or the
/// mouse takes over. The mouse goes through it. GUI thread.
class FocusRing : public QWidget
{
    Q_OBJECT
public:
    explicit FocusRing(QWidget* area);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void cover();
};

} // namespace hairpaint::view
