// Hair drawn onto its card.
#pragma once

#include "model/cards/atlas_layout.h"
#include "model/cards/card_images.h"
#include "model/cards/card_strip.h"
#include "model/cards/scalp_cap.h"

namespace hairpaint::model {

/// Draws the hairs of a strip into its patch, the outermost in front: as many as cover as much of the card as they do
/// in truth, each at least wide enough to be seen. Several threads may bake into patches of one atlas.
void bakeCard(const CurveSet& set, const SampledHair& hair, const HairField& field, const CardStrip& strip,
              const AtlasPatch& patch, CardImages& images);
/// The same of the hairs of a cap.
void bakeCap(const CurveSet& set, const SampledHair& hair, const HairField& field, const ScalpCap& cap,
             const AtlasPatch& patch, CardImages& images);

} // namespace hairpaint::model
