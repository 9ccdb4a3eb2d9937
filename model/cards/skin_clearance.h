// Strips kept above the skin.
#pragma once

#include "model/cards/card_strip.h"

namespace hairpaint::model {

/// Moves nodes outward where the strip, straight between them and flat across, would cut through a head that its hairs
/// lie upon. Any thread.
void keepAboveSkin(const CurveSet& set, CardStrip& strip);

} // namespace hairpaint::model
