// The paint area's navigation.
#include "view/paint_area/uv_transform.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

QTransform UvTransform::paperToWidget() const
{
    QTransform transform;
    transform.translate(widget.width() / 2.0, widget.height() / 2.0);
    transform.rotate(rotationDeg);
    transform.scale(mirrored ? -pxPerPaper : pxPerPaper, pxPerPaper);
    transform.translate(-centrePaper.x(), -centrePaper.y());
    return transform;
}

double UvTransform::fittingPx() const
{
    return std::max(64.0, std::min(widget.width(), widget.height()) - 2.0 * kMarginPx);
}

void UvTransform::zoomAt(QPointF position, double factor, int texels)
{
    const QPointF before = paperToWidget().inverted().map(position);
    pxPerPaper =
        std::clamp(pxPerPaper * factor, 0.25 * fittingPx(), std::max(fittingPx(), kGreatestPxPerTexel * texels));
    const QPointF after = paperToWidget().inverted().map(position);
    centrePaper += before - after;
}

void UvTransform::panBy(QPointF pixels)
{
    const QTransform back = paperToWidget().inverted();
    centrePaper -= back.map(pixels) - back.map(QPointF(0.0, 0.0));
    // Some of the map always stays in reach.
    centrePaper.setX(std::clamp(centrePaper.x(), -0.25, 1.25));
    centrePaper.setY(std::clamp(centrePaper.y(), -0.25, 1.25));
}

void UvTransform::rotateBy(double degrees)
{
    rotationDeg = std::remainder(rotationDeg + degrees, 360.0);
}

void UvTransform::mirror()
{
    mirrored = !mirrored;
    rotationDeg = -rotationDeg;
}

void UvTransform::fit(const QRectF& paper)
{
    centrePaper = paper.center();
    const double across = std::max({paper.width(), paper.height(), 0.01});
    pxPerPaper = fittingPx() / across;
}

void UvTransform::reset()
{
    rotationDeg = 0.0;
    mirrored = false;
    fit(QRectF(0.0, 0.0, 1.0, 1.0));
}

} // namespace hairpaint::view
