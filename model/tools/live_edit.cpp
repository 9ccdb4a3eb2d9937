// Previews and commits of a tool's tiles.
#include "model/tools/live_edit.h"

#include "model/tools/selection.h"

#include <algorithm>
#include <cmath>

namespace hairpaint::model {

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

std::optional<LiveLayer> LiveLayer::of(const ToolContext& context, const LayerAddress& address)
{
    const Layer* layer = context.document.committed().layer(address.group, address.map, address.layer);
    if (layer == nullptr || !layer->visible || layer->locked)
        return std::nullopt;
    return LiveLayer(address, layer->raster, selectedTexels(context.selection, layer->raster.size()));
}

void LiveLayer::update(EditSession& session, const std::vector<int>& tiles, const MakeTile& make)
{
    LayerTiles changed;
    for (const int index : tiles) {
        const sim::RasterTilePtr& before = m_before.tile(index);
        sim::RasterTilePtr tile = make(index, before);
        const auto shown = m_shown.find(index);
        if (tile == (shown == m_shown.end() ? before : shown->second))
            continue;
        changed.emplace_back(index, tile);
        m_shown.insert_or_assign(index, std::move(tile));
    }
    if (!changed.empty())
        session.previewTiles(m_address, changed);
}

void LiveLayer::replace(EditSession& session, const std::vector<int>& tiles, const MakeTile& make)
{
    std::vector<int> all = tiles;
    for (const auto& [index, tile] : m_shown)
        if (!std::ranges::binary_search(tiles, index))
            all.push_back(index);
    update(session, all, [&](int index, const sim::RasterTilePtr& before) {
        return std::ranges::binary_search(tiles, index) ? make(index, before) : before;
    });
}

bool LiveEdit::begin(const ToolContext& context, const QString& title, std::function<bool()> stepBack)
{
    context.document.endEdit(); // It may be of this very layer.
    std::optional<LiveLayer> layer = LiveLayer::of(context, context.target);
    if (!layer)
        return false;
    m_session =
        context.document.begin({.text = actionText(title, context.target.map), .stepBack = std::move(stepBack)});
    m_layer = std::move(layer);
    return true;
}

void LiveEdit::update(const std::vector<int>& tiles, const MakeTile& make)
{
    if (active())
        m_layer->update(m_session, tiles, make);
}

void LiveEdit::replace(const std::vector<int>& tiles, const MakeTile& make)
{
    if (active())
        m_layer->replace(m_session, tiles, make);
}

} // namespace hairpaint::model
