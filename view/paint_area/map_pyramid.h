// A map's picture as a pyramid of tiles, drawn on demand and updated where the map changes.
#pragma once

#include "model/project/map_spec.h"
#include "sim/base/tiled_raster.h"

#include <QImage>
#include <QList>
#include <QPainter>
#include <QRect>
#include <QRectF>

#include <memory>
#include <vector>

namespace hairpaint::view {

/// Texels of a map of `size` by `size` on the paper.
[[nodiscard]] QRectF paperRect(const sim::TexelRect& rect, int size);

/// Paper coordinates: the unit square, y down. Uniform tiles are one pixel. What shows much of a large map small is
/// drawn of samples first, which refine() replaces by means. GUI thread.
class MapPyramid
{
public:
    static constexpr int kTileSide = 256;

    /// Shows another state of a map. Returns the parts of the paper that look different.
    QList<QRectF> setSource(std::shared_ptr<const sim::TiledRaster> raster, const model::MapSpec& spec,
                            bool nightPaper);
    [[nodiscard]] const std::shared_ptr<const sim::TiledRaster>& raster() const { return m_raster; }

    /// Draws what `visiblePaper` covers. Smooth where texels are smaller than pixels, crisp where they are larger.
    void draw(QPainter& painter, const QTransform& paperToWidget, const QRectF& visiblePaper, double devicePixelRatio);
    /// Whether the last drawing used tiles of samples.
    [[nodiscard]] bool isCoarse() const;
    /// Replaces samples by means for about `milliseconds`. Returns the parts of the paper that look
    /// different.
    QList<QRectF> refine(double milliseconds);
    /// Pictures held, in bytes.
    [[nodiscard]] std::size_t byteCount() const;

private:
    struct Level
    {
        int side = 0;   ///< Texels.
        int across = 0; ///< Tiles.
        int tileSide = kTileSide;
        std::vector<QImage> tiles;        ///< Null: not drawn yet.
        std::vector<std::uint8_t> coarse; ///< 1: of samples.
        [[nodiscard]] std::size_t indexOf(int column, int row) const
        {
            return static_cast<std::size_t>(row) * static_cast<std::size_t>(across) + static_cast<std::size_t>(column);
        }
    };

    void rebuildLevels();
    /// Repaints one raster tile in every picture that shows it.
    void mend(int rasterTile);
    /// Those of a level that are not there yet, on several threads; of samples where means would take too long.
    void makeTiles(std::size_t level, const QRect& cells);
    const QImage& tile(std::size_t level, int column, int row);
    [[nodiscard]] bool isThere(std::size_t level, int column, int row) const;
    void sampleTile(std::size_t level, int column, int row);
    /// Draws one missing picture that the tile is a mean of, or, if none is missing, the tile itself: then true.
    bool makeOne(std::size_t level, int column, int row);
    [[nodiscard]] QImage paintedTile(int column, int row) const;
    [[nodiscard]] QImage halvedTile(std::size_t level, int column, int row);
    [[nodiscard]] bool uniform(const sim::TexelRect& rect, sim::Texel& value) const;
    void trim(const QRectF& visiblePaper);

    std::shared_ptr<const sim::TiledRaster> m_raster;
    const model::MapSpec* m_spec = nullptr;
    bool m_nightPaper = true;
    std::vector<Level> m_levels;
    std::size_t m_drawnLevel = 0; ///< Last, and which of its tiles.
    QRect m_drawnCells;
};

} // namespace hairpaint::view
