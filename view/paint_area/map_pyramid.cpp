// Tiles of a map's picture.
#include "view/paint_area/map_pyramid.h"

#include "model/files/image_map.h"
#include "sim/base/parallel.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

/// Where more tiles change than this, all pictures are made anew when they are wanted.
constexpr int kMendedAtOnce = 96;
/// Number of finest pictures above which those out of sight are dropped: 48 MB.
constexpr int kKeptTiles = 192;
/// Side in texels above which a map's finest pictures are dropped as soon as they are halved.
constexpr int kLargestKeptSide = 4096;

/// Side in texels above which the smaller pictures of a map are sampled first, and averaged later.
constexpr int kLargestAtOnce = 1024;
constexpr int kMostApart = sim::TiledRaster::kTileSize;

QRgb averaged(QRgb a, QRgb b, QRgb c, QRgb d)
{
    return qRgba(
        (qRed(a) + qRed(b) + qRed(c) + qRed(d) + 2) / 4, (qGreen(a) + qGreen(b) + qGreen(c) + qGreen(d) + 2) / 4,
        (qBlue(a) + qBlue(b) + qBlue(c) + qBlue(d) + 2) / 4, (qAlpha(a) + qAlpha(b) + qAlpha(c) + qAlpha(d) + 2) / 4);
}

/// Halves `rect` (of the target, in pixels) from `source` at twice the offset less `sourceOrigin`.
void halve(const QImage& source, QPoint sourceOrigin, QImage& target, const QRect& rect)
{
    for (int y = rect.top(); y <= rect.bottom(); ++y) {
        const auto* upper = reinterpret_cast<const QRgb*>(source.constScanLine(2 * y - sourceOrigin.y()));
        const auto* lower = reinterpret_cast<const QRgb*>(source.constScanLine(2 * y + 1 - sourceOrigin.y()));
        auto* line = reinterpret_cast<QRgb*>(target.scanLine(y));
        for (int x = rect.left(); x <= rect.right(); ++x) {
            const int at = 2 * x - sourceOrigin.x();
            line[x] = averaged(upper[at], upper[at + 1], lower[at], lower[at + 1]);
        }
    }
}

bool single(const QImage& image)
{
    return image.width() == 1;
}

} // namespace

QRectF paperRect(const sim::TexelRect& rect, int size)
{
    const double scale = 1.0 / size;
    return {rect.x0 * scale, rect.y0 * scale, (rect.x1 - rect.x0) * scale, (rect.y1 - rect.y0) * scale};
}

QList<QRectF> MapPyramid::setSource(std::shared_ptr<const sim::TiledRaster> raster, const model::MapSpec& spec,
                                    bool nightPaper)
{
    const std::shared_ptr<const sim::TiledRaster> before = std::exchange(m_raster, std::move(raster));
    const bool alike =
        before && m_raster && before->size() == m_raster->size() && m_spec == &spec && m_nightPaper == nightPaper;
    m_spec = &spec;
    m_nightPaper = nightPaper;
    if (!alike) {
        rebuildLevels();
        return {QRectF(0.0, 0.0, 1.0, 1.0)};
    }
    std::vector<int> changed;
    QList<QRectF> changedPaper;
    for (int i = 0; i < m_raster->tileCount(); ++i) {
        if (m_raster->tile(i) != before->tile(i)) {
            changed.push_back(i);
            changedPaper.push_back(paperRect(m_raster->tileRect(i), m_raster->size()));
        }
    }
    if (static_cast<int>(changed.size()) > kMendedAtOnce) {
        rebuildLevels();
        return {QRectF(0.0, 0.0, 1.0, 1.0)};
    }
    std::ranges::for_each(changed, [this](int i) { mend(i); });
    return changedPaper;
}

