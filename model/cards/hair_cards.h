// Hair as cards: strips along locks of hair, and the textures that are drawn on them.
#pragma once

#include "model/cards/atlas_layout.h"
#include "model/cards/card_bones.h"
#include "model/cards/card_images.h"
#include "model/cards/card_level.h"
#include "model/exporting/card_settings.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

struct HairCards
{
    /// Levels of detail, finest first, one at least. Each has half the triangles of the one before, on the same atlas.
    std::vector<CardLevel> levels;
    std::vector<AtlasPatch> patches; ///< Patches of the finest level: one for each strip, then one for each cap.
    CardImages images;
    std::optional<CardBones> bones{}; ///< None where they are not wanted or there are no strips.
    [[nodiscard]] const CardLevel& finest() const { return levels.front(); }
    /// The patch of a group's cap; the group must have one.
    [[nodiscard]] const AtlasPatch& capPatch(std::size_t group) const;
};

/// None where `progress` cancels. Any thread; runs on several. The same hair gives the same cards.
[[nodiscard]] std::optional<HairCards> makeCards(const CurveSet& set, const CardSettings& settings,
                                                 const Progress& progress);

} // namespace hairpaint::model
