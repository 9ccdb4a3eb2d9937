// Tip colours of hair that is cut: what is left of it looks as before, and what was dyed and cut off is gone.
#pragma once

#include "model/tools/cutting/cut_lengths.h"
#include "model/tools/live_edit.h"

#include <functional>
#include <optional>

namespace hairpaint::model {

/// The part of a cut that the tip start map and the tip colour map have. Both tell of fractions of a hair's length,
/// which becomes less: the tip colour begins where it began before, and is what the hair had where it is cut. Past its
/// start it still becomes whole over the same fraction of what is left, which is shorter. One thread.
class CutTips
{
public:
    /// Takes the maps' layers into the edit. None where tips have the roots' colours, or where the layer of where they
    /// begin is missing, hidden or locked.
    [[nodiscard]] static std::optional<CutTips> in(LiveEdit& edit, const ToolContext& context);

    /// Replaces the former cut.
    void show(LiveEdit& edit, const CutLengths& lengths);

private:
    CutTips() = default;
    /// A texel of a map, and what the cut leaves of the hair there, below 1; tells whether it changes.
    using CutTexel = std::function<bool(int x, int y, float kept, std::uint16_t* value)>;
    void show(LiveEdit& edit, std::size_t layer, const CutLengths& lengths, const CutTexel& cut);

    std::size_t m_startLayer = 0; ///< Index of the tip start layer in the edit.
    std::optional<std::size_t> m_colourLayer;
    sim::StrandMaterial m_material;
    sim::MapRaster m_start, m_tip, m_colour; ///< The resolved maps before the cut.
    std::vector<std::uint16_t> m_values;
};

} // namespace hairpaint::model
