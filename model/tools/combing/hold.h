// Hair held as it lies: what that makes of the direction map and the gel map.
#pragma once

#include "model/document/paint_command.h"
#include "model/tools/lying/lying_hair.h"
#include "model/tools/strokes/stroke_buffer.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

/// A layer that holds, and what is laid on it.
struct HoldPaint
{
    const StrokeBuffer::MaskTile* mask = nullptr; ///< Null: the whole tile.
    std::uint16_t opacity = 65535;
};

/// A direction layer's tile as hair lies now; where none is near, as it was.
[[nodiscard]] sim::RasterTilePtr heldDirection(const LyingField& field, int mapSize, int tileIndex,
                                               const sim::RasterTilePtr& before, const HoldPaint& paint);
/// A gel layer's tile so that hair has at least that gel, 0..1. `shown`: the resolved map before.
[[nodiscard]] sim::RasterTilePtr heldGel(const LyingField& field, const sim::TiledRaster& shown, float least,
                                         int tileIndex, const sim::RasterTilePtr& before, const HoldPaint& paint);

/// Copies of what a group's hair is held with, so that it may be done on any thread.
struct HoldRequest
{
    struct Target
    {
        LayerAddress address;
        sim::TiledRaster layer;
        std::vector<sim::TexelRect> clips; ///< Texels that may change.
    };
    Target direction, gel;
    std::shared_ptr<const sim::TiledRaster> shownGel; ///< The resolved map.
    float leastGel = 0.5F;                            ///< 0..1
};

/// The gel layer's tiles, then the direction layer's; none where progress stops it. About 50 ms for maps of 2048
/// texels a side.
[[nodiscard]] std::optional<std::vector<LayerEdit>> holdHair(const LyingField& field, const HoldRequest& request,
                                                             const Progress& progress = {});
/// Text of the undo step; to be translated in context "Tool".
inline constexpr const char* kHoldStep = QT_TRANSLATE_NOOP("Tool", "Hold as it lies");
[[nodiscard]] QString holdStepText();

} // namespace hairpaint::model
