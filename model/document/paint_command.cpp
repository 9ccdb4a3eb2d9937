// Undo of painting: only the touched tiles are kept.
#include "model/document/paint_command.h"

#include "model/document/edit_command.h"
#include "model/document/undo_budget.h"
#include "model/project/content_budget.h"

#include <algorithm>

namespace hairpaint::model {

namespace {

class PaintCommand : public QUndoCommand, public TileHolder
{
public:
    PaintCommand(Document& document, std::vector<LayerEdit> layers, const QString& text)
        : QUndoCommand(text), m_document(document), m_layers(std::move(layers))
    {}
    void redo() override { swapTiles(); }
    void undo() override { swapTiles(); }
    [[nodiscard]] std::size_t keptBytes() const override
    {
        std::size_t bytes = 0;
        for (const LayerEdit& layer : m_layers)
            for (const auto& [index, tile] : layer.after)
                bytes += bytesOf(tile);
        return bytes;
    }
    void release() override { m_layers = {}; }

private:
    void swapTiles()
    {
        for (LayerEdit& edit : m_layers) {
            Change change{.aspect = Change::Aspect::Texels,
                          .group = edit.address.group,
                          .map = edit.address.map,
                          .layer = edit.address.layer};
            for (const auto& [index, tile] : edit.after)
                change.tiles.push_back(index);
            m_document.apply(change, [&edit](Project& project) {
                Layer* layer = project.layer(edit.address.group, edit.address.map, edit.address.layer);
                if (layer == nullptr)
                    return;
                for (auto& [index, tile] : edit.after) {
                    sim::RasterTilePtr other = layer->raster.tile(index);
                    layer->raster.setTile(index, std::move(tile));
                    tile = std::move(other);
                }
            });
        }
    }

    Document& m_document;
    std::vector<LayerEdit> m_layers; ///< What the next swap puts in.
};

/// Whether the content may take these tiles in.
bool fits(Document& document, const std::vector<LayerEdit>& layers)
{
    if (!paintingMayExceed(document.committed().groups))
        return true;
    Project after = document.committed();
    layIn(after, layers);
    return document.mayBecome(after);
}

} // namespace

void layIn(Project& project, const std::vector<LayerEdit>& layers)
{
    for (const LayerEdit& edit : layers)
        if (Layer* layer = project.layer(edit.address.group, edit.address.map, edit.address.layer))
            for (const auto& [index, tile] : edit.after)
                layer->raster.setTile(index, tile);
}

CommandPtr paintCommand(Document& document, std::vector<LayerEdit> layers, const QString& text)
{
    document.endEdit();
    const bool paintsPatches =
        std::ranges::any_of(layers, [](const LayerEdit& edit) { return edit.address.map == MapKind::Accessory; });
    if (!paintsPatches)
        return plainPaintCommand(document, std::move(layers), text);
    Project after = document.committed();
    layIn(after, layers);
    return withPatches(document, plainPaintCommand(document, std::move(layers), text), std::move(after), text);
}

CommandPtr plainPaintCommand(Document& document, std::vector<LayerEdit> layers, const QString& text)
{
    document.endEdit();
    for (LayerEdit& edit : layers) {
        const LayerAddress& at = edit.address;
        const Layer* layer = document.committed().layer(at.group, at.map, at.layer);
        std::erase_if(edit.after, [layer](const auto& entry) {
            return layer == nullptr || layer->raster.tile(entry.first) == entry.second;
        });
        std::ranges::sort(edit.after, {}, [](const auto& entry) { return entry.first; });
    }
    std::erase_if(layers, [](const LayerEdit& edit) { return edit.after.empty(); });
    if (layers.empty() || !fits(document, layers))
        return nullptr;
    return std::make_unique<PaintCommand>(document, std::move(layers), text);
}

CommandPtr paintCommand(Document& document, const LayerAddress& address, LayerTiles after, const QString& text)
{
    return paintCommand(document, {{.address = address, .after = std::move(after)}}, text);
}

} // namespace hairpaint::model
