// The ellipsoids that hair collides with.
#include "bust_landmarks.h"

namespace hairpaint::heads {

namespace {

constexpr float quarter = 0.0F;

// Provisional: by eye, not fitted.
const std::array<EllipsoidSpec, 6> colliders = {
    {{{0.0F, 0.0290F, -0.0180F}, {0.0760F, 0.0830F, 0.0780F}, {1.0F, quarter, 0.0F, 0.0F}},
     {{0.0F, 0.0300F, 0.0210F}, {0.0650F, 0.0750F, 0.0710F}, {1.0F, 0.0F, 0.0F, 0.0F}},
     {{0.0F, -0.0400F, 0.0350F}, {0.0580F, 0.0720F, 0.0560F}, {1.0F, 0.0F, 0.0F, 0.0F}},
     {{0.0F, -0.1200F, -0.0350F}, {0.0500F, 0.1000F, 0.0490F}, {1.0F, 0.0F, 0.0F, 0.0F}},
     {{0.0F, -0.2500F, -0.0400F}, {0.1250F, 0.0850F, 0.0850F}, {1.0F, 0.0F, 0.0F, 0.0F}},
     {{0.0F, -0.2250F, -0.0450F}, {0.1580F, 0.0480F, 0.0480F}, {1.0F, 0.0F, 0.0F, 0.0F}}}};

} // namespace

std::span<const EllipsoidSpec> bustColliders()
{
    return colliders;
}

} // namespace hairpaint::heads
