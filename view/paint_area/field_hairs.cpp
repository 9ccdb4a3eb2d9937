// A jittered grid of hairs that bend with the field.
#include "view/paint_area/field_hairs.h"

#include "sim/groom/direction_texel.h"
#include "view/look/tapered_hair.h"

#include <cmath>

namespace hairpaint::view {

namespace {

constexpr double kSpacingPx = 11.0; ///< To twice that, by the zoom.

/// A position within a cell, 0..1: not at its edges, where two hairs would meet. The same for the same cell.
double jitter(int column, int row, std::uint32_t salt)
{
    std::uint32_t h = static_cast<std::uint32_t>(column) * 0x9E3779B1U ^ static_cast<std::uint32_t>(row) * 0x85EBCA77U ^
                      salt * 0xC2B2AE3DU;
    h = (h ^ (h >> 15U)) * 0x2C1B3C6DU;
    h = (h ^ (h >> 13U)) * 0x297A2D39U;
    return 0.15 + 0.7 * (static_cast<double>(h >> 8U) / 16777216.0);
}

bool isSkin(const QImage& shading, QPointF paper)
{
    if (shading.isNull())
        return true;
    const int x = static_cast<int>(paper.x() * shading.width());
    const int y = static_cast<int>(paper.y() * shading.height());
    return shading.valid(x, y) && qAlpha(shading.pixel(x, y)) > 127;
}

class FieldHairs
{
public:
    FieldHairs(QPainter& painter, const UvTransform& transform, const sim::TiledRaster& map)
        : m_painter(painter), m_map(map), m_toWidget(transform.paperToWidget()), m_toPaper(m_toWidget.inverted())
    {}

    void draw(QPointF rootPaper)
    {
        const QPointF root = m_toWidget.map(rootPaper);
        const QPointF middle = root + directionAt(root) * 0.5;
        drawTaperedHair(m_painter, {root, middle, middle + directionAt(middle) * 0.5});
    }

private:
    /// In pixels of the widget.
    [[nodiscard]] QPointF directionAt(QPointF position) const
    {
        constexpr float kGreatest = 65535.0F;
        const glm::vec4 stored = m_map.sampleBilinear(UvTransform::uvOf(m_toPaper.map(position)));
        const glm::vec2 direction = sim::directionOfChannels(glm::vec2(stored) * kGreatest);
        // +y goes up the map, and the paper's y down.
        const QPointF paper(static_cast<double>(direction.x), -static_cast<double>(direction.y));
        const QPointF origin = m_toWidget.map(QPointF(0.0, 0.0));
        const QPointF onWidget = m_toWidget.map(paper) - origin;
        return onWidget * (kTaperedHairPx / scale());
    }
    [[nodiscard]] double scale() const { return std::sqrt(std::abs(m_toWidget.determinant())); }

    QPainter& m_painter;
    const sim::TiledRaster& m_map;
    QTransform m_toWidget;
    QTransform m_toPaper;
};

} // namespace

void drawFieldHairs(QPainter& painter, const QRect& dirty, const UvTransform& transform, const sim::TiledRaster& map,
                    const QImage& shading)
{
    // Halving the distance in steps keeps the roots of the coarser grid's cells near.
    const double step = std::exp2(std::ceil(std::log2(kSpacingPx / transform.pxPerPaper)));
    const int reach = kFieldHairReachPx;
    const QRectF seen = transform.paperToWidget()
                            .inverted()
                            .mapRect(QRectF(dirty.adjusted(-reach, -reach, reach, reach)))
                            .intersected(QRectF(0.0, 0.0, 1.0, 1.0));
    if (seen.isEmpty())
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    FieldHairs hairs(painter, transform, map);
    const auto cell = [step](double paper) { return static_cast<int>(std::floor(paper / step)); };
    for (int row = cell(seen.top()); row <= cell(seen.bottom()); ++row)
        for (int column = cell(seen.left()); column <= cell(seen.right()); ++column) {
            const QPointF root((column + jitter(column, row, 1)) * step, (row + jitter(column, row, 2)) * step);
            if (seen.contains(root) && isSkin(shading, root))
                hairs.draw(root);
        }
    painter.restore();
}

} // namespace hairpaint::view
