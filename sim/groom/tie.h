// Where hair is gathered: a ring on the head through which the hair of a patch goes.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace hairpaint::sim {

/// What hair does behind the ring.
enum class TieForm : std::uint8_t
{
    Tail, ///< It falls.
    Bun   ///< It is wound into a closed coil about the ring's axis, which moves with the head.
};

/// Hair whose root reads `number` in the map of gathered hair lies taut from there to the ring. Hd, m.
struct Tie
{
    std::uint16_t number = 1;                ///< 1..65535
    glm::vec3 pointHd{0.0F};                 ///< Centre of the ring.
    glm::vec3 directionHd{0.0F, 0.0F, 1.0F}; ///< Unit: where hair leaves through the ring.
    float radiusM = 0.01F;                   ///< Inner radius of the ring.
    float tightness = 1.0F;                  ///< 1: taut on the skin; 0: with the coat's height.
    TieForm form = TieForm::Tail;
    float bunRadiusM = 0.03F; ///< Outer radius of the bun's coil; used with Bun alone.
    friend bool operator==(const Tie&, const Tie&) = default;
};

} // namespace hairpaint::sim
