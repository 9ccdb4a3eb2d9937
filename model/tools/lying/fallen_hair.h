// How hair lies where a direction map only tells how it grows.
#pragma once

#include "model/tools/strokes/skin_frames.h"
#include "model/tools/strokes/stroke_buffer.h"
#include "model/tools/tool.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

/// Long hair that nobody has combed falls to its side, whatever the natural stream under it. A comb's soft edge must
/// lead from that direction to the combed one, or hair at the edge would lie as it grows: over the face. Uses the maps
/// as they were when this was made. One thread, but for under().
class FallenHair
{
public:
    /// Takes the target's group. `size`: texels a side of the direction map. `frames` must outlive it.
    FallenHair(const ToolContext& context, SkinFrames& frames, int size);
    /// Takes a group's settings and resolved maps; nothing falls where one of the maps is null.
    FallenHair(const sim::GroupSettings& settings, sim::MapRaster natural, sim::MapRaster direction,
               sim::MapRaster length, SkinFrames& frames, int size);

    /// The direction in which hair lies there, in the frame of that point of the skin.
    [[nodiscard]] glm::vec2 at(glm::vec2 uv);
    /// Makes a tile ready for under().
    void look(int tileIndex);
    /// A direction layer's tile in which texels hold how hair lies, where the mask is above 0 and that differs from the
    /// map.
    [[nodiscard]] sim::RasterTilePtr under(int tileIndex, const sim::RasterTilePtr& before,
                                           const StrokeBuffer::MaskTile& mask) const;

private:
    using Texels = std::vector<std::optional<sim::Texel>>; ///< [64][64]; none where hair lies as the map tells.

    /// The direction in which hair lies; none where it lies as the map tells.
    [[nodiscard]] std::optional<glm::vec2> fallenAt(glm::vec2 uv);
    [[nodiscard]] glm::vec2 toldAt(glm::vec2 uv) const;

    SkinFrames* m_frames;
    int m_size;
    int m_tilesAcross;
    sim::GroupSettings m_settings;
    sim::MapRaster m_natural; ///< Null where the head has none.
    sim::MapRaster m_direction;
    sim::MapRaster m_length;
    std::vector<std::optional<Texels>> m_tiles; ///< By tile; none until look() has been called for it.
};

} // namespace hairpaint::model
