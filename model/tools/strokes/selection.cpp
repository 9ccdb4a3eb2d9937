// The algebra of rectangles.
#include "model/tools/strokes/selection.h"

#include <QPainterPath>
#include <QTransform>

#include <algorithm>

namespace hairpaint::model {

namespace {

const QRectF kWhole(0.0, 0.0, 1.0, 1.0);

} // namespace

std::vector<QRectF> without(const std::vector<QRectF>& rectangles, const QRectF& taken)
{
    std::vector<QRectF> left;
    const auto keep = [&left](double x0, double y0, double x1, double y1) {
        if (x1 > x0 && y1 > y0)
            left.emplace_back(QPointF(x0, y0), QPointF(x1, y1));
    };
    for (const QRectF& r : rectangles) {
        const QRectF hole = r.intersected(taken);
        if (hole.isEmpty()) {
            left.push_back(r);
            continue;
        }
        keep(r.left(), r.top(), r.right(), hole.top());
        keep(r.left(), hole.top(), hole.left(), hole.bottom());
        keep(hole.right(), hole.top(), r.right(), hole.bottom());
        keep(r.left(), hole.bottom(), r.right(), r.bottom());
    }
    return left;
}

std::optional<QRectF> Selection::rectangle() const
{
    if (m_rectangles.empty())
        return std::nullopt;
    QRectF around = m_rectangles.front();
    for (const QRectF& rectangle : m_rectangles)
        around = around.united(rectangle);
    return around;
}

std::vector<QPolygonF> Selection::outlines() const
{
    // Qt joins paths on a grid that is coarse for numbers below 1.
    constexpr double kScale = 8192.0;
    const QTransform larger = QTransform::fromScale(kScale, kScale);
    QPainterPath path;
    for (const QRectF& rectangle : m_rectangles)
        path.addRect(larger.mapRect(rectangle));
    std::vector<QPolygonF> outlines;
    for (QPolygonF& outline : path.simplified().toSubpathPolygons(larger.inverted())) {
        if (outline.isClosed())
            outline.removeLast();
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

void Selection::setRectangles(std::vector<QRectF> rectangles)
{
    if (rectangles == m_rectangles)
        return;
    m_rectangles = std::move(rectangles);
    Q_EMIT changed();
}

void Selection::setRectangle(const std::optional<QRectF>& rectangle)
{
    setRectangles(rectangle ? std::vector<QRectF>{*rectangle} : std::vector<QRectF>());
}

void Selection::invert()
{
    std::vector<QRectF> rest{kWhole};
    for (const QRectF& rectangle : m_rectangles)
        rest = without(rest, rectangle);
    setRectangles(std::move(rest));
}

} // namespace hairpaint::model
