// A thin veil with a frame.
#include "view/widgets/drop_hint.h"

#include "view/look/theme.h"

#include <QPainter>

namespace hairpaint::view {

namespace {

constexpr float kDensity = 0.5F;

} // namespace

DropHint::DropHint(QWidget* parent) : Veil(parent, kDensity) {}

void DropHint::paintEvent(QPaintEvent* event)
{
    Veil::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Theme::current().accent, 2.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(9.0, 9.0, -9.0, -9.0), metrics::kRadius, metrics::kRadius);
}

} // namespace hairpaint::view
