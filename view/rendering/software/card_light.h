// The light on the hair that cards show.
#pragma once

#include "view/rendering/card_set.h"
#include "view/rendering/frame_constants.h"
#include "view/rendering/light/hair_light.h"

namespace hairpaint::rendering {

/// The light of one frame, computed as in cards.vert. `constants` must outlive it. Any thread.
class CardLight
{
public:
    explicit CardLight(const FrameConstants& constants);
    /// What a hair along the card throws back there, over its colour: texels differ from their neighbours.
    [[nodiscard]] glm::vec3 on(const CardCorner& corner) const;

private:
    const FrameConstants& m_constants;
    HairLighting m_lighting; ///< Its shine and shape are replaced by the corner's.
};

} // namespace hairpaint::rendering
