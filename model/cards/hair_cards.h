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
    /// One at least. Each has half the triangles of the one before, and shows the same atlas.
    std::vector<CardLevel> levels;
    std::vector<AtlasPatch> patches; ///< Of the first level: a strip's each, then those of the caps that are there.
    CardImages images;
    std::optional<CardBones> bones{}; ///< Where they are wanted and there are strips.
    [[nodiscard]] const CardLevel& finest() const { return levels.front(); }
    /// Of the cap of a group that has one.
    [[nodiscard]] const AtlasPatch& capPatch(std::size_t group) const;
};

/// None where `progress` cancels. Any thread; runs on several. The same hair gives the same cards.
[[nodiscard]] std::optional<HairCards> makeCards(const CurveSet& set, const CardSettings& settings,
                                                 const Progress& progress);

} // namespace hairpaint::model
