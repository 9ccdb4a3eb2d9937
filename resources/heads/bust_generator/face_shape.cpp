// The face's bones and flesh, and the closed eyes.
#include "bust_shape.h"
#include "sdf_primitives.h"

namespace hairpaint::heads {

namespace {

float jaw(const glm::vec3& soft)
{
    const float body = roundCone(soft, {0.0365F, -0.0650F, 0.0080F}, {0.0130F, -0.0950F, 0.0690F}, 0.0150F, 0.0165F);
    const float ramus = roundCone(soft, {0.0450F, -0.0100F, 0.0020F}, {0.0365F, -0.0650F, 0.0080F}, 0.0160F, 0.0140F);
    return smoothMin(body, ramus, 0.020F);
}

float browBone(const glm::vec3& soft)
{
    const float inner = roundCone(soft, {0.0090F, 0.0180F, 0.0810F}, {0.0300F, 0.0240F, 0.0755F}, 0.0075F, 0.0075F);
    const float outer = roundCone(soft, {0.0300F, 0.0240F, 0.0755F}, {0.0490F, 0.0150F, 0.0520F}, 0.0075F, 0.0085F);
    return smoothMin(inner, outer, 0.014F);
}

// Soft relief where the eyebrows grow: highest at two thirds of the way out.
float browRelief(const glm::vec3& folded)
{
    const float x = folded.x;
    const float arch =
        0.0215F + 0.0070F * std::sin(glm::radians(90.0F) * std::clamp((x - 0.010F) / 0.026F, 0.0F, 1.6F));
    const float along = smoothStep(0.008F, 0.017F, x) * (1.0F - smoothStep(0.040F, 0.054F, x));
    const float front = smoothStep(0.035F, 0.055F, folded.z);
    return 0.0009F * bell(folded.y - arch, 0.0050F) * along * front;
}

} // namespace

float joinFace(float d, const MirroredPoint& p)
{
    const glm::vec3& soft = p.soft;
    // Middle of the face, jaw, the flesh under it, cheeks, chin.
    d = smoothMin(d, ellipsoid(p.plain, {0.0F, -0.0260F, 0.0320F}, {0.0565F, 0.0680F, 0.0550F}), 0.045F);
    d = smoothMin(d, jaw(soft), 0.036F);
    d = smoothMin(d, ellipsoid(p.plain, {0.0F, -0.0780F, 0.0350F}, {0.0380F, 0.0220F, 0.0450F}), 0.028F);
    d = smoothMin(d, ellipsoid(soft, {0.0315F, -0.0480F, 0.0490F}, {0.0250F, 0.0350F, 0.0300F}), 0.034F);
    d = smoothMin(d, ellipsoid(p.plain, {0.0F, -0.0980F, 0.0765F}, {0.0185F, 0.0150F, 0.0155F}), 0.036F);
    // Cheekbone and the arch that runs back from it.
    d = smoothMin(d, ellipsoid(soft, {0.0400F, -0.0250F, 0.0580F}, {0.0200F, 0.0170F, 0.0200F}), 0.030F);
    d = smoothMin(d, roundCone(soft, {0.0470F, -0.0200F, 0.0480F}, {0.0570F, -0.0100F, 0.0050F}, 0.0110F, 0.0100F),
                  0.036F);
    // The temple, without which the arch would stand out as a ridge.
    d = smoothMin(d, ellipsoid(soft, {0.0450F, 0.0080F, 0.0300F}, {0.0185F, 0.0300F, 0.0300F}), 0.030F);
    // Muzzle, brow, the hollow of the eye socket, the flesh over the upper lid.
    d = smoothMin(d, ellipsoid(p.plain, {0.0F, -0.0680F, 0.0660F}, {0.0290F, 0.0270F, 0.0285F}), 0.024F);
    d = smoothMin(d, browBone(soft), 0.034F);
    const glm::vec3 socket = turnedY(soft - glm::vec3(0.0335F, 0.0005F, 0.0890F), -20.0F);
    d = smoothMax(d, -ellipsoid(socket, glm::vec3(0.0F), {0.0195F, 0.0120F, 0.0120F}), 0.024F);
    d = smoothMin(d, roundCone(soft, {0.0190F, 0.0105F, 0.0725F}, {0.0400F, 0.0115F, 0.0675F}, 0.0055F, 0.0055F),
                  0.016F);
    return d - browRelief(p.folded);
}

float joinEyes(float d, const MirroredPoint& p)
{
    if (p.folded.z < 0.035F || std::abs(p.folded.y) > 0.045F)
        return d;
    // In the eye's frame x runs outward from the middle of the face, z out of the lid.
    const glm::vec3 q = turnedY(p.folded - glm::vec3(0.0317F, -0.0005F, 0.0665F), -8.0F);
    const float ball = ellipsoid(q, glm::vec3(0.0F), {0.0166F, 0.0146F, 0.0148F});
    d = smoothMin(d, ball, 0.0075F);

    // The lids meet in an arc that hangs below the ball's middle and ends in two corners, the outer a little higher.
    const float x = q.x - 0.0002F;
    const float half = 0.0158F;
    const float t = x / half;
    const float slit = -0.0068F + 0.0046F * t * t + 0.020F * x;
    const float above = q.y - slit;
    const float inFront = smoothStep(0.0F, 0.004F, q.z);
    const float along = (1.0F - smoothStep(0.0128F, 0.0172F, std::abs(x))) * inFront;
    d += 0.0012F * bell(above, 0.0017F) * along;
    // The upper lid lies over the lower one, its edge a little thicker.
    d -= 0.0005F * bell(above - 0.0031F, 0.0024F) * along;
    // The crease above the lid, and a trace of one below.
    const float arc = std::max(1.0F - 0.80F * t * t, 0.0F);
    const float creaseFade = (1.0F - smoothStep(0.0110F, 0.0180F, std::abs(x))) * inFront;
    d += 0.0010F * bell(above - 0.0030F - 0.0095F * arc, 0.0016F) * creaseFade;
    d += 0.0002F * bell(above + 0.0066F, 0.0026F) * creaseFade;
    // The inner corner is a small pit that points at the nose.
    const glm::vec3 inner(-0.0165F, -0.0026F, 0.0080F);
    return d + 0.0008F * bell(q, inner, {0.0034F, 0.0026F, 0.0060F});
}

} // namespace hairpaint::heads
