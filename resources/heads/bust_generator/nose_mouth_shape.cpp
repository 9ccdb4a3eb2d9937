// Nose and mouth.
#include "bust_shape.h"
#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

constexpr float kMouthHalf = 0.0262F; // From the middle to a corner.

// Heights, as functions of the distance from the middle plane: plain.x for what is sharp there, soft.x elsewhere.

// They touch along a seam that dips in the middle and falls a little to the corners. Rising ends would smirk.
float seam(const MirroredPoint& p)
{
    const float x = p.soft.x;
    return -0.0680F - 0.0012F * bell(p.plain.x, 0.0060F) + 0.0008F * bell(x - 0.0095F, 0.0060F) - 0.6F * x * x;
}

// The upper lip's border, with a dip in the middle.
float upperBorder(const MirroredPoint& p)
{
    return -0.0582F - 0.0016F * bell(p.plain.x, 0.0034F) - 0.0088F * smoothStep(0.004F, 0.027F, p.soft.x);
}

// The hollow under the lower lip.
float hollowBelow(const MirroredPoint& p)
{
    return -0.0845F + 0.0110F * smoothStep(0.002F, 0.027F, p.soft.x);
}

} // namespace

float joinNose(float d, const MirroredPoint& p)
{
    if (p.plain.z < 0.040F || p.plain.y > 0.060F || p.plain.y < -0.090F)
        return d;
    // A narrow ridge from between the brows to the tip, over flanks that lie well behind it: a rounded triangle.
    float nose = roundCone(p.plain, {0.0F, 0.0140F, 0.0795F}, {0.0F, -0.0337F, 0.0974F}, 0.0060F, 0.0062F);
    nose = smoothMin(
        nose, roundCone(p.soft, {0.0062F, 0.0040F, 0.0720F}, {0.0080F, -0.0340F, 0.0830F}, 0.0070F, 0.0080F), 0.020F);
    // The tip's two cartilages nearly meet; the wings; the column between the nostrils.
    nose = smoothMin(nose, ellipsoid(p.soft, {0.0026F, -0.0386F, 0.0962F}, {0.0070F, 0.0072F, 0.0090F}), 0.017F);
    nose = smoothMin(nose, ellipsoid(p.soft, {0.0104F, -0.0405F, 0.0888F}, {0.0052F, 0.0064F, 0.0094F}), 0.009F);
    nose = smoothMin(nose, roundCone(p.plain, {0.0F, -0.0440F, 0.0964F}, {0.0F, -0.0474F, 0.0895F}, 0.0034F, 0.0038F),
                     0.007F);
    d = smoothMin(d, nose, 0.014F);
    // The groove round the wing, the nostril.
    d += 0.0008F * bell(p.folded, {0.0168F, -0.0375F, 0.0835F}, {0.0028F, 0.0070F, 0.0080F});
    return smoothMax(d, -ellipsoid(p.soft, {0.0060F, -0.0480F, 0.0955F}, {0.0026F, 0.0024F, 0.0046F}), 0.0060F);
}

float joinMouth(float d, const MirroredPoint& p)
{
    if (p.plain.z < 0.030F || p.plain.y > -0.030F || p.plain.y < -0.110F)
        return d;
    const glm::vec3& soft = p.soft;
    const float x = soft.x;

    const float upper = roundCone(soft, {0.0050F, -0.0625F, 0.0890F}, {0.0240F, -0.0674F, 0.0752F}, 0.0064F, 0.0028F);
    const float lower = roundCone(soft, {0.0050F, -0.0742F, 0.0855F}, {0.0225F, -0.0700F, 0.0750F}, 0.0084F, 0.0034F);
    d = smoothMin(d, upper, 0.0090F);
    d = smoothMin(d, lower, 0.0090F);

    d += 0.0013F * bell(p.plain.y - seam(p), 0.0013F) * (1.0F - smoothStep(0.0185F, kMouthHalf, x));
    // The lips' borders: a fine ridge above, a shallow hollow below.
    d -= 0.0005F * bell(p.plain.y - upperBorder(p), 0.0018F) * (1.0F - smoothStep(0.012F, 0.025F, x));
    d += 0.0014F * bell(p.plain.y - hollowBelow(p), 0.0042F) * (1.0F - smoothStep(0.010F, 0.022F, x));
    // Corners and philtrum.
    d += 0.0014F * bell(p.folded, {0.0264F, -0.0684F, 0.0750F}, {0.0034F, 0.0036F, 0.0120F});
    return d + 0.0008F * bell(p.plain, {0.0F, -0.0545F, 0.0950F}, {0.0038F, 0.0065F, 0.0150F});
}

float lipsFraction(const MirroredPoint& p)
{
    constexpr float softness = 0.0011F;
    constexpr float borderWidth = 0.0006F; // The ridge itself is skin.
    constexpr float hollowReach = 0.0034F; // The lower lip ends above the hollow's middle.
    if (p.plain.z < 0.060F)
        return 0.0F;
    const float below = upperBorder(p) - p.plain.y - borderWidth;
    const float above = p.plain.y - hollowBelow(p) - hollowReach;
    const float inside = smoothStep(-softness, softness, std::min(below, above));
    return inside * (1.0F - smoothStep(kMouthHalf - 0.0050F, kMouthHalf, p.soft.x));
}

} // namespace hairpaint::heads
