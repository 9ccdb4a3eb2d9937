// Undo of painting: only the touched tiles are kept.
#include "model/commands/commands.h"
#include "model/commands/undo_budget.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

class PaintCommand : public QUndoCommand, public TileHolder
{
public:
    PaintCommand(Document& document, const LayerAddress& address, std::vector<std::pair<int, sim::RasterTilePtr>> tiles,
                 const QString& text)
        : QUndoCommand(text), m_document(document), m_address(address), m_tiles(std::move(tiles))
    {}
    void redo() override { swapTiles(); }
    void undo() override { swapTiles(); }
    void visitTiles(const Visit& visit) const override
    {
        for (const auto& [index, tile] : m_tiles)
            visit(tile);
    }
    void release() override { m_tiles = {}; }

private:
    void swapTiles()
    {
        Change change{
            .aspect = Change::Aspect::Texels, .group = m_address.group, .map = m_address.map, .layer = m_address.layer};
        for (const auto& [index, tile] : m_tiles)
            change.tiles.push_back(index);
        m_document.apply(change, [this](Project& project) {
            Layer* layer = project.layer(m_address.group, m_address.map, m_address.layer);
            if (layer == nullptr)
                return;
            for (auto& [index, tile] : m_tiles) {
                sim::RasterTilePtr other = layer->raster.tile(index);
                layer->raster.setTile(index, std::move(tile));
                tile = std::move(other);
            }
        });
    }

    Document& m_document;
    LayerAddress m_address;
    std::vector<std::pair<int, sim::RasterTilePtr>> m_tiles; ///< What the next swap puts in.
};

} // namespace

CommandPtr paintCommand(Document& document, const LayerAddress& address,
                        std::vector<std::pair<int, sim::RasterTilePtr>> after, const QString& text)
{
    const Layer* layer = document.committed().layer(address.group, address.map, address.layer);
    if (layer == nullptr)
        return nullptr;
    std::erase_if(after, [layer](const auto& entry) { return layer->raster.tile(entry.first) == entry.second; });
    if (after.empty())
        return nullptr;
    std::ranges::sort(after, {}, [](const auto& entry) { return entry.first; });
    return std::make_unique<PaintCommand>(document, address, std::move(after), text);
}

} // namespace hairpaint::model
