// What a parting paints: hair laid to both sides of a curve, and a gap along it.
#pragma once

#include "model/tools/live_edit.h"
#include "model/tools/lying/fallen_hair.h"
#include "model/tools/parting/part_field.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace hairpaint::model {

/// A running edit of the direction map and, where the part has a gap, of the density map. GUI thread; several threads
/// make its tiles.
class PartEdit
{
public:
    /// False where the target is no direction map, the project has no head, or its layer can't be painted. Undo calls
    /// `stepBack`, as in LiveEdit.
    [[nodiscard]] bool begin(const ToolContext& context, const QString& title, std::function<bool()> stepBack);
    /// Shows the part along `curve`, through `points`, with the context's settings, replacing what was last shown.
    void show(const PartCurve& curve, const std::vector<sim::SurfacePoint>& points, const ToolContext& context);
    void commit() { m_edit.commit(); }
    void cancel() { m_edit.cancel(); }
    [[nodiscard]] bool active() const { return m_edit.active(); }
    /// Once it has begun.
    [[nodiscard]] const sim::Skin& skin() const { return m_frames->skin(); }

private:
    void showTiles(const std::vector<int>& tiles, const LiveEdit::MakeTile& make, std::size_t layer);
    void showLaid(const PartField& field);
    void showGap(const PartField& field, const ToolContext& context);

    LiveEdit m_edit;
    std::optional<std::size_t> m_density; ///< Its layer's number in the edit, once there is one.
    std::unique_ptr<SkinFrames> m_frames; ///< Kept from parting to parting.
    std::optional<FallenHair> m_before;   ///< How hair lay before this parting.
    sim::MapRaster m_hair;                ///< The density map before this parting.
};

} // namespace hairpaint::model
