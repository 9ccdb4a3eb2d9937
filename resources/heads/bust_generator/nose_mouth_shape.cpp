// Nose and mouth.
#include "bust_shape.h"
#include "sdf_primitives.h"

namespace hairpaint::heads {

float joinNose(float d, const MirroredPoint& p)
{
    if (p.plain.z < 0.040F || p.plain.y > 0.050F || p.plain.y < -0.090F)
        return d;
    // A narrow ridge over wide flanks that lie well behind it: the section is a rounded triangle, not a box.
    float nose = roundCone(p.plain, {0.0F, 0.0100F, 0.0815F}, {0.0F, -0.0330F, 0.1010F}, 0.0052F, 0.0062F);
    nose = smoothMin(
        nose, roundCone(p.soft, {0.0060F, 0.0040F, 0.0745F}, {0.0090F, -0.0370F, 0.0845F}, 0.0070F, 0.0090F), 0.018F);
    // Tip and wings, the bridge of skin between the nostrils.
    nose = smoothMin(nose, ellipsoid(p.plain, {0.0F, -0.0370F, 0.1004F}, {0.0090F, 0.0083F, 0.0092F}), 0.015F);
    nose = smoothMin(nose, ellipsoid(p.soft, {0.0113F, -0.0415F, 0.0900F}, {0.0060F, 0.0064F, 0.0092F}), 0.010F);
    nose = smoothMin(nose, roundCone(p.plain, {0.0F, -0.0430F, 0.1000F}, {0.0F, -0.0490F, 0.0910F}, 0.0038F, 0.0045F),
                     0.007F);
    d = smoothMin(d, nose, 0.015F);
    return smoothMax(d, -ellipsoid(p.soft, {0.0064F, -0.0488F, 0.0985F}, {0.0024F, 0.0027F, 0.0040F}), 0.006F);
}

float joinMouth(float d, const MirroredPoint& p)
{
    if (p.plain.z < 0.030F || p.plain.y > -0.030F || p.plain.y < -0.110F)
        return d;
    const glm::vec3& soft = p.soft;
    const float x = soft.x;
    const float xx = p.plain.x * p.plain.x;

    float upper = roundCone(soft, {0.0050F, -0.0648F, 0.0922F}, {0.0215F, -0.0702F, 0.0803F}, 0.0048F, 0.0026F);
    const glm::vec3 peak(0.0040F, -0.0656F, 0.0928F);
    upper = smoothMin(upper, roundCone(p.plain, {-peak.x, peak.y, peak.z}, peak, 0.0042F, 0.0042F), 0.004F);
    const float lower = roundCone(soft, {0.0045F, -0.0758F, 0.0900F}, {0.0205F, -0.0720F, 0.0798F}, 0.0069F, 0.0030F);
    d = smoothMin(d, upper, 0.0070F);
    d = smoothMin(d, lower, 0.0080F);

    // The seam: level, dipping a little in the middle. A rising end would smirk.
    const float seam = -0.0702F - 0.0009F * bell(p.plain.x, 0.0055F) - 1.0F * xx;
    d += 0.0022F * bell(p.plain.y - seam, 0.0019F) * (1.0F - smoothStep(0.0165F, 0.0245F, x));
    // The lips' borders: a fine ridge with a dip in the middle above, a shallow hollow below.
    const float border = -0.0606F - 0.0016F * bell(p.plain.x, 0.0034F) - 0.0090F * smoothStep(0.004F, 0.026F, x);
    d -= 0.0005F * bell(p.plain.y - border, 0.0019F) * (1.0F - smoothStep(0.012F, 0.024F, x));
    const float under = -0.0818F + 0.0085F * smoothStep(0.002F, 0.026F, x);
    d += 0.0010F * bell(p.plain.y - under, 0.0034F) * (1.0F - smoothStep(0.010F, 0.022F, x));
    // Corners and philtrum.
    d += 0.0013F * bell(p.folded, {0.0248F, -0.0707F, 0.0795F}, {0.0036F, 0.0038F, 0.0120F});
    return d + 0.0011F * bell(p.plain, {0.0F, -0.0562F, 0.0960F}, {0.0042F, 0.0070F, 0.0150F});
}

} // namespace hairpaint::heads