void MapPyramid::rebuildLevels()
{
    m_levels.clear();
    m_drawnCells = {};
    if (!m_raster)
        return;
    int side = m_raster->size();
    while (true) {
        const int tileSide = std::min(side, kTileSide);
        const int across = side / tileSide;
        m_levels.push_back({side, across, tileSide, std::vector<QImage>(static_cast<std::size_t>(across) * across),
                            std::vector<std::uint8_t>(static_cast<std::size_t>(across) * across)});
        if (side <= kTileSide)
            break;
        side /= 2;
    }
}

void MapPyramid::mend(int rasterTile)
{
    sim::TexelRect rect = m_raster->tileRect(rasterTile);
    const Level* below = nullptr;
    QPoint belowTile;
    for (Level& level : m_levels) {
        const QPoint tile(rect.x0 / level.tileSide, rect.y0 / level.tileSide);
        QImage& image = level.tiles[level.indexOf(tile.x(), tile.y())];
        if (image.isNull() || single(image)) {
            // The levels above can't be mended from this tile: it is made anew when wanted.
            image = QImage();
        } else {
            const QRect inTile(rect.x0 - tile.x() * level.tileSide, rect.y0 - tile.y() * level.tileSide,
                               std::max(1, rect.x1 - rect.x0), std::max(1, rect.y1 - rect.y0));
            if (below == nullptr) {
                auto* pixels = reinterpret_cast<QRgb*>(image.scanLine(inTile.top())) + inTile.left();
                model::paintMapTexels(*m_raster, *m_spec, m_nightPaper, rect, pixels,
                                      static_cast<int>(image.bytesPerLine() / 4));
            } else {
                const QImage& source = below->tiles[below->indexOf(belowTile.x(), belowTile.y())];
                if (source.isNull() || single(source)) {
                    image = QImage();
                } else {
                    const QPoint origin = belowTile * below->tileSide - 2 * tile * level.tileSide;
                    halve(source, origin, image, inTile);
                }
            }
        }
        below = &level;
        belowTile = tile;
        rect = {rect.x0 / 2, rect.y0 / 2, (rect.x1 + 1) / 2, (rect.y1 + 1) / 2};
    }
}

bool MapPyramid::uniform(const sim::TexelRect& rect, sim::Texel& value) const
{
    bool first = true;
    for (int y = rect.y0; y < rect.y1; y += sim::TiledRaster::kTileSize) {
        for (int x = rect.x0; x < rect.x1; x += sim::TiledRaster::kTileSize) {
            const sim::RasterTilePtr& tile = m_raster->tile(m_raster->tileIndexAt(x, y));
            if (!tile->isUniform() || (!first && tile->uniform != value))
                return false;
            value = tile->uniform;
            first = false;
        }
    }
    return true;
}

QImage MapPyramid::paintedTile(int column, int row) const
{
    const int side = m_levels.front().tileSide;
    sim::TexelRect rect{column * side, row * side, (column + 1) * side, (row + 1) * side};
    sim::Texel value{};
    if (uniform(rect, value))
        rect = {rect.x0, rect.y0, rect.x0 + 1, rect.y0 + 1};
    QImage image(rect.x1 - rect.x0, rect.y1 - rect.y0, QImage::Format_RGB32);
    model::paintMapTexels(*m_raster, *m_spec, m_nightPaper, rect, reinterpret_cast<QRgb*>(image.bits()),
                          static_cast<int>(image.bytesPerLine() / 4));
    return image;
}

QImage MapPyramid::halvedTile(std::size_t level, int column, int row)
{
    bool allSingle = true;
    std::array<QImage, 4> children;
    for (int i = 0; i < 4; ++i) {
        QImage& child = children[static_cast<std::size_t>(i)];
        child = tile(level - 1, 2 * column + i % 2, 2 * row + i / 2);
        allSingle = allSingle && single(child) && child.pixel(0, 0) == children[0].pixel(0, 0);
    }
    if (allSingle)
        return children[0];
    if (level == 1 && m_levels.front().side > kLargestKeptSide) {
        for (int i = 0; i < 4; ++i)
            m_levels.front().tiles[m_levels.front().indexOf(2 * column + i % 2, 2 * row + i / 2)] = QImage();
    }
    QImage image(kTileSide, kTileSide, QImage::Format_RGB32);
    constexpr int kHalf = kTileSide / 2;
    for (int i = 0; i < 4; ++i) {
        const QRect part(i % 2 * kHalf, i / 2 * kHalf, kHalf, kHalf);
        const QImage& child = children[static_cast<std::size_t>(i)];
        if (!single(child)) {
            halve(child, part.topLeft() * 2, image, part);
            continue;
        }
        for (int y = part.top(); y <= part.bottom(); ++y) {
            auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
            std::fill(line + part.left(), line + part.right() + 1, child.pixel(0, 0));
        }
    }
    return image;
}

