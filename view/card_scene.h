// Hair cards for the renderer.
#pragma once

#include "model/exporting/cards/hair_cards.h"
#include "sim/motion/head_motion.h"
#include "view/rendering/card_set.h"

#include <memory>

namespace hairpaint::view {

/// The finest level of all groups. `pose`: how the head was held when they were made. Any thread.
[[nodiscard]] std::shared_ptr<const rendering::CardSet> cardSet(model::HairCards& cards, const sim::HeadPose& pose);

} // namespace hairpaint::view
