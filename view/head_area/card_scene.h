// Hair cards for the renderer.
#pragma once

#include "model/cards/hair_cards.h"
#include "sim/groom/group_settings.h"
#include "sim/motion/head_motion.h"
#include "view/rendering/card_set.h"

#include <memory>
#include <span>

namespace hairpaint::view {

/// The finest level of all groups. `pose`: how the head was held when they were made; `materials`: of their hair, a
/// group each. Any thread.
[[nodiscard]] std::shared_ptr<const rendering::CardSet> cardSet(model::HairCards& cards, const sim::HeadPose& pose,
                                                                std::span<const sim::StrandMaterial> materials);

} // namespace hairpaint::view