bool MapPyramid::isThere(std::size_t level, int column, int row) const
{
    const std::size_t index = m_levels[level].indexOf(column, row);
    return !m_levels[level].tiles[index].isNull() && m_levels[level].coarse[index] == 0;
}

const QImage& MapPyramid::tile(std::size_t level, int column, int row)
{
    const std::size_t index = m_levels[level].indexOf(column, row);
    if (!isThere(level, column, row)) {
        m_levels[level].tiles[index] = level == 0 ? paintedTile(column, row) : halvedTile(level, column, row);
        m_levels[level].coarse[index] = 0;
    }
    return m_levels[level].tiles[index];
}

void MapPyramid::sampleTile(std::size_t level, int column, int row)
{
    Level& own = m_levels[level];
    const std::size_t index = own.indexOf(column, row);
    if (!own.tiles[index].isNull())
        return;
    const int apart = m_levels.front().side / own.side;
    const int side = own.tileSide * apart;
    const sim::TexelRect rect{column * side, row * side, (column + 1) * side, (row + 1) * side};
    sim::Texel value{};
    if (uniform(rect, value)) {
        (void)tile(level, column, row);
        return;
    }
    own.tiles[index] = QImage(own.tileSide, own.tileSide, QImage::Format_RGB32);
    own.coarse[index] = 1;
    QImage& image = own.tiles[index];
    model::paintMapSamples(*m_raster, *m_spec, m_nightPaper, rect, apart, reinterpret_cast<QRgb*>(image.bits()),
                           static_cast<int>(image.bytesPerLine() / 4));
}

bool MapPyramid::makeOne(std::size_t level, int column, int row)
{
    for (int i = 0; level > 0 && i < 4; ++i) {
        const QPoint child(2 * column + i % 2, 2 * row + i / 2);
        if (!isThere(level - 1, child.x(), child.y())) {
            (void)makeOne(level - 1, child.x(), child.y());
            return false;
        }
    }
    (void)tile(level, column, row);
    return true;
}

bool MapPyramid::isCoarse() const
{
    if (m_drawnLevel >= m_levels.size())
        return false;
    const Level& level = m_levels[m_drawnLevel];
    for (int row = m_drawnCells.top(); row <= m_drawnCells.bottom(); ++row)
        for (int column = m_drawnCells.left(); column <= m_drawnCells.right(); ++column)
            if (level.coarse[level.indexOf(column, row)] != 0)
                return true;
    return false;
}

QList<QRectF> MapPyramid::refine(double milliseconds)
{
    QList<QRectF> refined;
    if (!isCoarse())
        return refined;
    const Level& level = m_levels[m_drawnLevel];
    QElapsedTimer timer;
    timer.start();
    for (int row = m_drawnCells.top(); row <= m_drawnCells.bottom(); ++row)
        for (int column = m_drawnCells.left(); column <= m_drawnCells.right(); ++column)
            while (level.coarse[level.indexOf(column, row)] != 0) {
                if (makeOne(m_drawnLevel, column, row))
                    refined.append(QRectF(QPointF(column, row) / level.across, QSizeF(1.0, 1.0) / level.across));
                if (static_cast<double>(timer.nsecsElapsed()) > milliseconds * 1e6)
                    return refined;
            }
    return refined;
}

