// The transform from the map to the paint area: position, zoom, rotation, mirroring.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QTransform>

#include <glm/glm.hpp>

namespace hairpaint::view {

/// The paper is the unit square with y down: x = u, y = 1 - v. Lengths in the widget's own pixels.
struct UvTransform
{
    static constexpr double kMarginPx = 16.0;
    static constexpr double kGreatestPxPerTexel = 48.0;

    QPointF centrePaper{0.5, 0.5}; ///< Shown in the widget's middle.
    double pxPerPaper = 512.0;     ///< Side of the whole map.
    double rotationDeg = 0.0;      ///< Clockwise.
    bool mirrored = false;
    QSizeF widget{512.0, 512.0};

    [[nodiscard]] static QPointF paperOf(glm::vec2 uv)
    {
        return {static_cast<double>(uv.x), 1.0 - static_cast<double>(uv.y)};
    }
    [[nodiscard]] static glm::vec2 uvOf(QPointF paper)
    {
        return {static_cast<float>(paper.x()), static_cast<float>(1.0 - paper.y())};
    }

    [[nodiscard]] QTransform paperToWidget() const;
    [[nodiscard]] QPointF toWidget(glm::vec2 uv) const { return paperToWidget().map(paperOf(uv)); }
    [[nodiscard]] glm::vec2 toUv(QPointF position) const { return uvOf(paperToWidget().inverted().map(position)); }
    /// Side of the map where it just fits.
    [[nodiscard]] double fittingPx() const;

    /// Keeps what lies under `position` there. `texels`: the map's side, which bounds the zoom.
    void zoomAt(QPointF position, double factor, int texels);
    void panBy(QPointF pixels);
    /// Turns about the widget's middle.
    void rotateBy(double degrees);
    /// Mirrors about the widget's middle.
    void mirror();
    void fit(const QRectF& paper);
    void reset();
};

} // namespace hairpaint::view
