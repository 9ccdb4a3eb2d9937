// Where tip colours begin that a stroke lays on hair: a strand has its tip colour from where the brush touches it.
#pragma once

#include "model/tools/live_edit.h"
#include "model/tools/root_dabs.h"

#include <memory>
#include <optional>

namespace hairpaint::model {

/// The tip start map's part of a stroke of a brush, or of an eraser, on the tip colour map. Where a strand has a tip
/// colour already it never begins further from the root than before.
class TipStarts
{
public:
    /// Takes the map's layer into the edit. None where the edit is of another map than the tip colour's, or where the
    /// layer is missing, hidden or locked.
    [[nodiscard]] static std::optional<TipStarts> in(LiveEdit& edit, const ToolContext& context);

    /// `dab` as it covers texels of the tip colour map.
    void add(const LiveEdit& edit, const RootDab& dab);
    void show(LiveEdit& edit, bool erases);

private:
    TipStarts() = default;

    std::size_t m_layer = 0; ///< Index of the tip start layer in the edit.
    sim::StrandMaterial m_material;
    std::optional<StrokeBuffer> m_masks;
    std::shared_ptr<const sim::TiledRaster> m_start, m_tip, m_colour; ///< The resolved maps before the stroke.
};

} // namespace hairpaint::model
