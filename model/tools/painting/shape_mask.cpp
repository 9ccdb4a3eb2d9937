// Drawing an outline's inside with Qt's antialiasing painter.
#include "model/tools/painting/shape_mask.h"

#include "model/maps/new_image.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

sim::TexelRect texelsAround(const QPolygonF& outline, int mapSize)
{
    const QRectF box = outline.boundingRect();
    const auto limited = [mapSize](double tx) { return static_cast<int>(std::clamp(tx, 0.0, double(mapSize))); };
    return {limited(std::floor(box.left())), limited(std::floor(box.top())), limited(std::ceil(box.right())),
            limited(std::ceil(box.bottom()))};
}

} // namespace

ShapeMask::ShapeMask(const QPolygonF& outlineTx, int mapSize)
    : m_mapSize(mapSize), m_rect(texelsAround(outlineTx, mapSize))
{
    if (m_rect.empty())
        return;
    const int width = m_rect.x1 - m_rect.x0;
    const int height = m_rect.y1 - m_rect.y0;
    QImage image = newImage(width, height, QImage::Format_Grayscale8);
    image.fill(Qt::black);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.translate(-m_rect.x0, -m_rect.y0);
    painter.drawPolygon(outlineTx, Qt::OddEvenFill);
    painter.end();
    m_cover.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        std::copy_n(image.constScanLine(y), width,
                    m_cover.begin() + static_cast<std::ptrdiff_t>(y) * static_cast<std::ptrdiff_t>(width));
}

void ShapeMask::addTo(StrokeBuffer& buffer, const sim::TexelRect& clip, bool mirrored) const
{
    const int width = m_rect.x1 - m_rect.x0;
    const int tilesAcross = m_mapSize / kTile;
    for (int y = std::max(m_rect.y0, clip.y0); y < std::min(m_rect.y1, clip.y1); ++y) {
        const std::uint8_t* row =
            m_cover.data() + static_cast<std::size_t>(y - m_rect.y0) * static_cast<std::size_t>(width);
        for (int column = 0; column < width; ++column) {
            const int x = mirrored ? m_mapSize - 1 - (m_rect.x0 + column) : m_rect.x0 + column;
            if (row[column] == 0 || x < clip.x0 || x >= clip.x1)
                continue;
            StrokeBuffer::MaskTile& tile = buffer.writableMask((y / kTile) * tilesAcross + x / kTile);
            std::uint16_t& mask =
                tile[static_cast<std::size_t>(y % kTile) * kTile + static_cast<std::size_t>(x % kTile)];
            mask = std::max(mask, static_cast<std::uint16_t>(row[column] * 257));
        }
    }
}

} // namespace hairpaint::model
