// Hair as cards: strips along locks of hair, and the textures that are drawn on them.
#pragma once

#include "model/exporting/cards/atlas_layout.h"
#include "model/exporting/cards/card_bones.h"
#include "model/exporting/cards/card_images.h"
#include "model/exporting/cards/card_settings.h"
#include "model/exporting/cards/card_strip.h"
#include "model/exporting/cards/scalp_cap.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

struct HairCards
{
    std::vector<CardStrip>
        strips; ///< Those of a group together; in a group from the skin to the surface, flyaways last.
    std::vector<std::size_t> groups;           ///< By strip: index into CurveSet::groups().
    std::vector<std::optional<ScalpCap>> caps; ///< By group.
    std::vector<AtlasPatch> patches;           ///< A strip's each, then those of the caps that are there.
    CardImages images;
    std::optional<CardBones> bones{}; ///< Where they are wanted and there are strips.
    [[nodiscard]] int triangles() const;
};

/// None where `progress` cancels. Any thread; runs on several. The same hair gives the same cards.
[[nodiscard]] std::optional<HairCards> makeCards(const CurveSet& set, const CardSettings& settings,
                                                 const Progress& progress);

} // namespace hairpaint::model
