// Where tip colours begin on hair that is cut: where they began before, as far as the hair still goes there.
#pragma once

#include "model/tools/cut_lengths.h"
#include "model/tools/live_edit.h"

#include <optional>

namespace hairpaint::model {

/// The tip start map's part of a cut: it tells fractions of a hair's length, which becomes less. Past its start a tip
/// colour still becomes whole over the same fraction of what is left, which is shorter. One thread.
class CutTips
{
public:
    /// Takes the map's layer into the edit. None where tips have the roots' colours, or where the layer is missing,
    /// hidden or locked.
    [[nodiscard]] static std::optional<CutTips> in(LiveEdit& edit, const ToolContext& context);

    /// Instead of the cut before.
    void show(LiveEdit& edit, const CutLengths& lengths);

private:
    CutTips() = default;

    std::size_t m_layer = 0; ///< Its number in the edit.
    sim::StrandMaterial m_material;
    sim::MapRaster m_start; ///< As it was.
    std::vector<std::uint16_t> m_values;
};

} // namespace hairpaint::model