void MapPyramid::makeTiles(std::size_t level, const QRect& cells)
{
    // What a tile is made of belongs to no other one of its level.
    const auto count = static_cast<std::size_t>(cells.width()) * static_cast<std::size_t>(cells.height());
    const int apart = m_levels.front().side / m_levels[level].side;
    const bool sampled = m_levels.front().side > kLargestAtOnce && apart > 1 && apart <= kMostApart;
    sim::parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int column = cells.left() + static_cast<int>(i) % cells.width();
            const int row = cells.top() + static_cast<int>(i) / cells.width();
            sampled ? sampleTile(level, column, row) : (void)tile(level, column, row);
        }
    });
}

void MapPyramid::draw(QPainter& painter, const QTransform& paperToWidget, const QRectF& visiblePaper,
                      double devicePixelRatio)
{
    if (!m_raster)
        return;
    const double pxPerPaper = std::sqrt(std::abs(paperToWidget.determinant())) * devicePixelRatio;
    std::size_t chosen = 0;
    while (chosen + 1 < m_levels.size() && pxPerPaper < 0.7 * m_levels[chosen].side)
        ++chosen;
    const int across = m_levels[chosen].across;
    const bool square = paperToWidget.m12() == 0.0 && paperToWidget.m21() == 0.0;
    // Edges on whole device pixels leave no hairlines between tiles.
    const QTransform toDevice = paperToWidget * QTransform::fromScale(devicePixelRatio, devicePixelRatio);
    const QTransform fromDevice = toDevice.inverted();
    const auto snapped = [&](QPointF paper) {
        return square ? fromDevice.map(QPointF(toDevice.map(paper).toPoint())) : paper;
    };
    painter.save();
    painter.setTransform(paperToWidget, true);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, pxPerPaper < 2.0 * m_levels[chosen].side);
    const auto cell = [across](double x) {
        return std::clamp(static_cast<int>(std::floor(x * across)), 0, across - 1);
    };
    const QRect cells(QPoint(cell(visiblePaper.left()), cell(visiblePaper.top())),
                      QPoint(cell(visiblePaper.right()), cell(visiblePaper.bottom())));
    makeTiles(chosen, cells);
    // What is drawn anew is often a part of what is seen.
    m_drawnCells = chosen == m_drawnLevel ? m_drawnCells.united(cells) : cells;
    m_drawnLevel = chosen;
    for (int row = cells.top(); row <= cells.bottom(); ++row) {
        for (int column = cells.left(); column <= cells.right(); ++column) {
            const QPointF topLeft = snapped(QPointF(column, row) / across);
            const QPointF bottomRight = snapped(QPointF(column + 1, row + 1) / across);
            const QImage& image = m_levels[chosen].tiles[m_levels[chosen].indexOf(column, row)];
            if (single(image))
                painter.fillRect(QRectF(topLeft, bottomRight), QColor(image.pixel(0, 0)));
            else
                painter.drawImage(QRectF(topLeft, bottomRight), image);
        }
    }
    painter.restore();
    trim(visiblePaper);
}

void MapPyramid::trim(const QRectF& visiblePaper)
{
    Level& finest = m_levels.front();
    const auto kept = std::ranges::count_if(finest.tiles, [](const QImage& image) { return image.width() > 1; });
    if (kept <= kKeptTiles)
        return;
    for (int i = 0; i < static_cast<int>(finest.tiles.size()); ++i) {
        const QPoint tile(i % finest.across, i / finest.across);
        const QPointF topLeft = QPointF(tile) / finest.across;
        if (!visiblePaper.intersects(QRectF(topLeft, QSizeF(1.0, 1.0) / finest.across)))
            finest.tiles[static_cast<std::size_t>(i)] = QImage();
    }
}

std::size_t MapPyramid::byteCount() const
{
    std::size_t bytes = 0;
    for (const Level& level : m_levels) {
        for (const QImage& image : level.tiles)
            bytes += static_cast<std::size_t>(image.sizeInBytes());
    }
    return bytes;
}

} // namespace hairpaint::view
