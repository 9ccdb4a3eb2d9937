// How the view is turned, over the 3D area of those who have not yet done it.
#pragma once

#include <QLabel>

namespace hairpaint::view {

/// At the foot of its parent; lets every pointer event through. GUI thread.
class TurnHint : public QLabel
{
    Q_OBJECT
public:
    explicit TurnHint(QWidget& area);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void reposition();
};

} // namespace hairpaint::view
