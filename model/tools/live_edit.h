// A tool's running edit of one layer, or of several: shown as a preview, ended as one command or without a trace.
#pragma once

#include "model/maps/tile_paint.h"
#include "model/tools/strokes/stroke_buffer.h"
#include "model/tools/tool.h"

#include <functional>
#include <map>

namespace hairpaint::model {

/// Begins if the layer exists, is visible and unlocked; else it stays inactive, and the other functions do nothing.
/// Another edit of the document commits it; undo drops it, or takes back its last part where `stepBack` can.
class LiveEdit
{
public:
    /// The step will be called "TITLE on MAP".
    [[nodiscard]] bool begin(const ToolContext& context, const QString& title, std::function<bool()> stepBack = {});
    /// Takes another layer into the running edit and returns its number; none where it is missing, hidden or locked.
    /// The target's number is 0.
    [[nodiscard]] std::optional<std::size_t> also(const ToolContext& context, const LayerAddress& address);
    /// Replaces the step's text; empty: keeps it.
    void setText(const QString& text)
    {
        if (!text.isEmpty())
            m_session.setText(text);
    }
    [[nodiscard]] bool active() const { return m_session.active(); }
    [[nodiscard]] const MapSpec& spec(std::size_t layer = 0) const { return mapSpec(m_layers[layer].address.map); }
    [[nodiscard]] int size(std::size_t layer = 0) const { return before(layer).size(); }
    [[nodiscard]] const sim::TiledRaster& before(std::size_t layer = 0) const { return m_layers[layer].before; }
    [[nodiscard]] BlendMode blend(std::size_t layer = 0) const { return m_layers[layer].blend; }
    /// Rectangles of the texels that may change, those in the selection. They do not overlap.
    [[nodiscard]] const std::vector<sim::TexelRect>& clips(std::size_t layer = 0) const
    {
        return m_layers[layer].clips;
    }

    /// Shows these tiles as `make` gives them, from those before the edit; other tiles stay as last shown.
    using MakeTile = std::function<sim::RasterTilePtr(int tileIndex, const sim::RasterTilePtr& before)>;
    void update(const std::vector<int>& tiles, const MakeTile& make, std::size_t layer = 0);
    /// The same, where all tiles not named (they are in ascending order) go back to what they were before the edit.
    void replace(const std::vector<int>& tiles, const MakeTile& make, std::size_t layer = 0);

    /// Pushes one step with the tiles as last shown; no step where no tile differs.
    void commit() { m_session.commit(); }
    void cancel() { m_session.drop(); }

private:
    struct Edited
    {
        LayerAddress address;
        BlendMode blend = BlendMode::Normal;
        sim::TiledRaster before;
        std::vector<sim::TexelRect> clips;
        std::map<int, sim::RasterTilePtr> shown = {};
    };

    EditSession m_session;
    std::vector<Edited> m_layers; ///< The layers of the edit; the target's is the first.
};

/// The texels whose centres lie in the selection; all of them where nothing is selected. None overlaps another.
[[nodiscard]] std::vector<sim::TexelRect> selectedTexels(const Selection& selection, int size);
[[nodiscard]] bool contains(const std::vector<sim::TexelRect>& rects, int x, int y);
/// Takes away what a tile's mask has outside the rectangles; `tile`: the texels that it covers.
void keepInside(const std::vector<sim::TexelRect>& rects, const sim::TexelRect& tile, StrokeBuffer::MaskTile& mask);
/// The part that two rectangles share; empty where they share none.
[[nodiscard]] sim::TexelRect shared(const sim::TexelRect& a, const sim::TexelRect& b);
/// The tiles that meet any of the rectangles, in ascending order.
[[nodiscard]] std::vector<int> tilesIn(const sim::TiledRaster& raster, const std::vector<sim::TexelRect>& rects);
/// "Brush on Length".
[[nodiscard]] QString actionText(const QString& title, MapKind map);

} // namespace hairpaint::model
