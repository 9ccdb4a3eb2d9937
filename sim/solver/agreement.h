// How much hairs that lie or hang differently have in common.
#pragma once

namespace hairpaint::sim {

/// 1 where two tips, [3] each, from the root and by the hair's length, coincide; 0 from where they belong to
/// different sides of a parting.
inline float agreementOfTips(const float* a, const float* b)
{
    constexpr float kApart2 = 0.45F; // This fraction of the length, squared.
    const float x = b[0] - a[0];
    const float y = b[1] - a[1];
    const float z = b[2] - a[2];
    const float left = 1.0F - (x * x + y * y + z * z) * (1.0F / kApart2);
    return left > 0.0F ? left * left : 0.0F;
}

} // namespace hairpaint::sim
