// Previews and commits of a tool's tiles.
#include "model/tools/live_edit.h"

#include "model/tools/strokes/selection.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

namespace {

/// Null where it is missing, hidden or locked.
const Layer* paintableLayer(const Project& project, const LayerAddress& at)
{
    const Layer* layer = project.layer(at.group, at.map, at.layer);
    return layer != nullptr && layer->visible && !layer->locked ? layer : nullptr;
}

} // namespace

std::vector<sim::TexelRect> selectedTexels(const Selection& selection, int size)
{
    if (selection.rectangles().empty())
        return {{0, 0, size, size}};
    const auto texel = [size](double fraction) {
        return static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * size));
    };
    std::vector<sim::TexelRect> rects;
    for (const QRectF& uv : selection.rectangles()) {
        // Neighbours share a border, which is rounded alike for both.
        const sim::TexelRect rect{texel(uv.left()), texel(1.0 - uv.bottom()), texel(uv.right()), texel(1.0 - uv.top())};
        if (!rect.empty())
            rects.push_back(rect);
    }
    return rects;
}

bool contains(const std::vector<sim::TexelRect>& rects, int x, int y)
{
    return std::ranges::any_of(rects, [x, y](const sim::TexelRect& rect) {
        return x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1;
    });
}

void keepInside(const std::vector<sim::TexelRect>& rects, const sim::TexelRect& tile, StrokeBuffer::MaskTile& mask)
{
    const bool whole =
        std::ranges::any_of(rects, [&](const sim::TexelRect& rect) { return shared(rect, tile) == tile; });
    if (whole)
        return;
    auto texel = mask.begin();
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x, ++texel)
            if (!contains(rects, x, y))
                *texel = 0;
}

sim::TexelRect shared(const sim::TexelRect& a, const sim::TexelRect& b)
{
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

std::vector<int> tilesIn(const sim::TiledRaster& raster, const std::vector<sim::TexelRect>& rects)
{
    std::vector<int> tiles;
    constexpr int kTile = sim::TiledRaster::kTileSize;
    for (const sim::TexelRect& rect : rects)
        for (int row = rect.y0 / kTile; row <= (rect.y1 - 1) / kTile; ++row)
            for (int column = rect.x0 / kTile; column <= (rect.x1 - 1) / kTile; ++column)
                tiles.push_back(row * raster.tilesAcross() + column);
    std::ranges::sort(tiles);
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
    return tiles;
}

QString actionText(const QString& title, MapKind map)
{
    return QCoreApplication::translate("Tool", "%1 on %2").arg(title, mapSpec(map).titleText());
}

bool LiveEdit::begin(const ToolContext& context, const QString& title, std::function<bool()> stepBack)
{
    const LayerAddress& at = context.target;
    context.document.endEdit(); // It may be of this very layer.
    if (paintableLayer(context.document.committed(), at) == nullptr)
        return false;
    m_session = context.document.begin({.text = actionText(title, at.map), .stepBack = std::move(stepBack)});
    m_layers.clear();
    return also(context, at).has_value();
}

std::optional<std::size_t> LiveEdit::also(const ToolContext& context, const LayerAddress& address)
{
    const Layer* layer = paintableLayer(context.document.committed(), address);
    if (layer == nullptr)
        return std::nullopt;
    m_layers.push_back({.address = address,
                        .blend = layer->blend,
                        .before = layer->raster,
                        .clips = selectedTexels(context.selection, layer->raster.size())});
    return m_layers.size() - 1;
}

void LiveEdit::update(const std::vector<int>& tiles, const MakeTile& make, std::size_t layer)
{
    if (!active())
        return;
    Edited& edited = m_layers[layer];
    LayerTiles changed;
    for (const int index : tiles) {
        const sim::RasterTilePtr& before = edited.before.tile(index);
        sim::RasterTilePtr tile = make(index, before);
        const auto shown = edited.shown.find(index);
        if (tile == (shown == edited.shown.end() ? before : shown->second))
            continue;
        changed.emplace_back(index, tile);
        edited.shown.insert_or_assign(index, std::move(tile));
    }
    if (!changed.empty())
        m_session.previewTiles(edited.address, changed);
}

void LiveEdit::replace(const std::vector<int>& tiles, const MakeTile& make, std::size_t layer)
{
    std::vector<int> all = tiles;
    for (const auto& [index, tile] : m_layers[layer].shown)
        if (!std::ranges::binary_search(tiles, index))
            all.push_back(index);
    update(
        all,
        [&](int index, const sim::RasterTilePtr& before) {
            return std::ranges::binary_search(tiles, index) ? make(index, before) : before;
        },
        layer);
}

} // namespace hairpaint::model
