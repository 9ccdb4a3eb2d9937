// The ellipsoids that hair collides with: neck and nape, three for cranium and face, upper back, chest, shoulders.
//
// Printed by hairpaint_bust_generator --colliders, which fits them to the skin. Many overlap: only their union counts.
#include "model/heads/bust_landmarks.h"

namespace hairpaint::heads {

namespace {

const std::array<EllipsoidSpec, 8> colliders = {{
    {{0.00000F, -0.05539F, -0.02580F}, {0.05054F, 0.16534F, 0.05051F}, {0.99878F, -0.04944F, 0.00000F, 0.00000F}},
    {{0.00000F, 0.02648F, -0.00653F}, {0.07877F, 0.08933F, 0.09215F}, {0.14584F, -0.98931F, 0.00000F, 0.00000F}},
    {{0.00000F, 0.00276F, 0.01176F}, {0.07663F, 0.10586F, 0.07596F}, {0.98874F, 0.14964F, 0.00000F, 0.00000F}},
    {{0.00000F, -0.00237F, 0.01396F}, {0.07359F, 0.12621F, 0.06829F}, {0.95812F, -0.28636F, 0.00000F, 0.00000F}},
    {{0.00000F, -0.18646F, -0.04885F}, {0.08421F, 0.10051F, 0.04598F}, {0.99769F, -0.06791F, 0.00000F, 0.00000F}},
    {{0.00000F, -0.25718F, -0.03504F}, {0.12888F, 0.09846F, 0.07704F}, {0.99765F, 0.06859F, 0.00000F, 0.00000F}},
    {{0.09392F, -0.21708F, -0.04535F}, {0.06859F, 0.05267F, 0.06070F}, {0.78422F, 0.55136F, -0.22813F, -0.17020F}},
    {{-0.09392F, -0.21708F, -0.04535F}, {0.06859F, 0.05267F, 0.06070F}, {0.78422F, 0.55136F, 0.22813F, 0.17020F}},
}};

} // namespace

std::span<const EllipsoidSpec> bustColliders()
{
    return colliders;
}

} // namespace hairpaint::heads
