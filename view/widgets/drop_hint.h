// What lies over the areas while a file is dragged over the window: a frame, and what letting go will do.
#pragma once

#include "view/widgets/veil.h"

namespace hairpaint::view {

/// Fills its parent while it is shown; mouse and drag go through it.
class DropHint : public Veil
{
    Q_OBJECT
public:
    explicit DropHint(QWidget* parent);

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace hairpaint::view
