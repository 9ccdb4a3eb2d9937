// A tool's running edit of a layer, or of several: shown as a preview, ended as one command or without a trace.
#pragma once

#include "model/tools/stroke_buffer.h"
#include "model/tools/tile_paint.h"
#include "model/tools/tool.h"

#include <functional>
#include <map>

namespace hairpaint::model {

/// A layer in it. `before`, `clips` and `spec` stay as they were when the edit began.
class LiveLayer
{
public:
    /// None where the layer is not there, hidden or locked.
    [[nodiscard]] static std::optional<LiveLayer> of(const ToolContext& context, const LayerAddress& address);

    [[nodiscard]] const MapSpec& spec() const { return mapSpec(m_address.map); }
    [[nodiscard]] int size() const { return m_before.size(); }
    [[nodiscard]] const sim::TiledRaster& before() const { return m_before; }
    /// The texels that may change: those in the selection. None overlaps another.
    [[nodiscard]] const std::vector<sim::TexelRect>& clips() const { return m_clips; }

    /// Shows these tiles as `make` gives them, from those before the edit; other tiles stay as last shown.
    using MakeTile = std::function<sim::RasterTilePtr(int tileIndex, const sim::RasterTilePtr& before)>;
    void update(EditSession& session, const std::vector<int>& tiles, const MakeTile& make);
    /// The same, where all tiles not named go back to what they were before the edit.
    void replace(EditSession& session, const std::vector<int>& tiles, const MakeTile& make);

private:
    LiveLayer(const LayerAddress& address, const sim::TiledRaster& before, std::vector<sim::TexelRect> clips)
        : m_address(address), m_before(before), m_clips(std::move(clips))
    {}

    LayerAddress m_address;
    sim::TiledRaster m_before;
    std::vector<sim::TexelRect> m_clips;
    std::map<int, sim::RasterTilePtr> m_shown;
};

/// Begins where the target is there, visible and unlocked; elsewhere it stays inactive and everything else does
/// nothing. Somebody else's edit commits it, undo drops it (or takes back its last part, where `stepBack` can).
class LiveEdit
{
public:
    using MakeTile = LiveLayer::MakeTile;

    /// The step will be called "TITLE on MAP".
    [[nodiscard]] bool begin(const ToolContext& context, const QString& title, std::function<bool()> stepBack = {});
    [[nodiscard]] bool active() const { return m_session.active(); }
    [[nodiscard]] const MapSpec& spec() const { return m_layer->spec(); }
    [[nodiscard]] int size() const { return m_layer->size(); }
    [[nodiscard]] const sim::TiledRaster& before() const { return m_layer->before(); }
    [[nodiscard]] const std::vector<sim::TexelRect>& clips() const { return m_layer->clips(); }

    void update(const std::vector<int>& tiles, const MakeTile& make);
    void replace(const std::vector<int>& tiles, const MakeTile& make);
    [[nodiscard]] const LiveLayer& layer() const { return *m_layer; }
    /// For other layers that the same step edits.
    [[nodiscard]] EditSession& session() { return m_session; }

    /// One step with the tiles as last shown; none where none differs.
    void commit() { m_session.commit(); }
    void cancel() { m_session.drop(); }

private:
    EditSession m_session;
    std::optional<LiveLayer> m_layer;
};

/// The texels whose centres lie in the selection; all of them where nothing is selected. None overlaps another.
[[nodiscard]] std::vector<sim::TexelRect> selectedTexels(const Selection& selection, int size);
[[nodiscard]] bool contains(const std::vector<sim::TexelRect>& rects, int x, int y);
/// The part that two rectangles share; empty where they share none.
[[nodiscard]] sim::TexelRect shared(const sim::TexelRect& a, const sim::TexelRect& b);
/// The tiles that meet any of the rectangles, in ascending order.
[[nodiscard]] std::vector<int> tilesIn(const sim::TiledRaster& raster, const std::vector<sim::TexelRect>& rects);
/// "Brush on Length".
[[nodiscard]] QString actionText(const QString& title, MapKind map);

} // namespace hairpaint::model
