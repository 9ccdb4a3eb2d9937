// Neck, shoulders and a chest that tapers into a round foot, as a shop-window bust stands on its stand.
#include "bust_shape.h"
#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

// Collar bones and the notch between them.
float collarRelief(const MirroredPoint& p)
{
    const float x = p.folded.x;
    const float t = std::clamp((x - 0.016F) / 0.110F, 0.0F, 1.0F);
    const float bone = -0.207F + 0.010F * t + 0.004F * std::sin(glm::radians(360.0F) * t);
    const float front = smoothStep(-0.060F, -0.005F, p.plain.z);
    const float boneSpan = smoothStep(0.008F, 0.024F, x) * (1.0F - smoothStep(0.085F, 0.125F, x));
    const float hollowSpan = smoothStep(0.028F, 0.050F, x) * (1.0F - smoothStep(0.085F, 0.120F, x));
    float relief = 0.0030F * bell(p.plain.y - bone, 0.0085F) * boneSpan * front;
    relief -= 0.0022F * bell(p.plain.y - bone - 0.019F, 0.0115F) * hollowSpan * front;
    return relief - 0.0035F * bell(p.plain, {0.0F, -0.204F, 0.016F}, {0.0115F, 0.0115F, 0.0300F});
}

} // namespace

float joinNeck(float d, const MirroredPoint& p)
{
    // Column, the two muscles from behind the ears to the collar bones, throat.
    float neck = roundCone(p.plain, {0.0F, -0.0450F, -0.0280F}, {0.0F, -0.2000F, -0.0430F}, 0.0470F, 0.0475F);
    neck = smoothMin(
        neck, roundCone(p.soft, {0.0470F, -0.0300F, -0.0210F}, {0.0130F, -0.2060F, 0.0040F}, 0.0100F, 0.0085F), 0.028F);
    neck = smoothMin(neck, roundCone(p.plain, {0.0F, -0.0950F, 0.0140F}, {0.0F, -0.1950F, -0.0040F}, 0.0180F, 0.0180F),
                     0.035F);
    return smoothMin(d, neck, 0.028F);
}

float joinTrunk(float d, const MirroredPoint& p)
{
    if (p.plain.y > -0.060F)
        return d;
    float trunk = ellipsoid(p.plain, {0.0F, -0.2680F, -0.0340F}, {0.1200F, 0.0920F, 0.0800F});
    trunk = smoothMin(trunk,
                      roundCone(p.soft, {0.0260F, -0.1380F, -0.0620F}, {0.1140F, -0.2170F, -0.0500F}, 0.0260F, 0.0350F),
                      0.060F);
    trunk = smoothMin(trunk,
                      roundCone(p.soft, {0.0300F, -0.2240F, -0.0120F}, {0.1140F, -0.2220F, -0.0400F}, 0.0300F, 0.0350F),
                      0.050F);
    trunk = smoothMin(trunk,
                      roundCone(p.soft, {0.1200F, -0.2260F, -0.0460F}, {0.0620F, -0.3050F, -0.0400F}, 0.0380F, 0.0340F),
                      0.050F);
    // The taper: everything below the shoulders stays inside a bowl, which stands on a flared foot.
    const float bowl = ellipsoid(p.plain, {0.0F, -0.1900F, -0.0400F}, {0.1700F, 0.1500F, 0.1120F});
    trunk = smoothMax(trunk, bowl, 0.040F);
    d = smoothMin(d, trunk, 0.050F);
    const float foot = roundCone(p.plain, {0.0F, -0.3100F, -0.0380F}, {0.0F, -0.3500F, -0.0380F}, 0.0370F, 0.0520F);
    d = smoothMin(d, foot, 0.040F);
    return d - collarRelief(p);
}

} // namespace hairpaint::heads
