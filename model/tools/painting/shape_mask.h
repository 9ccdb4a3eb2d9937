// Filled outlines as masks.
#pragma once

#include "model/tools/strokes/stroke_buffer.h"

#include <QPolygonF>

namespace hairpaint::model {

/// A filled outline, smooth at its edge, in texels of a map (y down).
class ShapeMask
{
public:
    ShapeMask(const QPolygonF& outlineTx, int mapSize);

    /// The texels it may cover.
    [[nodiscard]] const sim::TexelRect& rect() const { return m_rect; }
    /// Lays it over a stroke buffer (the greater mask counts), and where wanted its reflection at u = 1/2, to the bit.
    void addTo(StrokeBuffer& buffer, const sim::TexelRect& clip, bool mirrored) const;

private:
    int m_mapSize;
    sim::TexelRect m_rect;
    std::vector<std::uint8_t> m_cover; ///< Coverage of the texels of m_rect, row by row; 255 is full.
};

} // namespace hairpaint::model
