// The ellipsoids that hair collides with: nape, three for cranium and face, neck, chest, shoulders.
//
// Printed by hairpaint_bust_generator --colliders, which fits them to the skin. Many overlap: only their union counts.
#include "bust_landmarks.h"

namespace hairpaint::heads {

namespace {

const std::array<EllipsoidSpec, 8> colliders = {{
    {{0.0000F, -0.0227F, -0.0275F}, {0.0504F, 0.1375F, 0.0488F}, {0.99966F, 0.02624F, 0.00000F, 0.00000F}},
    {{0.0000F, 0.0279F, -0.0091F}, {0.0787F, 0.0875F, 0.0892F}, {0.14551F, -0.98936F, 0.00000F, 0.00000F}},
    {{0.0000F, 0.0096F, 0.0095F}, {0.0774F, 0.1015F, 0.0813F}, {0.99498F, 0.10009F, 0.00000F, 0.00000F}},
    {{0.0000F, -0.0114F, 0.0038F}, {0.0694F, 0.1235F, 0.0785F}, {0.93487F, -0.35499F, 0.00000F, 0.00000F}},
    {{0.0000F, -0.1570F, -0.0411F}, {0.0680F, 0.0866F, 0.0595F}, {0.99998F, 0.00594F, 0.00000F, 0.00000F}},
    {{0.0000F, -0.2581F, -0.0349F}, {0.1284F, 0.1022F, 0.0769F}, {0.99679F, 0.08011F, 0.00000F, 0.00000F}},
    {{0.0925F, -0.2132F, -0.0471F}, {0.0753F, 0.0578F, 0.0510F}, {0.92934F, -0.14272F, -0.03792F, -0.33842F}},
    {{-0.0925F, -0.2132F, -0.0471F}, {0.0753F, 0.0578F, 0.0510F}, {0.92934F, -0.14272F, 0.03792F, 0.33842F}},
}};

} // namespace

std::span<const EllipsoidSpec> bustColliders()
{
    return colliders;
}

} // namespace hairpaint::heads
